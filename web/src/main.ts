/** Starts the page, in the language that it is to speak: the shell at once, the solver and the renderer beside each other. */

import "./app/pasu-app";
import { spokenTag } from "./language";
import { SolverClient } from "./solver/client";
import { startWorker } from "./solver/start";
import { browserShelf, tabShelf } from "./state/storage";
import { pictured } from "./sw/pictured";
import { registerOffline } from "./sw/register";
import { choose } from "./words/languages";
import { Designer } from "./work/designer";
import { saveBlob } from "./work/files";
import { claimTab } from "./work/tab-lock";

const choosing = choose(new URLSearchParams(location.search).get("lang"), navigator.languages);
// English waits for nothing.
if (choosing) void choosing.then(start);
else start();

function start(): void {
  document.documentElement.lang = spokenTag();
  const designer = new Designer(new SolverClient(startWorker), {
    shelf: browserShelf(),
    tabShelf: tabShelf(),
    claim: claimTab,
    address,
    fragment: () => (location.hash.length > 1 ? location.hash : ""),
    writeFragment: (link) => {
      try {
        history.replaceState(null, "", `#${link}`);
      } catch {
        // Some browsers refuse after a hundred changes in half a minute: the next gesture writes the address again.
      }
    },
    download: saveBlob,
  });
  designer.connect();
  const app = document.createElement("pasu-app");
  app.designer = designer;
  document.querySelector(".skeleton")?.remove();
  document.body.append(app);
  void designer.opening.start();
  window.addEventListener("hashchange", () => void designer.opening.addressChanged());
  registerOffline(() => designer.notices.announceNewVersion(), pictured(app));
}

/** Without the design, and without the language that this person asked for: whoever is given the address has their own. */
function address(): string {
  const here = new URL(location.href);
  if (here.searchParams.has("lang")) here.searchParams.delete("lang");
  return here.href.replace(/#.*$/s, "");
}
