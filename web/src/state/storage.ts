/**
 * Where every piece of state is kept. A browser that refuses storage (private windows, full disks, policies) costs the
 * person the convenience and nothing else: every access is allowed to fail.
 */

import { FORMAT_NAMES } from "../document/format";
import type { Overlays, Session, ThemeChoice } from "./session";
import { NEW_SESSION, TABS, THEMES } from "./session";

export type Place = "link and browser" | "browser" | "nowhere";

/** The one table. What is kept in the link is written by the solver's own canonical form. */
export const KEPT: Readonly<Record<"design" | keyof Session, Place>> = {
  design: "link and browser",
  selection: "nowhere",
  hidden: "nowhere",
  tab: "browser",
  theme: "browser",
  overlays: "browser",
  unlocked: "browser",
  explain: "browser",
  compare: "nowhere",
  map: "nowhere",
  fill: "nowhere",
  export: "browser",
};

/** The design as last left in this browser. */
export interface Work {
  /** The document as JSON text: read through the same gate as a file. */
  readonly text: string;
  /** Its canonical link, empty when the design was not one that the solver accepts. */
  readonly link: string;
  /** Whether it differs from what was last opened or saved. */
  readonly unsaved: boolean;
  /** The document that it was opened as, where a reset leads. */
  readonly origin?: string;
}

/** The part of the Storage interface that is used, so that tests can pass a map and a broken disk. */
export interface Shelf {
  getItem(key: string): string | null;
  setItem(key: string, value: string): void;
}

const WORK_KEY = "pasu.work";
const SETTINGS_KEY = "pasu.settings";

/** The browser's storage, or null where even asking for it throws. */
export function browserShelf(): Shelf | null {
  try {
    return globalThis.localStorage;
  } catch {
    return null;
  }
}

export function keepWork(shelf: Shelf | null, work: Work): boolean {
  return write(shelf, WORK_KEY, JSON.stringify(work));
}

export function readWork(shelf: Shelf | null): Work | null {
  const kept = read(shelf, WORK_KEY);
  if (!isRecord(kept)) return null;
  const { text, link, unsaved, origin } = kept;
  if (typeof text !== "string" || typeof link !== "string" || typeof unsaved !== "boolean") return null;
  return { text, link, unsaved, ...(typeof origin === "string" && { origin }) };
}

export function keepSettings(shelf: Shelf | null, session: Session): boolean {
  const kept: Record<string, unknown> = {};
  for (const [key, value] of Object.entries(session)) {
    if (KEPT[key as keyof Session] === "browser") kept[key] = value;
  }
  return write(shelf, SETTINGS_KEY, JSON.stringify(kept));
}

/** The session as this browser left it; anything unreadable falls back to the default, field by field. */
export function readSettings(shelf: Shelf | null): Session {
  const kept = read(shelf, SETTINGS_KEY);
  if (!isRecord(kept)) return NEW_SESSION;
  return {
    ...NEW_SESSION,
    tab: oneOf(TABS, kept.tab, NEW_SESSION.tab),
    theme: oneOf<ThemeChoice>(THEMES, kept.theme, NEW_SESSION.theme),
    overlays: overlaysFrom(kept.overlays),
    explain: kept.explain === true,
    export: exportFrom(kept.export),
    unlocked: Array.isArray(kept.unlocked) ? kept.unlocked.filter((name) => typeof name === "string") : [],
  };
}

function overlaysFrom(kept: unknown): Overlays {
  if (!isRecord(kept)) return NEW_SESSION.overlays;
  const names = Object.keys(NEW_SESSION.overlays);
  const overlays = Object.fromEntries(names.map((name) => [name, kept[name] === true])) as unknown as Overlays;
  // A pot that is opened is whole.
  return { ...overlays, cut: false };
}

function exportFrom(kept: unknown): Session["export"] {
  const { format, shrinkage } = isRecord(kept) ? kept : {};
  return {
    format: oneOf(FORMAT_NAMES, format, NEW_SESSION.export.format),
    shrinkage: typeof shrinkage === "number" && shrinkage > 0 && shrinkage < 50 ? shrinkage : 0,
  };
}

function oneOf<T>(all: readonly T[], value: unknown, fallback: T): T {
  return all.find((candidate) => candidate === value) ?? fallback;
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function read(shelf: Shelf | null, key: string): unknown {
  try {
    const text = shelf?.getItem(key) ?? null;
    return text === null ? null : (JSON.parse(text) as unknown);
  } catch {
    return null;
  }
}

function write(shelf: Shelf | null, key: string, text: string): boolean {
  try {
    shelf?.setItem(key, text);
    return shelf !== null;
  } catch {
    return false;
  }
}
