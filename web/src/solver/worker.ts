/** The solver's worker. */

import init, { PasuError, widen } from "pasu/drawing";
import { serve } from "../worker/serve";
import { buffersOf, perform } from "./perform";

serve(self, { init, PasuError, fault: "solver-unusable", widen }, perform, buffersOf);
