/** The page that shows one pot, for systems that allow only frames: the link after `#`, what else the element is told in the query. */

import { PasuPotElement } from "./element/pot/define";
import { pot as words } from "./words/english/pot";

/** The attributes that an address may set. */
const TOLD = ["alt", "camera-orbit", "auto-rotate", "controls", "ui", "theme"];

const pot = new PasuPotElement();
// The frame is as near the screen as its page decided.
pot.setAttribute("loading", "eager");
for (const [name, value] of new URLSearchParams(location.search))
  if (TOLD.includes(name)) pot.setAttribute(name, value);
const missing = document.createElement("p");
missing.textContent = words.noLink;
const follow = () => {
  pot.setAttribute("src", location.hash);
  // Without a link an element stays empty; nobody knows that of a frame.
  document.querySelector("main")?.replaceChildren(location.hash.length > 1 ? pot : missing);
};
window.addEventListener("hashchange", follow);
follow();
