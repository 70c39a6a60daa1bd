//! What is said of a link that was altered on its way.

use crate::error::{Code, Error};

/// A link that was one of Pasu's and has been altered on its way.
pub(super) fn damaged(what: &str) -> Error {
    let message =
        format!("This link is damaged or cut short ({what}); copy it once more, from its first to its last letter.");
    Error::new(Code::DamagedLink, "", message)
}
