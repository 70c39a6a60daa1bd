/** The link of the pot, and one that is opened over unsaved work. */

import { phrases } from "../../language";

export const link = phrases("link", {
  heading: "The link of this pot",
  lead: "Your browser did not let the page copy it. Copy it from here:",
  link: "Link",
  leadView: "Whoever opens it sees this very pot, and as you see it now if you want.",
  withView: "With this view: where it is seen from, lines, cut and colours",
  copy: "Copy",
  copied: "Copied.",
  open: "Open this link?",
  differs: "This link differs from your unsaved work. Opening it can be undone as long as this page stays open.",
  differsFrom: (title: string) =>
    `This link differs from your unsaved work “${title}”. Opening it can be undone as long as this page stays open.`,
  keepMine: "Keep mine",
  openIt: "Open the link",
});
