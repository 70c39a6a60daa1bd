//! What must hold of every input whatsoever, and where inputs come from that nobody would think of.
//!
//! A [`Target`] judges bytes: it panics where Pasu breaks a promise. `cargo xtask fuzz` runs it on inputs that are guided by the code they reach (docs/fuzzing.md), the
//! test of this crate on a few that are not. Both change [seeds](Target::seeds) by the same [mutations](Target::mutated).

mod calls;
mod limits;
mod mutation;
mod random;
mod reading;
mod seeds;

pub use random::Random;

/// One way to look at bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// A document or a link as text.
    Document,
    /// A link: readable, packed from text, or packed from a stream that is damaged.
    Link,
    /// A file to be opened.
    File,
    /// A line that names a call, and a design for it.
    Calls,
}

impl Target {
    /// All of them.
    pub const ALL: [Target; 4] = [Target::Document, Target::Link, Target::File, Target::Calls];

    /// What it is called on the command line, and the folder of its cases.
    pub fn name(self) -> &'static str {
        match self {
            Target::Document => "document",
            Target::Link => "link",
            Target::File => "file",
            Target::Calls => "calls",
        }
    }

    /// The one of this name.
    pub fn named(name: &str) -> Option<Target> {
        Target::ALL.into_iter().find(|target| target.name() == name)
    }

    /// Looks at an input; whether there was more to it than a refusal.
    ///
    /// # Panics
    /// Where a promise is broken: a result that is not finite, a document that is not canonical, too much time or memory, any panic of Pasu's.
    pub fn judge(self, input: &[u8]) -> bool {
        limits::within(|| match self {
            Target::Document => reading::document(input),
            Target::Link => reading::link(input),
            Target::File => reading::file(input),
            Target::Calls => calls::judge(input),
        })
    }

    /// Inputs to begin with.
    pub fn seeds(self) -> Vec<Vec<u8>> {
        match self {
            Target::Document => seeds::documents(),
            Target::Link => seeds::links_and_contents(),
            Target::File => seeds::files(),
            Target::Calls => seeds::calls(),
        }
    }

    /// An input like this one; `others` lend it their parts.
    pub fn mutated(self, input: &[u8], others: &[Vec<u8>], random: &mut Random) -> Vec<u8> {
        match self {
            Target::Document => mutation::of_document(input, others, random),
            Target::Link => mutation::of_document(input, others, random),
            Target::File => mutation::of_bytes(input, random),
            Target::Calls => mutation::of_call(input, others, random),
        }
    }
}
