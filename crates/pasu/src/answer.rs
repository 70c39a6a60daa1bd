//! What is answered in numbers and words: structures that write themselves as plain data and, with the feature `typescript`, declare themselves.
//!
//! A field is named in JavaScript as in Rust, in its spelling. What there is not is null: no field is ever left out.

/// Declares structures that are answered, each with the name of its TypeScript type.
///
/// Fields of a field that is marked `#[serde(flatten)]` stand among those of the structure itself.
macro_rules! answers {
    ($(
        $(#[doc = $about:literal])+
        $(#[derive($($derived:ident),*)])?
        pub struct $name:ident as $shown:literal {
            $(
                $(#[doc = $doc:literal])+
                $(#[serde($how:ident)])?
                pub $field:ident: $type:ty,
            )*
        }
    )+) => {$(
        $(#[doc = $about])+
        #[derive(Debug, Clone, PartialEq, serde::Serialize $($(, $derived)*)?)]
        #[serde(rename_all = "camelCase")]
        #[non_exhaustive]
        pub struct $name {
            $(
                $(#[doc = $doc])+
                $(#[serde($how)])?
                pub $field: $type,
            )*
        }

        #[cfg(feature = "typescript")]
        impl $crate::answer::Answer for $name {
            fn type_name() -> String {
                $shown.to_owned()
            }

            fn declare(text: &mut String) {
                $crate::answer::declare(text, $shown, &[$($about),+], &[$(
                    $crate::answer::Field {
                        name: stringify!($field),
                        about: &[$($doc),+],
                        type_name: <$type as $crate::answer::Answer>::type_name(),
                        is_flat: !concat!($(stringify!($how))?).is_empty(),
                    },
                )*]);
            }
        }
    )+};
}
pub(crate) use answers;

/// A type of which an answer is made.
#[cfg(feature = "typescript")]
pub(crate) trait Answer {
    /// How TypeScript names it.
    fn type_name() -> String;

    /// Writes its declaration, if it needs one.
    fn declare(_text: &mut String) {}
}

/// A type that is declared somewhere else, by this name.
#[cfg(feature = "typescript")]
macro_rules! known_as {
    ($type:ty, $name:literal) => {
        impl $crate::answer::Answer for $type {
            fn type_name() -> String {
                $name.to_owned()
            }
        }
    };
}
#[cfg(feature = "typescript")]
pub(crate) use known_as;

/// One field of a declaration.
#[cfg(feature = "typescript")]
pub(crate) struct Field {
    /// As Rust spells it.
    pub(crate) name: &'static str,
    /// Line by line.
    pub(crate) about: &'static [&'static str],
    /// Of its type.
    pub(crate) type_name: String,
    /// Whether its fields stand in its place.
    pub(crate) is_flat: bool,
}

/// Writes the declaration of a structure.
#[cfg(feature = "typescript")]
pub(crate) fn declare(text: &mut String, name: &str, about: &[&str], fields: &[Field]) {
    let flat: Vec<&str> = fields.iter().filter(|field| field.is_flat).map(|field| field.type_name.as_str()).collect();
    let extends = if flat.is_empty() { String::new() } else { format!(" extends {}", flat.join(", ")) };
    text.push_str(&format!("\n/** {} */\nexport interface {name}{extends} {{\n", sentences(about)));
    for field in fields.iter().filter(|field| !field.is_flat) {
        let (about, name) = (sentences(field.about), in_camel_case(field.name));
        text.push_str(&format!("  /** {about} */\n  readonly {name}: {};\n", field.type_name));
    }
    text.push_str("}\n");
}

/// Lines of Rust documentation as one of TypeScript: what is a name of Rust's alone is no link.
#[cfg(feature = "typescript")]
fn sentences(lines: &[&str]) -> String {
    let text: Vec<&str> = lines.iter().map(|line| line.trim()).filter(|line| !line.is_empty()).collect();
    // The address of a link may end in a pair of brackets of its own.
    let joined = text.join(" ");
    let mut pieces = joined.split("](crate::");
    let mut text = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let (address, rest) = piece.split_once(')').unwrap_or((piece, ""));
        text.push_str(if address.ends_with('(') { rest.strip_prefix(')').unwrap_or(rest) } else { rest });
    }
    text.replace("[`", "`").replace("`]", "`").replace("`None`", "null")
}

#[cfg(feature = "typescript")]
fn in_camel_case(name: &str) -> String {
    let mut words = name.split('_');
    let first = words.next().unwrap_or_default().to_owned();
    words.fold(first, |name, word| name + &word[..1].to_uppercase() + &word[1..])
}

#[cfg(feature = "typescript")]
mod types {
    use super::Answer;

    known_as!(f64, "number");
    known_as!(usize, "number");
    known_as!(bool, "boolean");
    known_as!(String, "string");
    known_as!(&'static str, "string");
    known_as!([f64; 2], "readonly [x: number, y: number]");
    known_as!([f64; 3], "Point");

    impl<T: Answer> Answer for Option<T> {
        fn type_name() -> String {
            format!("{} | null", T::type_name())
        }
    }

    impl<T: Answer> Answer for Vec<T> {
        fn type_name() -> String {
            let name = T::type_name();
            if name.contains(' ') { format!("readonly ({name})[]") } else { format!("readonly {name}[]") }
        }
    }
}

#[cfg(feature = "typescript")]
known_as!(crate::error::Args, "PasuErrorArgs");
