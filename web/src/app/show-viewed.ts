/** Shows a pot as the link that it was opened by says that it is to be looked at. Fetched where a link says so. */

import { effect, untracked } from "@preact/signals-core";
import { MAPS } from "../document/maps";
import { type Camera, readView } from "../state/viewed";
import { page } from "../words/english/page";
import type { Designer } from "../work/designer";

/** To be called when the page has begun; `fragment` is the design that the link had beside the view. */
export async function showViewed(
  designer: Designer,
  search: string,
  fragment: string,
  look: (camera: Camera) => void,
): Promise<void> {
  const { opening, store, surface } = designer;
  const { viewed, damaged } = readView(
    search,
    MAPS.map(({ name }) => name),
  );
  if (damaged) designer.notices.say(page.viewDamaged);
  const asked = await designer.solver.parse(fragment);
  if (asked.state !== "done") return;
  let over = false;
  const leave = effect(() => {
    const { settled } = surface;
    // Whether this or another pot is to be seen is still asked.
    if (over || settled?.design !== store.design || opening.conflict) return;
    over = true;
    queueMicrotask(() => leave());
    if (settled.solved.link !== asked.value.link) return;
    untracked(() => {
      const { map, overlays, camera } = viewed;
      const walled = store.design.parts.some(({ wall }) => wall);
      const there = map === null || MAPS.some(({ name, needsWall }) => name === map && (walled || !needsWall));
      designer.apply({
        undo: "none",
        session: { ...(overlays && { overlays }), ...(map !== undefined && there && { map }) },
      });
      if (camera) look(camera);
    });
  });
}
