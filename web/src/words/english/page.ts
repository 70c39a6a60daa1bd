/** The page around the pot: its bar, its tabs, the stage, and what is said for a moment. */

import { phrases, plural } from "../../language";
import type { Overlays, Tab, ThemeChoice } from "../../state/session";

export const page = phrases("page", {
  /** The name of the program is the same in every language. */
  name: "Pasu",
  titled: (title: string) => `${title} · Pasu`,
  skip: "Skip to the parameters",
  thePot: "The pot",
  parameters: "Parameters",
  drop: "Drop to open",
  dismiss: "Dismiss",
  undo: "Undo",
  redo: "Redo",
  undoKey: "Undo (Ctrl Z)",
  redoKey: "Redo (Ctrl Shift Z)",
  potStays: "Your pot stays as it is.",
  lastThatWorked: "The pot on the stage is the last one that worked.",
  newVersion: "A new version of Pasu is ready. Your pot is kept.",
  reload: "Reload",
  /** What a pot without a title is called, in its field, in its file and where it is shared. */
  untitled: "Untitled pot",
  pot: "Pot",
  aPot: "A pot",
  /** The pot that a new visitor sees. */
  firstPot: "Shoulder jar",
  part: (number: number) => `Part ${number}`,
  /** Where somebody might take hidden parts for parts that are gone. */
  hidden: (count: number) =>
    `${plural(count, { one: "One part is hidden.", other: `${count} parts are hidden.` })} What is hidden is still part of the design, of its measures and of its files.`,
  title: "Title",
  edited: "Edited",
  editedMeans: "Changed since it was opened or saved",
  commands: {
    new: "New",
    gallery: "Gallery",
    open: "Open",
    save: "Save",
    export: "Export",
    picture: "Picture",
    share: "Share",
    embed: "Embed",
    help: "Help",
    link: "Copy link",
  },
  more: "More",
  themes: {
    auto: "Colours follow the system",
    light: "Light colours",
    dark: "Dark colours",
  } satisfies Readonly<Record<ThemeChoice, string>>,
  pressToChange: (theme: string) => `${theme} (press to change)`,
  panels: "Panels",
  tabs: {
    shape: "Shape",
    profile: "Profile",
    order: "Order",
    look: "Look",
    wall: "Wall",
    measures: "Measures",
  } satisfies Readonly<Record<Tab, string>>,
  checking: "Checking…",
  /** How grave a sentence is, before it; for whoever hears it. */
  severities: { error: "Fault: ", warning: "Mind: " },

  stage: "3D view",
  stageKeys: "Arrow keys turn the pot, plus and minus zoom, F fits it to the view.",
  lost: "The graphics card was taken away for a moment. The picture comes back by itself.",
  lostForGood:
    "The graphics card was taken away and has not come back, so the pot stands still. Everything else works: change it, save it, share it.",
  tryAgain: "Try again",
  still: "This browser has no WebGL2, so the pot stands still. Everything else works: change it, save it, share it.",
  view: "View",
  views: { "three-quarter": "Three-quarter", front: "Front", side: "Side", top: "Top", below: "Below" },
  zoomOut: "Zoom out",
  zoomIn: "Zoom in",
  fit: "Fit to view",
  /** What a button does, and the key that does it too. */
  keyed: (label: string, key: string) => `${label} (${key})`,
  overlays: "Overlays",
  overlayNames: {
    isoU: "Lines round the pot (u)",
    isoV: "Lines up the wall (v)",
    wireframe: "Wireframe",
    boundary: "Rim, foot and tangents",
    axes: "Axes and dimensions",
    cut: "Cut open",
  } satisfies Readonly<Record<keyof Overlays, string>>,
  asItIs: "as it is",
  toCompare: "to compare",
  wallOnStage: (thickness: string) => `wall ${thickness}`,
  waterOnStage: "Water on the stage",

  linkCopied: "Link copied. Whoever opens it sees this very pot.",
  noSharing: "Sharing did not work here.",
  noLink: "There is no link yet: the design has a value that the solver cannot use.",
  savedAs: (name: string) => `Saved as “${name}”.`,
  notSaved: "Not saved: the design has a value that the solver cannot use.",
  notKept: "This browser keeps no copy of your work. Save it, or copy its link, before you leave.",
  unfetched: "This part of the page could not be fetched. Try again when there is a network.",
  noPictures: "Pictures need WebGL2, which this browser does not have.",
  pictureTooLarge: "The graphics card could not draw a picture of this size. Try a smaller one.",
  /** Of several files that were dropped. */
  quoted: (name: string) => `“${name}”`,
  opened: (name: string) => `Opened ${name}.`,
  noneOpened: (names: string) => `None of ${names} could be opened.`,
  notOpened: (names: string) => `${names} could not be opened.`,
  leftOut: (names: string) => `Not opened: ${names}, because one design is shown at a time.`,
  sentences: (all: readonly string[]) => all.join(" "),
});
