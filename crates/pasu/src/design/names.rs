//! Closed sets of names in a document: units, glazes and clays.

/// Declares an enum of names, the first of which is the default.
macro_rules! names {
    ($(#[$about:meta])* pub enum $set:ident { $( $(#[$doc:meta])+ $item:ident = $name:literal, )+ }) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
        pub enum $set {
            #[default]
            $( $(#[$doc])+ #[serde(rename = $name)] $item, )+
        }

        impl $set {
            /// The names as documents write them, the default first.
            pub const NAMES: &'static [&'static str] = &[$( $name ),+];

            /// All of them, in the order of their names.
            pub const ALL: &'static [$set] = &[$( $set::$item ),+];

            /// The name as documents write it.
            pub fn name(self) -> &'static str {
                Self::NAMES[self as usize]
            }
        }
    };
}
pub(crate) use names;
