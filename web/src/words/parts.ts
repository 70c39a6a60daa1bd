/** What a part is called: its name, or its number where it has none. */

import { page } from "./english/page";

/** `place` counts from 0. */
export function partName(place: number, name: string | null | undefined): string {
  return name ?? page.part(place + 1);
}
