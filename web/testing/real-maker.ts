// The real maker for tests: its own client, and what its worker runs, at the two ends of a message channel.

import { readFile } from "node:fs/promises";
import init, { PasuError } from "pasu";
import { MakerClient } from "../src/maker/client";
import type { Answers, Kind, Request } from "../src/maker/messages";
import { buffersOf, perform } from "../src/maker/perform";
import { channelled } from "./channelled";

const bytes = readFile(new URL("../../crates/pasu-wasm/pkg/pasu_bg.wasm", import.meta.url));
const module = bytes.then((found) => WebAssembly.compile(found));

/** A maker and what it was asked; `dispose` it at the end of the test. */
export function realMaker(): { readonly maker: MakerClient; readonly asked: Request[] } {
  const asked: Request[] = [];
  const kit = { init, PasuError, fault: "This could not be made" };
  const start = () =>
    channelled<Request, Answers[Kind]>(kit, module, perform, buffersOf, (request) => asked.push(request));
  return { maker: new MakerClient(start), asked };
}
