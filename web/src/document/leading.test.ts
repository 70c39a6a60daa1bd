import { expect, test } from "vitest";
import { leadingPoints } from "./leading";
import { matrixOf } from "./placement";

/** Six points of a ball with their normals. */
const WAYS = [1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1];
const mesh = { positions: new Float32Array(WAYS), normals: new Float32Array(WAYS) };
const matrix = matrixOf({ shift: [10, 0, 0] }) ?? [];

test("the points that go first are those that face the way, and the ends where there are any", () => {
  expect(leadingPoints({ mesh, matrix }, [1, 0, 0], 0, 100)).toEqual([[11, 0, 0]]);
  expect(leadingPoints({ mesh, matrix }, [0, 0.6, 0.8], 0, 100)).toEqual([
    [10, 1, 0],
    [10, 0, 1],
  ]);
  expect(leadingPoints({ mesh, matrix }, [0, 1, 0], 1, 100)).toEqual([
    [11, 0, 0],
    [10, 1, 0],
    [10, 0, -1],
  ]);
});

test("a part that is turned or mirrored faces as it stands, and of many points some are taken", () => {
  const turned = matrixOf({ axis: [0, 0, 1], angle: Math.PI / 2 }) ?? [];
  const [point] = leadingPoints({ mesh, matrix: turned }, [0, 1, 0], 0, 100);
  expect(point?.[0]).toBeCloseTo(0, 12);
  expect(point?.[1]).toBeCloseTo(1, 12);
  const mirrored = matrixOf({ scale: [-2, 1, 1] }) ?? [];
  expect(leadingPoints({ mesh, matrix: mirrored }, [1, 0, 0], 0, 100)).toEqual([[2, 0, 0]]);
  const many = { positions: new Float32Array(3000), normals: new Float32Array(3000).fill(1) };
  expect(leadingPoints({ mesh: many, matrix }, [1, 0, 0], 0, 100)).toHaveLength(100);
});
