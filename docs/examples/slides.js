import Reveal from "https://modules.example/reveal.js/dist/reveal.mjs";

await new Reveal({ embedded: false, hash: false, transition: "none" }).initialize();
