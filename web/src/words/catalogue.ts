/**
 * Everything that the page says. English stands in `english/`, a file for whatever is fetched together, so that nobody waits for the sentences of a dialogue that is shut. Another
 * language is one file with all of it, `Catalogue` by type, and a line in `languages.ts`.
 */

import type { beginnings } from "./english/beginnings";
import type { blends } from "./english/blends";
import type { comparing } from "./english/comparing";
import type { controls } from "./english/controls";
import type { description } from "./english/description";
import type { drawing } from "./english/drawing";
import type { embed } from "./english/embed";
import type { equation } from "./english/equation";
import type { exporting } from "./english/export";
import type { freeing } from "./english/freeing";
import type { gallery } from "./english/gallery";
import type { help } from "./english/help";
import type { link } from "./english/link";
import type { look } from "./english/look";
import type { making } from "./english/making";
import type { maps } from "./english/maps";
import type { measures } from "./english/measures";
import type { modes } from "./english/modes";
import type { networks } from "./english/networks";
import type { octants } from "./english/octants";
import type { orders } from "./english/orders";
import type { page } from "./english/page";
import type { parameters } from "./english/parameters";
import type { parts } from "./english/parts";
import type { picture } from "./english/picture";
import type { placing } from "./english/placing";
import type { pot } from "./english/pot";
import type { profile } from "./english/profile";
import type { pull } from "./english/pull";
import type { quantities } from "./english/quantities";
import type { refusals } from "./english/refusals";
import type { report } from "./english/report";
import type { rings } from "./english/rings";
import type { scan } from "./english/scan";
import type { shelf } from "./english/shelf";
import type { size } from "./english/size";
import type { wall } from "./english/wall";
import type { water } from "./english/water";
import type { wedging } from "./english/wedging";

export interface Catalogue {
  readonly beginnings: typeof beginnings;
  readonly blends: typeof blends;
  readonly comparing: typeof comparing;
  readonly controls: typeof controls;
  readonly description: typeof description;
  readonly drawing: typeof drawing;
  readonly embed: typeof embed;
  readonly equation: typeof equation;
  readonly exporting: typeof exporting;
  readonly freeing: typeof freeing;
  readonly gallery: typeof gallery;
  readonly help: typeof help;
  readonly link: typeof link;
  readonly look: typeof look;
  readonly making: typeof making;
  readonly maps: typeof maps;
  readonly measures: typeof measures;
  readonly modes: typeof modes;
  readonly networks: typeof networks;
  readonly octants: typeof octants;
  readonly orders: typeof orders;
  readonly page: typeof page;
  readonly parameters: typeof parameters;
  readonly parts: typeof parts;
  readonly picture: typeof picture;
  readonly placing: typeof placing;
  readonly pot: typeof pot;
  readonly profile: typeof profile;
  readonly pull: typeof pull;
  readonly quantities: typeof quantities;
  readonly refusals: typeof refusals;
  readonly report: typeof report;
  readonly rings: typeof rings;
  readonly scan: typeof scan;
  readonly shelf: typeof shelf;
  readonly size: typeof size;
  readonly wall: typeof wall;
  readonly water: typeof water;
  readonly wedging: typeof wedging;
}
