//! Why something holds no water.

use super::cause::Cause;
use crate::error::{Args, Error};

/// The reason, in words and for whoever says it in others.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Dry {
    pub(crate) message: String,
    pub(crate) cause: Cause,
}

impl Dry {
    /// A reason of its own, by its code.
    pub(crate) fn new(code: &'static str, message: &str) -> Dry {
        Dry { message: message.to_owned(), cause: Cause { code, path: None, args: Args::new() } }
    }
}

/// What keeps it from being a pot.
impl From<&Error> for Dry {
    fn from(error: &Error) -> Dry {
        Dry { message: error.message().to_owned(), cause: Cause::from(error) }
    }
}
