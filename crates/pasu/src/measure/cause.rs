//! Why something cannot be measured, for whoever says it in other words.

use crate::answer::answers;
use crate::error::{Args, Error};

answers! {
    /// Why there is something not, without the sentence.
    pub struct Cause as "Cause" {
        /// A stable kebab-case word.
        pub code: &'static str,
        /// What of the design it is about, such as `parts[0].wall.foot`; `None` where that is no single field.
        pub path: Option<String>,
        /// What the sentence names, as [`Error::args`](crate::Error::args) has it.
        pub args: Args,
    }
}

impl From<&Error> for Cause {
    fn from(error: &Error) -> Cause {
        let (code, path, args) = error.cause();
        Cause { code, path, args }
    }
}
