/** What the page shows outside its components: its title and colours, and how far it is, for whoever watches from outside. */

import { effect } from "@preact/signals-core";
import { isolated } from "../language";
import { verticesOf } from "../solver/solved";
import { page } from "../words/english/page";
import type { Designer } from "../work/designer";

/** Keeps all of that up to date until what comes back is called; `app` carries the state. */
export function outward(designer: Designer, app: HTMLElement): () => void {
  const { store, surface } = designer;
  const leaving = [
    effect(() => {
      document.title = store.title === "" ? page.name : page.titled(isolated(store.title));
    }),
    effect(() => {
      const { theme } = store.session;
      if (theme === "auto") delete document.documentElement.dataset.theme;
      else document.documentElement.dataset.theme = theme;
    }),
    effect(() => {
      const { settled, shown, status } = surface;
      app.dataset.state = status === "starting" ? "solving" : status;
      app.dataset.fingerprint = settled?.solved.fingerprint ?? "";
      app.dataset.vertices = String(shown ? verticesOf(shown.solved.parts) : 0);
    }),
  ];
  return () => {
    for (const leave of leaving) leave();
  };
}
