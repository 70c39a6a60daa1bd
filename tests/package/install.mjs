// The npm package as a stranger gets it: packed, unpacked into a fresh project, used from there.

import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

export const ROOT = fileURLToPath(new URL("../..", import.meta.url));
const PACKAGE = join(ROOT, "crates/pasu-wasm/pkg");

/** Makes a project that depends on a package, the library where nothing else is said, and calls `use` with its folder. */
export async function inFreshProject(use, folder = PACKAGE) {
  const project = mkdtempSync(join(tmpdir(), "pasu-package-"));
  try {
    const packed = npm(["pack", "--json", "--pack-destination", project], folder);
    const [{ filename, name }] = JSON.parse(packed);
    const home = join(project, "node_modules", name);
    mkdirSync(home, { recursive: true });
    execFileSync("tar", ["-xzf", join(project, filename), "-C", home, "--strip-components", "1"]);
    writeFileSync(join(project, "package.json"), JSON.stringify({ private: true, type: "module" }));
    await use(project);
  } finally {
    rmSync(project, { recursive: true, force: true });
  }
}

function npm(args, cwd) {
  const windows = process.platform === "win32";
  return execFileSync(windows ? "npm.cmd" : "npm", args, {
    cwd,
    encoding: "utf8",
    shell: windows,
    stdio: ["ignore", "pipe", "ignore"],
  });
}
