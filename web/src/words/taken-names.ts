/** Two parts of one name, told with both places. Comes with what reads files: nothing else has them. */

import { opening } from "./english/opening";
import { partName } from "./parts";
import { tellOf, textOf } from "./refusals";

/** The place of the part that has the name. */
const EARLIER = /^parts\[(\d+)\]$/;

tellOf({
  duplicate: (refusal) => {
    const earlier = EARLIER.exec(textOf(refusal, "earlier") ?? "")?.[1];
    return earlier === undefined ? null : opening.nameTaken(partName(Number(earlier), null));
  },
});
