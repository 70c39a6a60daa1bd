import type { ReactiveController } from "lit";
import { expect, test } from "vitest";
import type { Bench, Stage, Tool } from "../render/stage";
import { Lent } from "./lent";

/** A stage that keeps what it lends to. */
function stage() {
  const tools = new Set<Tool>();
  const lend = (take: (bench: Bench) => Tool) => {
    const tool = take({} as Bench);
    tools.add(tool);
    return { tool, giveBack: () => void tools.delete(tool) };
  };
  return { tools, stage: { lend } as unknown as Stage };
}

/** A component that does nothing but update, and what it has at work. */
function component() {
  const controllers: ReactiveController[] = [];
  const host = {
    stage: null as Stage | null,
    isConnected: true,
    addController: (controller: ReactiveController) => void controllers.push(controller),
    removeController: () => {},
    requestUpdate: () => {},
    updateComplete: Promise.resolve(true),
  };
  const taken: Tool[] = [];
  const lent = new Lent(
    host,
    () => ({}) as Tool,
    (tool) => taken.push(tool),
  );
  const update = (to: Stage | null) => {
    host.stage = to;
    for (const controller of controllers) controller.hostUpdate?.();
  };
  const connect = (isConnected: boolean) => {
    host.isConnected = isConnected;
    if (!isConnected) for (const controller of controllers) controller.hostDisconnected?.();
  };
  return { lent, taken, update, connect };
}

test("a tool is taken once, when there is a stage, and given back with it", () => {
  const { lent, taken, update } = component();
  const [one, other] = [stage(), stage()];
  update(null);
  expect(lent.tool).toBeNull();
  update(one.stage);
  update(one.stage);
  expect([...one.tools]).toEqual([lent.tool]);
  expect(taken).toEqual([lent.tool]);
  update(other.stage);
  expect(one.tools.size).toBe(0);
  expect([...other.tools]).toEqual([lent.tool]);
  expect(taken).toHaveLength(2);
  update(null);
  expect(lent.tool).toBeNull();
  expect(other.tools.size).toBe(0);
});

test("a component that is moved in the page gives its tool back and takes another", () => {
  const { lent, update, connect } = component();
  const one = stage();
  update(one.stage);
  const first = lent.tool;
  connect(false);
  expect(lent.tool).toBeNull();
  expect(one.tools.size).toBe(0);
  // An update that was under way takes nothing.
  update(one.stage);
  expect(one.tools.size).toBe(0);
  connect(true);
  update(one.stage);
  expect([...one.tools]).toEqual([lent.tool]);
  expect(lent.tool).not.toBe(first);
});
