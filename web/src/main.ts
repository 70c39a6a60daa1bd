/** Starts the page, in the language that it is to speak: the shell at once, the solver and the renderer beside each other. */

import "./app/pasu-app";
import type { PasuApp } from "./app/pasu-app";
import { spokenTag } from "./language";
import { SolverClient } from "./solver/client";
import { startWorker } from "./solver/start";
import { browserShelf, tabShelf } from "./state/storage";
import { saysView, VIEW_KEYS } from "./state/view-keys";
import { pictured } from "./sw/pictured";
import { onNewVersion } from "./sw/renewed";
import { choose } from "./words/languages";
import { Designer } from "./work/designer";
import { saveBlob } from "./work/files";
import { whenIdle } from "./work/idle";
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
        history.replaceState(null, "", link === "" ? location.pathname + location.search : `#${link}`);
      } catch {
        // Some browsers refuse after a hundred changes in half a minute: the next gesture writes the address again.
      }
    },
    whenIdle,
    download: saveBlob,
  });
  designer.connect();
  const app = document.createElement("pasu-app");
  app.designer = designer;
  document.querySelector(".skeleton")?.remove();
  document.body.append(app);
  void begin(designer, app);
  window.addEventListener("hashchange", () => void designer.opening.addressChanged());
  onNewVersion(() => designer.notices.announceNewVersion());
  const first = pictured(app);
  // Where these cannot be fetched the page works all the same: it is printed as it stands.
  first.then(() => import("./sw/register")).then(({ registerOffline }) => registerOffline(), ignored);
  first.then(() => import("./app/printed")).then(({ printed }) => printed(app, address), ignored);
}

async function begin({ opening }: Designer, app: PasuApp): Promise<void> {
  const { search, hash } = location;
  const seen = saysView(search);
  // From here on the person looks at the pot as they like, also after a reload.
  if (seen) history.replaceState(null, "", address() + hash);
  await opening.start();
  if (seen) await app.showViewed(search, hash);
}

/** Without the design, without the language that this person asked for, because whoever is given the address has their own, and without how it was looked at. */
function address(): string {
  const here = new URL(location.href);
  for (const key of ["lang", ...VIEW_KEYS]) if (here.searchParams.has(key)) here.searchParams.delete(key);
  return here.href.replace(/#.*$/s, "");
}

function ignored(): void {}
