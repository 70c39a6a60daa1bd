/** What one number of a family is called, whichever family it is of. */

import type { FamilyKind, FieldKey } from "../document/field";
import { parameters } from "./english/parameters";

/** Its name and what it does. `key` is one of the keys of the family. */
export function fieldWords(kind: FamilyKind, key: string): { readonly name: string; readonly help: string } {
  const fields: Readonly<Record<string, { readonly name: string; readonly help: string }>> = parameters.fields[kind];
  return fields[key as FieldKey<typeof kind>] ?? { name: key, help: "" };
}
