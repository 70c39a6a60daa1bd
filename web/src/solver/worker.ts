/** The solver's worker. */

import init, { PasuError, widen } from "pasu/drawing";
import { serve } from "../worker/serve";
import { buffersOf, fetchPatchwork, perform } from "./perform";

/** With the module comes what asks it for shapes that the small one leaves out. */
const wider = async (source?: string) => {
  await Promise.all([widen(source), fetchPatchwork()]);
};

serve(self, { init, PasuError, fault: "solver-unusable", widen: wider }, perform, buffersOf);
