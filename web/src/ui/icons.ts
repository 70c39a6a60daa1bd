/** The page's own icons: 24 by 24, one stroke. Always decoration beside a name. */

import { html, type TemplateResult } from "lit";

const PATHS = {
  undo: "M4 9h10.5a5.5 5.5 0 0 1 0 11H11M8.5 4.5 4 9l4.5 4.5",
  redo: "M20 9H9.5a5.5 5.5 0 0 0 0 11H13M15.5 4.5 20 9l-4.5 4.5",
  add: "M12 5v14M5 12h14",
  chance: "M4.5 4.5h15v15h-15zM8.5 8.5h.01M12 12h.01M15.5 15.5h.01",
  mix: "M9 6.5a5.5 5.5 0 1 0 0 11 5.5 5.5 0 0 0 0-11M15 6.5a5.5 5.5 0 1 1 0 11 5.5 5.5 0 0 1 0-11",
  compare: "M8 5.5v13L3.5 16V8zM16 5.5v13l4.5-2.5V8M12 3.5v17",
  less: "M5 12h14",
  up: "M12 19V5.5M6 11.5l6-6 6 6",
  down: "M12 5v13.5M6 12.5l6 6 6-6",
  copy: "M9 9h11v11H9zM5.5 15H4V4h11v1.5",
  remove: "M4.5 7h15M9.5 7V4.5h5V7M6.5 7l1 13h9l1-13M10.5 10.5v6M13.5 10.5v6",
  seen: "M2.5 12c5-8.5 14-8.5 19 0-5 8.5-14 8.5-19 0zM12 9a3 3 0 1 0 0 6 3 3 0 0 0 0-6",
  hidden:
    "M4 4l16 16M9.5 5.9c4.6-1.2 9 .9 12 6.1-.8 1.4-1.7 2.6-2.7 3.6M6 8c-1.3 1-2.5 2.3-3.5 4 3.2 5.4 8 7.5 13 5.8M10 10a3 3 0 0 0 4 4.2",
  gallery: "M4 4h6v6H4zM14 4h6v6h-6zM4 14h6v6H4zM14 14h6v6h-6z",
  shelf:
    "M3.5 20.5h17M3.5 12h17M6 12c-1-3 0-4 .5-6h4c.5 2 1.5 3 .5 6M15 12V6.5h3.5V12M8 20.5v-5h4v5M15 20.5c-1-2-.5-3 0-5h3c.5 2 1 3 0 5",
  open: "M3 8V6a1 1 0 0 1 1-1h5l2 2h8a1 1 0 0 1 1 1v2M3 8v10a1 1 0 0 0 1 1h14l3-9H6l-3 8",
  save: "M12 4v11M7.5 11 12 15.5 16.5 11M5 19.5h14",
  link: "M10 14a4 4 0 0 0 5.7 0l3-3A4 4 0 0 0 13 5.3l-1 1M14 10a4 4 0 0 0-5.7 0l-3 3A4 4 0 0 0 11 18.7l1-1",
  share: "M12 15V4M8 7.5 12 3.5l4 4M7 11H5.5v9h13v-9H17",
  embed: "M8.5 7 3.5 12l5 5M15.5 7l5 5-5 5M13.6 4.5l-3.2 15",
  picture: "M4 5h16v14H4zM4 16l5-5 4 4 3-3 4 4M15.5 9.5h.01",
  make: "M4 20h16M7 20c-2-4-2-8 0-11l1-5h8l1 5c2 3 2 7 0 11M8.5 4c0 2 7 2 7 0",
  sun: "M12 8a4 4 0 1 0 0 8 4 4 0 0 0 0-8M12 2.5v2M12 19.5v2M2.5 12h2M19.5 12h2M5.3 5.3l1.4 1.4M17.3 17.3l1.4 1.4M5.3 18.7l1.4-1.4M17.3 6.7l1.4-1.4",
  moon: "M20 14.5A8.5 8.5 0 1 1 9.5 4a7 7 0 0 0 10.5 10.5z",
  auto: "M12 3.5a8.5 8.5 0 1 0 0 17zM12 3.5a8.5 8.5 0 0 1 0 17",
  help: "M9.2 9a2.9 2.9 0 1 1 4.1 2.7c-.9.4-1.3 1-1.3 2M12 17h.01M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18",
  locked: "M7 11V8a5 5 0 0 1 10 0v3M5.5 11h13v9h-13z",
  unlocked: "M7 11V8a5 5 0 0 1 9.6-2M5.5 11h13v9h-13z",
  layers: "M12 4 3.5 8.5 12 13l8.5-4.5zM3.5 13 12 17.5 20.5 13",
  pull: "M5 4c4 4 4 12 0 16M9 12h12M17.5 8.5 21 12l-3.5 3.5",
  move: "M12 3v18M3 12h18M9.5 5.5 12 3l2.5 2.5M9.5 18.5 12 21l2.5-2.5M5.5 9.5 3 12l2.5 2.5M18.5 9.5 21 12l-2.5 2.5",
  view: "M12 3.5 4.5 7.7v8.6L12 20.5l7.5-4.2V7.7zM4.5 7.7 12 12l7.5-4.3M12 12v8.5",
  fit: "M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5",
  close: "M6 6l12 12M18 6 6 18",
  slider: "M4 12h6.5M15.5 12H20M13 9.5a2.5 2.5 0 1 0 0 5 2.5 2.5 0 0 0 0-5",
  more: "M5.5 12h.01M12 12h.01M18.5 12h.01",
  paper: "M6 3.5h8l4 4v13H6zM14 3.5v4h4M9 12h6M9 16h6",
  reset: "M5 5v4h4M5.6 9A7.5 7.5 0 1 1 4.5 13",
  check: "M5 12.5 10 17.5 19.5 7",
  warn: "M12 4 2.5 20h19zM12 10v4.5M12 17.3h.01",
} as const;

export type IconName = keyof typeof PATHS;

export function icon(name: IconName): TemplateResult {
  return html`<svg class="icon" viewBox="0 0 24 24" aria-hidden="true" focusable="false"><path d=${PATHS[name]} /></svg>`;
}
