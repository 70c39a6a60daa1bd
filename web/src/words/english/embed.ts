/** The dialogue that gives what to put into a page of one's own. */

import { phrases } from "../../language";

export const embed = phrases("embed", {
  heading: "Put the pot into a page",
  preview: "As it will be seen",
  alt: "What is seen, for people who do not see it",
  turns: "Turns by itself",
  parameters: "Sliders below it",
  element: "For a page that may have scripts",
  frame: "For a system that allows only frames",
  copy: "Copy",
  copyWhat: (what: string) => `Copy: ${what}`,
  copied: "Copied.",
  byHand: "Your browser did not let the page copy it. It is selected: copy it by hand.",
});
