/** The solver's worker. */

import init, { PasuError } from "pasu/drawing";
import { serve } from "../worker/serve";
import { buffersOf, perform } from "./perform";

serve(self, { init, PasuError, fault: "solver-unusable" }, perform, buffersOf);
