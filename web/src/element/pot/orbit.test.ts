import { describe, expect, it } from "vitest";
import { orbitOf, orbitText, USUAL } from "./orbit";

describe("where the camera stands", () => {
  it("is read as it is written, in degrees, radians and shares", () => {
    expect(orbitOf("0deg 90deg 100%")).toEqual({ azimuth: -Math.PI / 2, polar: Math.PI / 2, share: 1 });
    expect(orbitOf(" 1rad  .5rad 250% ")).toEqual({ azimuth: 1 - Math.PI / 2, polar: 0.5, share: 2.5 });
  });

  it("is the usual where nothing or auto is said", () => {
    expect(orbitOf("auto auto auto")).toEqual(USUAL);
    expect(orbitOf("10deg")).toEqual({ ...USUAL, azimuth: -Math.PI / 2 + Math.PI / 18 });
  });

  it("stops at the poles", () => {
    expect(orbitOf("0deg 200deg").polar).toBe(Math.PI);
    expect(orbitOf("0deg -20deg").polar).toBe(0);
  });

  it("is refused in words when it is not written like that", () => {
    for (const text of [
      "",
      "10",
      "10deg 20deg 3m",
      "10deg 20deg 0%",
      "1deg 1deg 1% 1%",
      "9e999deg",
      "NaNdeg",
      "left",
    ]) {
      expect(() => orbitOf(text), text).toThrow(
        expect.objectContaining({
          code: "unreadable-orbit",
          path: "camera-orbit",
          message: expect.stringContaining(`“${text}”`),
        }),
      );
    }
  });

  it("is written as it is read, the short way round", () => {
    for (const text of ["31deg 65deg 100%", "-170deg 1.5deg 33.3%"]) expect(orbitText(orbitOf(text))).toBe(text);
    expect(orbitText(orbitOf("370deg 90deg 100%"))).toBe("10deg 90deg 100%");
  });
});
