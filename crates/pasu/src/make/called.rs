//! What a part is called in a sentence.

use crate::design::Design;

/// `"Lid"`, or `part 2` of one without a name.
pub(super) fn called(design: &Design, part: usize) -> String {
    let name = design.parts().get(part).and_then(|part| part.name.as_deref());
    name.map_or_else(|| format!("part {}", part + 1), |name| format!("{name:?}"))
}
