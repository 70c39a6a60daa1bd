/** Two parts of one name, told with both places. Comes with what reads files: nothing else has them. */

import { opening } from "./english/opening";
import { partName } from "./parts";
import { tellOf } from "./refusals";

/** Where the library says which part has the name. */
const EARLIER = /which is that of parts\[(\d+)\]$/;

tellOf({
  duplicate: ({ message }) => {
    const earlier = EARLIER.exec(message)?.[1];
    return earlier === undefined ? null : opening.nameTaken(partName(Number(earlier), null));
  },
});
