import { PasuPotElement } from "https://pasu.example/pot/0.1/pasu-pot.js";

const told = document.querySelector("#told");
const pot = new PasuPotElement();
pot.alt = "A small vase with dints round its rim";
pot.src = "#1/bloor-wilson?n1=4";
pot.controls = "n1";
pot.addEventListener("load", ({ detail }) => {
  told.textContent = `${detail.design.parts[0].shape.n1} dints`;
});
pot.addEventListener("change", ({ detail }) => {
  told.textContent = `${detail.design.parts[0].shape.n1} dints: ${detail.link}`;
});
pot.addEventListener("error", ({ detail }) => {
  told.textContent = detail.message;
});
document.querySelector("main").append(pot);
