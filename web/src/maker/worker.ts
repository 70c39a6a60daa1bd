/** The maker's worker. */

import init, { PasuError } from "pasu";
import { serve } from "../worker/serve";
import { buffersOf, perform } from "./perform";

serve(self, { init, PasuError, fault: "maker-unusable" }, perform, buffersOf);
