import { expect, test } from "vitest";
import { realMaker } from "../../../testing/real-maker";
import { designOf } from "./exhibit";
import { OCTANTS } from "./octants";

/** `G(1 + 1/a)` where it is known without a table. */
const EIGHTH_OF_A_BALL = Math.PI / 6;

test.each(OCTANTS.map((exhibit) => [exhibit.id, exhibit] as const))(
  "%s is solid, and as large as it says",
  async (id, exhibit) => {
    const { maker } = realMaker({ free: true });
    const design = designOf(exhibit);
    const measured = await maker.ask({ kind: "measure", design, product: "pot", fill: null });
    if (measured.state !== "done") throw new Error(JSON.stringify(measured));
    const { parts, height } = measured.value;
    expect(parts.length).toBe(exhibit.parts ? 8 : 1);
    for (const part of parts) {
      const place = design.parts[0]?.place?.scale ?? [1, 1, 1];
      const box = Math.abs(place[0] * place[1] * place[2]);
      const volume = part.clay?.volume.value ?? 0;
      expect(volume).toBeGreaterThan(0);
      expect(volume).toBeLessThan(box);
      if (id === "own-octant-ball") expect(volume).toBeCloseTo(EIGHTH_OF_A_BALL * box, 9);
      if (id === "own-octant-facet") expect(volume).toBeCloseTo(box / 6, 9);
    }
    const tall = (exhibit.parts ? 2 : 1) * (design.parts[0]?.place?.scale?.[2] ?? 1);
    expect(height.value).toBeCloseTo(tall, 9);
  },
  60_000,
);
