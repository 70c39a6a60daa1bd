/** Which parameters an element shows, as its page names them. */

import { pathText } from "../../document/path";
import { type Family, type Field, familyOf } from "../../document/schema";
import type { Design, Refusal } from "../../document/types";
import { listed } from "../../language";
import { pot } from "../../words/english/pot";

/** The first part is the one that is changed. */
export function familyIn(design: Design): Family | null {
  const part = design.parts[0];
  return part ? familyOf(part.shape.kind) : null;
}

/**
 * The parameters of a list of names, in its order. A parameter is named as in documents (`height`, `r[0]`), by its key (`r-0`), or by the symbol of the
 * paper without its line below (`r1`). What the shape does not have is left out and told to `unknown`.
 */
export function shownFields(design: Design, names: string, unknown: (refusal: Refusal) => void): readonly Field[] {
  const family = familyIn(design);
  const shown: Field[] = [];
  for (const name of namesIn(names)) {
    const field = family?.fields.find((each) => namesOf(each).includes(name)) ?? bySymbol(family, name);
    if (!field) unknown({ code: "unknown-name", path: "controls", message: refusalOf(name, family) });
    else if (!shown.includes(field)) shown.push(field);
  }
  return shown;
}

/** The list of names in an attribute. */
export function namesIn(names: string): readonly string[] {
  return names.split(/[\s,]+/).filter((name) => name !== "");
}

function namesOf(field: Field): readonly string[] {
  return [pathText(field.path), field.key];
}

function bySymbol(family: Family | null, name: string): Field | undefined {
  return family?.fields.find(({ symbol }) => symbol.replaceAll("_", "") === name);
}

function refusalOf(name: string, family: Family | null): string {
  return family ? pot.noControl(name, listed(family.fields.map(({ path }) => pathText(path)))) : pot.noControls(name);
}
