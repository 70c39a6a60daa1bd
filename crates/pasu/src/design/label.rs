//! Titles and names.

use std::fmt;

use serde::de::{Deserializer, Error, Unexpected, Visitor};

use super::limits::CHARACTERS;

/// Reads plain text on one line, of 200 characters at most. An empty one is none, as is one that is left out.
pub(crate) fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<String>, D::Error> {
    deserializer.deserialize_option(Label)
}

struct Label;

impl<'de> Visitor<'de> for Label {
    type Value = Option<String>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a text")
    }

    fn visit_none<E>(self) -> Result<Self::Value, E> {
        Ok(None)
    }

    fn visit_unit<E>(self) -> Result<Self::Value, E> {
        Ok(None)
    }

    fn visit_some<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_str(self)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Self::Value, E> {
        let count = text.chars().count();
        if count > CHARACTERS {
            return Err(E::invalid_length(count, &format!("at most {CHARACTERS} characters").as_str()));
        }
        if let Some(c) = text.chars().find(|c| c.is_control()) {
            let found = format!("the control character U+{:04X}", u32::from(c));
            return Err(E::invalid_value(Unexpected::Other(&found), &"plain text on one line"));
        }
        Ok((!text.is_empty()).then(|| text.to_owned()))
    }
}
