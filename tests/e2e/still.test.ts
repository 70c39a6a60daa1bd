// A browser without WebGL2 shows a still picture, says so, and does everything else.

import { expect, test } from "vitest";
import { stay } from "../support/stay.ts";
import { COARSE } from "../support/visit.ts";

const here = stay({ webgl: false }, COARSE);

test("without WebGL2 there is a message and a picture that follows the parameters", async () => {
  const pot = await here.enter({ link: "#1/second-order" });
  const before = await pot.fingerprint();
  expect(await pot.page.getByText("This browser has no WebGL2").isVisible()).toBe(true);
  const still = pot.page.getByRole("img", { name: /vase|jar|bowl|bottle/i });
  const picture = () =>
    still.evaluate((canvas: HTMLCanvasElement) => {
      const data = canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height).data ?? [];
      let painted = 0;
      let sum = 0;
      for (let i = 3; i < data.length; i += 4) {
        if ((data[i] ?? 0) > 0) painted += 1;
        sum = (sum * 31 + (data[i - 1] ?? 0)) % 1_000_003;
      }
      return { covered: painted / (canvas.width * canvas.height), sum };
    });
  const first = await picture();
  expect(first.covered).toBeGreaterThan(0.05);
  await pot.drag("Rim radius", 0.9);
  const after = await pot.fingerprintOtherThan(before);
  await expect.poll(async () => (await picture()).sum).not.toBe(first.sum);
  await pot.undo();
  await pot.shows(before);
  await pot.redo();
  await pot.shows(after);
  expect((await pot.copyLink()).startsWith(`${here.site.url}#1/second-order?`)).toBe(true);
});
