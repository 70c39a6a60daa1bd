//! Closed sets of names in a document: units, glazes and clays.

/// Declares an enum of names, the first of which is the default.
macro_rules! names {
    ($(#[$about:meta])* pub enum $set:ident { $( $(#[$doc:meta])+ $item:ident = $name:literal, )+ }) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
        pub enum $set {
            #[default]
            $( $(#[$doc])+ $item, )+
        }

        impl $set {
            const ALL: &'static [$set] = &[$( $set::$item ),+];
            /// The names as documents write them, the default first.
            pub const NAMES: &'static [&'static str] = &[$( $name ),+];

            /// The name as documents write it.
            pub fn name(self) -> &'static str {
                Self::NAMES[self as usize]
            }

            /// Reads the field of a record; the default when it is absent.
            pub(crate) fn read(record: &$crate::design::reader::Record, field: &str) -> $crate::error::Result<Self> {
                match record.get(field) {
                    Some(value) => {
                        let index = $crate::design::reader::name(value, &record.path.field(field), Self::NAMES)?;
                        Ok(Self::ALL[index])
                    }
                    None => Ok(Self::default()),
                }
            }

            /// Writes the field unless it has its default.
            pub(crate) fn write(self, field: &str, into: &mut Vec<(String, $crate::design::value::Value)>) {
                if self != Self::default() {
                    into.push((field.into(), $crate::design::value::Value::Text(self.name().into())));
                }
            }
        }
    };
}
pub(crate) use names;
