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
    const { file, name } = packed(folder);
    const home = join(project, "node_modules", name);
    mkdirSync(home, { recursive: true });
    execFileSync("tar", ["-xzf", file, "-C", home, "--strip-components", "1"]);
    writeFileSync(join(project, "package.json"), JSON.stringify({ private: true, type: "module" }));
    await use(project);
  } finally {
    rmSync(project, { recursive: true, force: true });
  }
}

/** Packages that this process has packed, by their folders: to pack one takes longer than most of what is tried with it. */
const known = new Map();

function packed(folder) {
  const found = known.get(folder);
  if (found) return found;
  const place = mkdtempSync(join(tmpdir(), "pasu-packed-"));
  process.once("exit", () => rmSync(place, { recursive: true, force: true }));
  const [{ filename, name }] = JSON.parse(npm(["pack", "--json", "--pack-destination", place], folder));
  const made = { file: join(place, filename), name };
  known.set(folder, made);
  return made;
}

/** Runs a script of a fresh project and returns what it prints. */
export function run(project, name, text) {
  writeFileSync(join(project, name), text);
  return execFileSync(process.execPath, [name], { cwd: project, encoding: "utf8" });
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
