/** Numbers with their units. The space between them does not break. */

import { phrases, plural } from "../../language";

export const quantities = phrases("quantities", {
  units: { mm: "mm", cm: "cm", in: "in" },
  /** Squares of the same, and what curvatures are counted in. */
  squares: { mm: "mm²", cm: "cm²", in: "in²" },
  bent: { mm: "/mm", cm: "/cm", in: "/in" },
  bentTwice: { mm: "/mm²", cm: "/cm²", in: "/in²" },
  millilitres: "ml",
  litres: "l",
  grams: "g",
  kilograms: "kg",
  pounds: "lb",
  pixels: "px",
  customary: { ounce: "US\u00a0fl\u00a0oz", pint: "US\u00a0pt", gallon: "US\u00a0gal" },
  measured: (number: string, unit: string) => `${number}\u00a0${unit}`,
  /** Inside a sentence, which may break there. */
  spoken: (number: string, unit: string) => `${number} ${unit}`,
  angle: (degrees: string) => `${degrees}°`,
  percent: (number: string) => `${number}\u00a0%`,
  /** Inside a sentence that may be read aloud. */
  degrees: (count: number, text: string) => plural(count, { one: `${text} degree`, other: `${text} degrees` }),
  exact: "exact",
  within: (error: string) => `±\u00a0${error}`,
});
