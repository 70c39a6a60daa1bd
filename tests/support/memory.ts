// What the page holds: on the heaps of its two threads, in the solver's module and on the GPU.

import type { CDPSession } from "playwright-core";
import type { Visit } from "./visit.ts";

/** Bytes, after everything that can go has gone; and how many things there are on the GPU. */
export interface Holding {
  readonly pageHeap: number;
  readonly workerHeap: number;
  /** Arrays of both threads. */
  readonly arrays: number;
  readonly wasm: number;
  readonly gpuBytes: number;
  readonly gpuThings: number;
}

/** Puts the memory of the module where a debugger finds it. */
const SHOW_MEMORY = `{
  const { instantiate } = WebAssembly;
  WebAssembly.instantiate = async (...given) => {
    const made = await instantiate(...given);
    globalThis.pasuMemory = (made.instance ?? made).exports.memory;
    return made;
  };
}
`;

interface Counted {
  pasuGpu: { readonly bytes: Map<object, number>; readonly things: Set<object> };
}

/** Follows what is made on the GPU, and lets the worker's memory be seen; to be called before the page opens. */
export async function watchMemory(pot: Visit): Promise<void> {
  await pot.context.route(/\/solver-[^/]*\.js$/, async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, body: SHOW_MEMORY + (await response.text()) });
  });
  await pot.context.addInitScript(() => {
    type Method = (this: WebGL2RenderingContext, ...parameters: unknown[]) => unknown;
    const gpu: Counted["pasuGpu"] = { bytes: new Map(), things: new Set() };
    (globalThis as unknown as Counted).pasuGpu = gpu;
    const methods = WebGL2RenderingContext.prototype as unknown as Record<string, Method>;
    const wrap = (name: string, around: (gl: WebGL2RenderingContext, made: unknown, given: unknown[]) => void) => {
      const real = methods[name] as Method;
      methods[name] = function (...given) {
        const made = real.apply(this, given);
        around(this, made, given);
        return made;
      };
    };
    for (const kind of ["Buffer", "Texture", "VertexArray", "Framebuffer", "Renderbuffer", "Program", "Shader"]) {
      wrap(`create${kind}`, (_, made) => gpu.things.add(made as object));
      wrap(`delete${kind}`, (_, __, [gone]) => {
        gpu.things.delete(gone as object);
        gpu.bytes.delete(gone as object);
      });
    }
    // Everything is made, filled and given up as ever; only the colours of pixels are not computed, those of the shadow neither: that leaves nothing behind, and is half of the time in software.
    for (const name of ["drawElements", "drawArrays"]) methods[name] = () => {};
    wrap("fenceSync", (_, made) => gpu.things.add(made as object));
    wrap("deleteSync", (_, __, [gone]) => gpu.things.delete(gone as object));
    wrap("bufferData", (gl, _, [target, data]) => {
      const index = target === gl.ELEMENT_ARRAY_BUFFER;
      const buffer = gl.getParameter(index ? gl.ELEMENT_ARRAY_BUFFER_BINDING : gl.ARRAY_BUFFER_BINDING);
      if (buffer) gpu.bytes.set(buffer, typeof data === "number" ? data : (data as ArrayBufferView).byteLength);
    });
  });
}

/** Takes stock, after collecting what is garbage. */
export async function holding(pot: Visit): Promise<Holding> {
  const session = await pot.context.newCDPSession(pot.page);
  const page = await heap((method) => session.send(method) as Promise<unknown>);
  const worker = await ofWorker(session);
  await session.detach();
  const [thread] = pot.page.workers();
  if (!thread) throw new Error("there is no worker");
  const wasm = await thread.evaluate(
    () => (globalThis as unknown as { pasuMemory: WebAssembly.Memory }).pasuMemory.buffer.byteLength,
  );
  const gpu = await pot.page.evaluate(async () => {
    const { bytes, things } = (globalThis as unknown as Counted).pasuGpu;
    // A frame that is being timed has a fence until it is drawn, a second at most.
    const timed = () => [...things].some((thing) => thing instanceof WebGLSync);
    for (let look = 0; look < 60 && timed(); look += 1) await new Promise((resolve) => setTimeout(resolve, 50));
    return { gpuBytes: [...bytes.values()].reduce((sum, each) => sum + each, 0), gpuThings: things.size };
  });
  return { pageHeap: page.used, workerHeap: worker.used, arrays: page.arrays + worker.arrays, wasm, ...gpu };
}

interface Heap {
  readonly used: number;
  readonly arrays: number;
}

type Send = (method: "HeapProfiler.collectGarbage" | "Runtime.getHeapUsage") => Promise<unknown>;

async function heap(send: Send): Promise<Heap> {
  // The second time takes what finalizers of the first let go.
  await send("HeapProfiler.collectGarbage");
  await send("HeapProfiler.collectGarbage");
  const { usedSize, backingStorageSize } = (await send("Runtime.getHeapUsage")) as {
    usedSize: number;
    backingStorageSize: number;
  };
  return { used: usedSize, arrays: backingStorageSize };
}

/** The worker's own debugger, by way of the page's. */
async function ofWorker(session: CDPSession): Promise<Heap> {
  const attached = new Promise<string>((resolve) =>
    session.on("Target.attachedToTarget", ({ sessionId, targetInfo }) => {
      if (targetInfo.type === "worker") resolve(sessionId);
    }),
  );
  await session.send("Target.setAutoAttach", { autoAttach: true, waitForDebuggerOnStart: false, flatten: false });
  const sessionId = await attached;
  let id = 0;
  return await heap(async (method) => {
    id += 1;
    const mine = id;
    const answer = new Promise<unknown>((resolve) => {
      session.on("Target.receivedMessageFromTarget", (event) => {
        const message = JSON.parse(event.message) as { id?: number; result?: unknown };
        if (event.sessionId === sessionId && message.id === mine) resolve(message.result);
      });
    });
    await session.send("Target.sendMessageToTarget", { sessionId, message: JSON.stringify({ id: mine, method }) });
    return await answer;
  });
}
