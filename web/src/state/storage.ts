/**
 * Where every piece of state is kept. A browser that refuses storage (private windows, full disks, policies) costs the
 * person the convenience and nothing else: every access is allowed to fail.
 */

import { FORMAT_NAMES } from "../document/format";
import { MOST_ALLOWANCE, MOST_SHRINKAGE } from "../document/wedging";
import { isRecord } from "./record";
import type { Overlays, Session, ThemeChoice } from "./session";
import { NEW_SESSION, TABS, THEMES } from "./session";
import { type Steps, stepsFrom } from "./steps";

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
  locked: "nowhere",
  pulling: "nowhere",
  placing: "nowhere",
  handling: "nowhere",
  snapping: "browser",
  inside: "nowhere",
  allowance: "browser",
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

/** The work of one tab, by the tab's name. */
export interface KeptWork {
  readonly tab: string;
  readonly work: Work;
  /** When it was kept, in milliseconds since 1970. */
  readonly at: number;
}

/** The part of the Storage interface that is used, so that tests can pass a map and a broken disk. */
export interface Shelf {
  getItem(key: string): string | null;
  setItem(key: string, value: string): void;
  removeItem(key: string): void;
  readonly length: number;
  key(index: number): string | null;
}

/** Followed by the name of the tab: each has its own, so that two never write over each other. */
const WORK_KEY = "pasu.work.";
/** Where the one and only work was kept before. */
const OLD_WORK_KEY = "pasu.work";
/** By this name it is found again; the tab that goes on with it has the name then. */
const OLD_TAB = "old";
/** Followed by what identifies a piece of the shelf: whoever writes one touches no other. */
const PIECE_KEY = "pasu.piece.";
const TAB_KEY = "pasu.tab";
const STEPS_KEY = "pasu.steps";
/** So many works of closed tabs are kept that are in a file or in a link anyway. */
const MOST_SAVED = 12;
const SETTINGS_KEY = "pasu.settings";

/** The browser's storage, or null where even asking for it throws. */
export function browserShelf(): Shelf | null {
  try {
    return globalThis.localStorage;
  } catch {
    return null;
  }
}

/** What only this tab sees, as long as it is open, through reloads; null where even asking for it throws. */
export function tabShelf(): Shelf | null {
  try {
    return globalThis.sessionStorage;
  } catch {
    return null;
  }
}

export function keepWork(shelf: Shelf | null, tab: string, work: Work, at = Date.now()): boolean {
  return write(shelf, keyOf(tab), JSON.stringify({ ...work, at }));
}

export function readWork(shelf: Shelf | null, tab: string): Work | null {
  return readKept(shelf, tab)?.work ?? null;
}

export function forgetWork(shelf: Shelf | null, tab: string): void {
  remove(shelf, keyOf(tab));
}

/** The works of all tabs, open or closed, the one kept last first. */
export function allWork(shelf: Shelf | null): readonly KeptWork[] {
  const tabs = keysOf(shelf, WORK_KEY).map((key) => key.slice(WORK_KEY.length));
  return [...tabs, OLD_TAB]
    .flatMap((tab) => readKept(shelf, tab) ?? [])
    .sort((a, b) => b.at - a.at || (a.tab < b.tab ? -1 : 1));
}

/** Forgets the oldest works that are in a file or in somebody's link, or were only looked at. What is nowhere else stays for good. */
export function forgetOldWork(shelf: Shelf | null): void {
  const saved = allWork(shelf).filter(({ work }) => !work.unsaved);
  for (const { tab } of saved.slice(MOST_SAVED)) forgetWork(shelf, tab);
}

/** The name of this tab, as it was given to it; null for a new one. */
export function readTab(shelf: Shelf | null): string | null {
  const name = read(shelf, TAB_KEY);
  return typeof name === "string" && name !== "" ? name : null;
}

export function keepTab(shelf: Shelf | null, name: string): boolean {
  return write(shelf, TAB_KEY, JSON.stringify(name));
}

/** A design that a person saved in this browser. */
export interface Piece {
  readonly id: string;
  /** The document as JSON text: read through the same gate as a file. */
  readonly text: string;
  /** When it was last changed, in milliseconds since 1970. */
  readonly at: number;
}

export function keepPiece(shelf: Shelf | null, { id, text, at }: Piece): boolean {
  return write(shelf, PIECE_KEY + id, JSON.stringify({ text, at }));
}

export function forgetPiece(shelf: Shelf | null, id: string): void {
  remove(shelf, PIECE_KEY + id);
}

/** All that look like pieces, the one changed last first. */
export function readPieces(shelf: Shelf | null): readonly Piece[] {
  const pieces = keysOf(shelf, PIECE_KEY).flatMap((key): readonly Piece[] => {
    const kept = read(shelf, key);
    if (!isRecord(kept) || typeof kept.text !== "string") return [];
    const { text, at } = kept;
    // A date can be made of every number up to this.
    const dated = typeof at === "number" && Math.abs(at) <= 8.64e15 ? at : 0;
    return [{ id: key.slice(PIECE_KEY.length), text, at: dated }];
  });
  return pieces.sort((a, b) => b.at - a.at || (a.id < b.id ? -1 : 1));
}

/** Whether a change that another tab made is one of the pieces, or of everything. */
export function concernsPieces(key: string | null): boolean {
  return key === null || key.startsWith(PIECE_KEY);
}

function keyOf(tab: string): string {
  return tab === OLD_TAB ? OLD_WORK_KEY : WORK_KEY + tab;
}

function readKept(shelf: Shelf | null, tab: string): KeptWork | null {
  const kept = read(shelf, keyOf(tab));
  if (!isRecord(kept)) return null;
  const { text, link, unsaved, origin, at } = kept;
  if (typeof text !== "string" || typeof link !== "string" || typeof unsaved !== "boolean") return null;
  const work = { text, link, unsaved, ...(typeof origin === "string" && { origin }) };
  return { tab, work, at: typeof at === "number" ? at : 0 };
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
    allowance: percentage(kept.allowance, MOST_ALLOWANCE) ?? NEW_SESSION.allowance,
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
    shrinkage: percentage(shrinkage, MOST_SHRINKAGE) ?? 0,
  };
}

/** A number from 0 to less than another; null for anything else. */
function percentage(value: unknown, below: number): number | null {
  return typeof value === "number" && value >= 0 && value < below ? value : null;
}

function oneOf<T>(all: readonly T[], value: unknown, fallback: T): T {
  return all.find((candidate) => candidate === value) ?? fallback;
}

function read(shelf: Shelf | null, key: string): unknown {
  try {
    const text = shelf?.getItem(key) ?? null;
    return text === null ? null : (JSON.parse(text) as unknown);
  } catch {
    return null;
  }
}

function keysOf(shelf: Shelf | null, prefix: string): readonly string[] {
  try {
    const keys = Array.from({ length: shelf?.length ?? 0 }, (_, index) => shelf?.key(index) ?? "");
    return keys.filter((key) => key.startsWith(prefix));
  } catch {
    return [];
  }
}

function remove(shelf: Shelf | null, key: string): void {
  try {
    shelf?.removeItem(key);
  } catch {
    // What cannot be reached cannot be forgotten either.
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

export function keepSteps(tabShelf: Shelf | null, steps: Steps): boolean {
  return write(tabShelf, STEPS_KEY, JSON.stringify(steps));
}

export function readSteps(tabShelf: Shelf | null): Steps | null {
  try {
    return stepsFrom(tabShelf?.getItem(STEPS_KEY) ?? null);
  } catch {
    return null;
  }
}
