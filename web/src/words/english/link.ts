/** The link of the pot, and one that is opened over unsaved work. */

import { phrases } from "../../language";

export const link = phrases("link", {
  heading: "The link of this pot",
  lead: "Your browser did not let the page copy it. Copy it from here:",
  link: "Link",
  open: "Open this link?",
  differs: "This link differs from your unsaved work. Opening it can be undone as long as this page stays open.",
  differsFrom: (title: string) =>
    `This link differs from your unsaved work “${title}”. Opening it can be undone as long as this page stays open.`,
  keepMine: "Keep mine",
  openIt: "Open the link",
});
