/** What the element promises to the pages that it stands in: the very types of the package. */

export type { PasuPotElement as Contract, PotChange, PotOrbit, PotPicture, PotProblem } from "../../../pot/pasu-pot";
