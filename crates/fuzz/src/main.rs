//! Looks at inputs: those of libFuzzer when compiled with its coverage (`cargo xtask fuzz`), else the files that are named.

#![cfg_attr(fuzzing, no_main)]
// The macros of libfuzzer-sys define what its C++ calls.
#![cfg_attr(fuzzing, allow(unsafe_code, missing_docs))]

#[cfg(not(fuzzing))]
use std::process::ExitCode;

#[cfg(not(fuzzing))]
fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let Some(target) = arguments.next().and_then(|name| fuzz::Target::named(&name)) else {
        eprintln!("fuzz <document | link | file | calls> <file>..: looks at each file as an input");
        return ExitCode::FAILURE;
    };
    for path in arguments {
        match std::fs::read(&path) {
            Ok(input) => println!("{path}: {}", if target.judge(&input) { "answered" } else { "refused" }),
            Err(error) => {
                eprintln!("{path}: {error}");
                return ExitCode::FAILURE;
            }
        }
    }
    ExitCode::SUCCESS
}

#[cfg(fuzzing)]
mod guided {
    //! One program for all targets, because they take a quarter of an hour to compile; `xtask` says by the environment which it is to be.

    use std::path::Path;
    use std::sync::LazyLock;

    use fuzz::{Random, Target};

    static TARGET: LazyLock<Target> = LazyLock::new(|| {
        let name = std::env::var("PASU_FUZZ_TARGET").unwrap_or_default();
        Target::named(&name).unwrap_or_else(|| panic!("PASU_FUZZ_TARGET is {name:?}"))
    });

    static SEEDS: LazyLock<Vec<Vec<u8>>> = LazyLock::new(|| TARGET.seeds());

    /// Of so many changes one is libFuzzer's own, of bytes; it also gives what comparisons of the program were looking for.
    const BYTES: usize = 4;

    /// Writes the seeds where inputs are read from.
    fn sow() {
        let folder = std::env::var("PASU_FUZZ_SEEDS").unwrap_or_default();
        std::fs::create_dir_all(&folder).unwrap_or_else(|error| panic!("{folder}: {error}"));
        for (i, seed) in SEEDS.iter().enumerate() {
            let path = Path::new(&folder).join(format!("seed-{i}"));
            std::fs::write(&path, seed).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        }
    }

    libfuzzer_sys::fuzz_target!(init: sow(), |input: &[u8]| {
        TARGET.judge(input);
    });

    libfuzzer_sys::fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
        let mut random = Random::new(u64::from(seed));
        if random.chance(BYTES) {
            return libfuzzer_sys::fuzzer_mutate(data, size, max_size);
        }
        let mutated = TARGET.mutated(&data[..size], &SEEDS, &mut random);
        let length = mutated.len().min(max_size);
        data[..length].copy_from_slice(&mutated[..length]);
        length
    });
}
