/** The page that shows one pot, for systems that allow only frames: the link after `#`, what else the element is told in the query. */

import { PasuPotElement } from "./element/pot/define";

/** The attributes that an address may set. */
const TOLD = ["alt", "camera-orbit", "auto-rotate", "controls", "ui", "theme"];

const pot = new PasuPotElement();
// The frame is as near the screen as its page decided.
pot.setAttribute("loading", "eager");
for (const [name, value] of new URLSearchParams(location.search))
  if (TOLD.includes(name)) pot.setAttribute(name, value);
const follow = () => pot.setAttribute("src", location.hash);
window.addEventListener("hashchange", follow);
follow();
document.querySelector("main")?.replaceChildren(pot);
