/** What is said of what was typed where a number is wanted. */

import { isolated } from "../language";
import type { NumberProblem } from "../number";
import { controls } from "./english/controls";

export function numberProblemWords(problem: NumberProblem): string {
  return controls.typed[problem.code]("typed" in problem ? isolated(problem.typed) : "");
}
