//! The test runner of wasm-bindgen as a program of this workspace, so that nobody has to install one whose version
//! matches. Not a default member: it is built only when `cargo xtask test` runs the WebAssembly tests.

fn main() -> anyhow::Result<()> {
    wasm_bindgen_cli::wasm_bindgen_test_runner::run_cli_with_args(std::env::args_os())
}
