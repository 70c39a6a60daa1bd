// Changing a pot by its parameters: the surface follows, and every gesture can be taken back.

import { expect, test } from "vitest";
import { stay } from "../support/stay.ts";

const here = stay();
const VASE = "#1/second-order";

test("dragging a slider changes the mesh, and the whole drag is one step of undo", async () => {
  const pot = await here.enter({ link: VASE });
  const before = await pot.fingerprint();
  expect(await pot.history("Undo").isDisabled()).toBe(true);
  await pot.drag("Waist pull", 0.9);
  const after = await pot.fingerprintOtherThan(before);
  await pot.undo();
  await pot.shows(before);
  expect(await pot.history("Undo").isDisabled()).toBe(true);
  await pot.redo();
  await pot.shows(after);
  expect(await pot.history("Redo").isDisabled()).toBe(true);
});

test("the surface follows during the drag; the address waits for its end", async () => {
  const pot = await here.enter({ link: VASE });
  const before = await pot.fingerprint();
  const description = () => pot.page.locator("pasu-stage #description").innerText();
  const said = await description();
  await pot.drag("Height", 0.9, {
    held: async () => {
      await expect.poll(description).not.toBe(said);
      expect(await pot.address()).toBe(VASE);
    },
  });
  await pot.fingerprintOtherThan(before);
  await expect.poll(() => pot.address()).toMatch(/^#1\/second-order\?height=/);
});

test("a change made by keys can be taken back by keys", async () => {
  const pot = await here.enter({ link: VASE });
  const before = await pot.fingerprint();
  const value = async () => Number((await pot.field("Height").inputValue()).replace(",", "."));
  const start = await value();
  await pot.slider("Height").focus();
  await pot.page.keyboard.press("ArrowRight");
  const fine = (await value()) - start;
  expect(fine).toBeGreaterThan(0);
  await pot.page.keyboard.press("Shift+ArrowRight");
  expect(((await value()) - start) / fine).toBeCloseTo(11, 6);
  const after = await pot.fingerprintOtherThan(before);
  await pot.page.keyboard.press("Control+z");
  await pot.fingerprintOtherThan(after);
  await pot.page.keyboard.press("Control+z");
  await pot.shows(before);
  await pot.page.keyboard.press("Control+y");
  await pot.page.keyboard.press("Control+Shift+z");
  await pot.shows(after);
});

test("a typed value may leave the slider's range", async () => {
  const pot = await here.enter({ link: VASE });
  const before = await pot.fingerprint();
  const most = Number(await pot.slider("Rim radius").getAttribute("max"));
  await pot.type("Rim radius", String(3 * most));
  await pot.fingerprintOtherThan(before);
  expect(await pot.field("Rim radius").inputValue()).toBe(String(3 * most));
  await expect.poll(() => pot.address()).toContain(`r=${3 * most},`);
});

test("a comma is a decimal point", async () => {
  const pot = await here.enter({ link: VASE });
  const before = await pot.fingerprint();
  await pot.type("Height", "4,25");
  await pot.fingerprintOtherThan(before);
  expect(await pot.field("Height").inputValue()).toBe("4.25");
});

test("the wheel never changes a number", async () => {
  const pot = await here.enter({ link: VASE });
  const before = await pot.fingerprint();
  for (const control of [pot.field("Rim radius"), pot.slider("Rim radius")]) {
    await control.click();
    const value = await control.inputValue();
    const now = await pot.fingerprint();
    await control.hover();
    await pot.page.mouse.wheel(0, 40);
    // The panel scrolls instead: by then the wheel has been dealt with.
    await expect.poll(() => pot.page.locator("pasu-panel .body").evaluate((body) => body.scrollTop)).toBeGreaterThan(0);
    expect(await control.inputValue()).toBe(value);
    expect(await pot.fingerprint()).toBe(now);
    await pot.page.locator("pasu-panel .body").evaluate((body) => {
      body.scrollTop = 0;
    });
  }
  expect(before).not.toBe("");
});

test("double click and the reset button bring one number back", async () => {
  const pot = await here.enter({ link: VASE });
  const before = await pot.fingerprint();
  await pot.type("Height", "5");
  const higher = await pot.fingerprintOtherThan(before);
  await pot.type("Rim radius", "1.5");
  await pot.fingerprintOtherThan(higher);
  await pot.page.locator('pasu-number[data-field="r-0"] label').dblclick();
  await pot.shows(higher);
  await pot.button("Reset Height to 3.6 cm, as opened").click();
  await pot.shows(before);
});

test("an impossible value is explained beside its field and the last good surface stays", async () => {
  const pot = await here.enter({ link: VASE });
  const before = await pot.fingerprint();
  const vertices = await pot.app.getAttribute("data-vertices");
  await pot.type("Wall stiffness", "0");
  const field = pot.field("Wall stiffness");
  await expect.poll(() => field.getAttribute("aria-invalid")).toBe("true");
  await expect.poll(() => pot.app.getAttribute("data-state")).toBe("error");
  const why = await field.evaluate((input) => {
    const root = input.getRootNode() as ShadowRoot;
    return (input.getAttribute("aria-describedby") ?? "")
      .split(" ")
      .map((id) => root.getElementById(id)?.textContent ?? "")
      .join(" ");
  });
  expect(why).toMatch(/0/);
  expect(await pot.app.getAttribute("data-vertices")).toBe(vertices);
  expect(await pot.page.getByRole("alert").first().isVisible()).toBe(true);
  await pot.undo();
  await pot.shows(before);
  expect(await field.getAttribute("aria-invalid")).toBe("false");
  expect(await pot.page.getByRole("alert").count()).toBe(0);
});

test("what is no number is explained and changes nothing", async () => {
  const pot = await here.enter({ link: VASE });
  const before = await pot.fingerprint();
  await pot.type("Height", "high");
  expect(await pot.page.getByText("“high” is not a number.").isVisible()).toBe(true);
  expect(await pot.fingerprint()).toBe(before);
  await pot.type("Height", "3.7");
  await pot.fingerprintOtherThan(before);
  expect(await pot.page.getByText("is not a number").count()).toBe(0);
});

test("x and y go together until they are taken apart", async () => {
  const pot = await here.enter({ link: VASE });
  const before = await pot.fingerprint();
  const lock = pot.button("Waist pull: same in x and y");
  expect(await lock.getAttribute("aria-pressed")).toBe("true");
  await lock.click();
  await pot.type("Waist pull, in x", "0.1");
  const oval = await pot.fingerprintOtherThan(before);
  expect(await pot.field("Waist pull, in y").inputValue()).toBe("0.5");
  await lock.click();
  await pot.fingerprintOtherThan(oval);
  expect(await pot.field("Waist pull").count()).toBe(1);
});

test("the profile's handles move the boundary by hand and by keys", async () => {
  const pot = await here.enter({ link: "#1/fourth-order" });
  const before = await pot.fingerprint();
  await pot.tab("Profile");
  const handle = pot.button(/^Rim, moves both ways/);
  const box = await handle.boundingBox();
  expect(box).not.toBeNull();
  const [x, y] = [(box?.x ?? 0) + (box?.width ?? 0) / 2, (box?.y ?? 0) + (box?.height ?? 0) / 2];
  await pot.page.mouse.move(x, y);
  await pot.page.mouse.down();
  await pot.page.mouse.move(x + 10, y - 10, { steps: 4 });
  await pot.page.mouse.move(x + 20, y - 20, { steps: 4 });
  await pot.page.mouse.up();
  const dragged = await pot.fingerprintOtherThan(before);
  const slope = pot.button(/^Slope at the rim/);
  await slope.focus();
  await pot.page.keyboard.press("ArrowLeft");
  await pot.fingerprintOtherThan(dragged);
  await pot.undo();
  await pot.shows(dragged);
  await pot.undo();
  await pot.shows(before);
});

test("a design goes from second to mixed to fourth order, and back by undo", async () => {
  const pot = await here.enter({ link: VASE });
  const before = await pot.fingerprint();
  await pot.tab("Equation");
  await pot.button("Show side by side with Mixed order").click();
  await pot.page.getByText("to compare").waitFor();
  expect(await pot.fingerprint()).toBe(before);
  await pot.button("Stop comparing with Mixed order").click();
  await expect.poll(() => pot.page.getByText("to compare").count()).toBe(0);
  await pot.button("Switch to Mixed order").click();
  const mixed = await pot.fingerprintOtherThan(before);
  await expect.poll(() => pot.address()).toMatch(/^#1\/mixed-order/);
  await pot.button("Switch to Fourth order").click();
  await pot.fingerprintOtherThan(mixed);
  await expect.poll(() => pot.address()).toMatch(/^#1\/fourth-order/);
  await pot.undo();
  await pot.shows(mixed);
  await pot.undo();
  await pot.shows(before);
});

test("where the commands stand beside the title it is read to its end, and that it was changed", async () => {
  const pot = await here.enter({ link: "#1/bloor-wilson?n1=5" });
  await pot.fingerprint();
  await pot.page.getByRole("textbox", { name: "Title" }).fill("Jug with five dints");
  await pot.page.keyboard.press("Tab");
  const cut = () =>
    pot.page.locator("pasu-top-bar").evaluate((bar) => {
      const all = [...(bar.shadowRoot?.querySelectorAll(".title, .unsaved") ?? [])];
      return all.map((each) => each.scrollWidth - each.clientWidth);
    });
  for (const width of [1081, 1100, 1121, 1180, 1280, 1281, 1345, 1440]) {
    await pot.page.setViewportSize({ width, height: 700 });
    await expect.poll(cut, { message: `${width} wide` }).toEqual([0, 0]);
  }
});
