//! The machine and the versions that figures belong to.

use std::process::Command;

use anyhow::Result;

use super::runner::Runner;
use crate::workspace::Workspace;
use crate::{browser, command};

/// What was measured on, as pairs of a name and a text.
pub(crate) struct Machine {
    facts: Vec<(&'static str, String)>,
}

impl Machine {
    /// This machine, with the versions of what the runners run in; `load` is what [`load`] said before anything was measured.
    pub(crate) fn this(workspace: &Workspace, runners: &[Runner], load: Option<String>) -> Result<Machine> {
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        let mut facts = vec![("processor", format!("{}, {cores} cores", processor()))];
        facts.extend(load.map(|load| ("programs running beforehand, in the mean of a minute", load)));
        let mut ask = |name, program: &std::ffi::OsStr| -> Result<()> {
            let said = command::read(Command::new(program).arg("--version").current_dir(workspace.root()))?;
            facts.push((name, said.lines().next().unwrap_or_default().trim().to_owned()));
            Ok(())
        };
        ask("rustc", "rustc".as_ref())?;
        if runners.contains(&Runner::Node) {
            ask("Node", "node".as_ref())?;
        }
        if runners.contains(&Runner::Chromium) {
            ask("browser", browser::ensure(workspace)?.as_os_str())?;
        }
        Ok(Machine { facts })
    }

    /// One line for each fact.
    pub(crate) fn lines(&self) -> Vec<String> {
        self.facts.iter().map(|(name, text)| format!("{name}: {text}")).collect()
    }
}

/// The load average, where the system tells it: figures from a busy machine are not worth much.
pub(crate) fn load() -> Option<String> {
    let told = std::fs::read_to_string("/proc/loadavg").ok()?;
    told.split_whitespace().next().map(str::to_owned)
}

/// The name of the processor, where the system tells it.
fn processor() -> String {
    let linux = || {
        let told = std::fs::read_to_string("/proc/cpuinfo").ok()?;
        model_name(&told)
    };
    let mac = || {
        let told = command::read(Command::new("sysctl").args(["-n", "machdep.cpu.brand_string"])).ok()?;
        Some(told.trim().to_owned())
    };
    linux()
        .or_else(mac)
        .or_else(|| std::env::var("PROCESSOR_IDENTIFIER").ok())
        .unwrap_or_else(|| std::env::consts::ARCH.to_owned())
}

fn model_name(cpuinfo: &str) -> Option<String> {
    let line = cpuinfo.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

#[cfg(test)]
mod tests {
    use super::model_name;

    #[test]
    fn the_processor_is_found() {
        let told = "processor\t: 0\nmodel name\t: AMD EPYC\nprocessor\t: 1\n";
        assert_eq!(model_name(told).as_deref(), Some("AMD EPYC"));
        assert_eq!(model_name("nothing"), None);
    }
}
