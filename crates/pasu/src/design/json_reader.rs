//! JSON text (RFC 8259) into a tree that keeps everything: the order of fields, repeated keys, and the path of a fault.
//!
//! A reader of our own because the general ones weigh more than the whole solver once compiled to WebAssembly, and lose
//! repeated keys besides.

use super::path::Path;
use super::value::{DEEPEST, Value};
use crate::error::{Code, Error, Result};

/// Reads one value and nothing after it.
///
/// # Errors
/// `not-json` with the line and column where the text stops being JSON, and `not-finite` for a number beyond the range
/// of an IEEE double.
pub(crate) fn read(text: &str) -> Result<Value> {
    let mut reader = Reader { text, at: 0 };
    let start = Path::Start("");
    let value = reader.value(&start, 0)?;
    reader.skip_space();
    match reader.peek() {
        None => Ok(value),
        Some(_) => Err(reader.fault(&start, "expected nothing after the design")),
    }
}

struct Reader<'a> {
    text: &'a str,
    /// The byte that comes next; always between characters.
    at: usize,
}

impl Reader<'_> {
    fn value(&mut self, path: &Path, depth: usize) -> Result<Value> {
        self.skip_space();
        match self.peek() {
            Some(b'{') => self.record(path, self.deeper(path, depth)?),
            Some(b'[') => self.list(path, self.deeper(path, depth)?),
            Some(b'"') => Ok(Value::Text(self.text(path)?)),
            Some(b'-' | b'0'..=b'9') => self.number(path),
            _ => {
                for (word, value) in [("true", Value::Bool(true)), ("false", Value::Bool(false)), ("null", Value::Null)]
                {
                    if self.text[self.at..].starts_with(word) {
                        self.at += word.len();
                        return Ok(value);
                    }
                }
                Err(self.fault(path, "expected a value"))
            }
        }
    }

    fn deeper(&self, path: &Path, depth: usize) -> Result<usize> {
        if depth == DEEPEST {
            return Err(self.fault(path, &format!("nested more than {DEEPEST} levels deep")));
        }
        Ok(depth + 1)
    }

    fn record(&mut self, path: &Path, depth: usize) -> Result<Value> {
        self.at += 1; // the brace
        let mut fields = Vec::new();
        if self.take_after_space(b'}') {
            return Ok(Value::Record(fields));
        }
        loop {
            self.skip_space();
            if self.peek() != Some(b'"') {
                return Err(self.fault(path, "expected the name of a field in quotation marks"));
            }
            let name = self.text(path)?;
            if !self.take_after_space(b':') {
                return Err(self.fault(path, "expected a colon after the name of a field"));
            }
            let value = self.value(&path.field(&name), depth)?;
            fields.push((name, value));
            if self.take_after_space(b'}') {
                return Ok(Value::Record(fields));
            }
            if !self.take_after_space(b',') {
                return Err(self.fault(path, "expected a comma or the closing brace"));
            }
        }
    }

    fn list(&mut self, path: &Path, depth: usize) -> Result<Value> {
        self.at += 1; // the bracket
        let mut items = Vec::new();
        if self.take_after_space(b']') {
            return Ok(Value::List(items));
        }
        loop {
            items.push(self.value(&path.item(items.len()), depth)?);
            if self.take_after_space(b']') {
                return Ok(Value::List(items));
            }
            if !self.take_after_space(b',') {
                return Err(self.fault(path, "expected a comma or the closing bracket"));
            }
        }
    }

    /// `-? (0 | [1-9][0-9]*) (. [0-9]+)? ([eE] [+-]? [0-9]+)?`
    fn number(&mut self, path: &Path) -> Result<Value> {
        let start = self.at;
        self.take(b'-');
        if !self.take(b'0') {
            self.digits(path)?;
        }
        if self.take(b'.') {
            self.digits(path)?;
        }
        if self.take(b'e') || self.take(b'E') {
            let _signed = self.take(b'+') || self.take(b'-');
            self.digits(path)?;
        }
        match self.text[start..self.at].parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(Value::Number(number)),
            Ok(_) => Err(path.error(Code::NotFinite, "expected a number, found one too large to be computed with")),
            Err(_) => Err(self.fault(path, "expected a number")),
        }
    }

    fn digits(&mut self, path: &Path) -> Result<()> {
        let start = self.at;
        while self.peek().is_some_and(|byte| byte.is_ascii_digit()) {
            self.at += 1;
        }
        if self.at == start { Err(self.fault(path, "expected a digit")) } else { Ok(()) }
    }

    fn text(&mut self, path: &Path) -> Result<String> {
        self.at += 1; // the quotation mark
        let mut text = String::new();
        loop {
            let plain = self.text[self.at..].find(|c| c == '"' || c == '\\' || c < ' ');
            let end = self.at + plain.unwrap_or(self.text.len() - self.at);
            text.push_str(&self.text[self.at..end]);
            self.at = end;
            if self.take(b'"') {
                return Ok(text);
            }
            if !self.take(b'\\') {
                return Err(self.fault(path, "a line break or control character in a text"));
            }
            text.push(self.escaped(path)?);
        }
    }

    /// What stands after a backslash.
    fn escaped(&mut self, path: &Path) -> Result<char> {
        let c = match self.peek() {
            Some(b'u') => {
                self.at += 1;
                return self.escaped_unicode(path);
            }
            Some(same @ (b'"' | b'\\' | b'/')) => char::from(same),
            Some(b'b') => '\u{8}',
            Some(b'f') => '\u{c}',
            Some(b'n') => '\n',
            Some(b'r') => '\r',
            Some(b't') => '\t',
            _ => return Err(self.fault(path, "a backslash that escapes nothing")),
        };
        self.at += 1;
        Ok(c)
    }

    /// Four hexadecimal digits, or twice four for a character outside the basic plane.
    fn escaped_unicode(&mut self, path: &Path) -> Result<char> {
        let first = self.hexadecimal(path)?;
        let code = if (0xd800..0xdc00).contains(&first) && self.text[self.at..].starts_with("\\u") {
            self.at += 2;
            match self.hexadecimal(path)? {
                second @ 0xdc00..0xe000 => 0x1_0000 + ((first - 0xd800) << 10) + (second - 0xdc00),
                other => return Err(self.fault(path, &format!("half a character followed by \\u{other:04x}"))),
            }
        } else {
            first
        };
        // Half of a pair is no character.
        char::from_u32(code).ok_or_else(|| self.fault(path, "an escaped character that does not exist"))
    }

    fn hexadecimal(&mut self, path: &Path) -> Result<u32> {
        let digits = self.text.get(self.at..self.at + 4).filter(|four| four.bytes().all(|b| b.is_ascii_hexdigit()));
        let code = digits.and_then(|four| u32::from_str_radix(four, 16).ok());
        self.at += if code.is_some() { 4 } else { 0 };
        code.ok_or_else(|| self.fault(path, "expected four hexadecimal digits"))
    }

    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    fn take(&mut self, byte: u8) -> bool {
        let here = self.peek() == Some(byte);
        self.at += usize::from(here);
        here
    }

    fn take_after_space(&mut self, byte: u8) -> bool {
        self.skip_space();
        self.take(byte)
    }

    fn skip_space(&mut self) {
        while matches!(self.peek(), Some(b' ' | b'\t' | b'\n' | b'\r')) {
            self.at += 1;
        }
    }

    /// That the text is not JSON at this place; that it ends too early when there is nothing left of it.
    fn fault(&self, path: &Path, what: &str) -> Error {
        let before = &self.text[..self.at];
        let line = 1 + before.matches('\n').count();
        let column = 1 + before.chars().rev().take_while(|&c| c != '\n').count();
        let message = if self.at == self.text.len() {
            format!("this JSON text ends in the middle, at line {line}, column {column}; is it cut short?")
        } else {
            format!("this is not JSON: {what} at line {line}, column {column}")
        };
        path.error(Code::NotJson, message)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn everything_json_has_is_read() {
        let text = "\t{ \"a\" : [ 1 , -2.5e-3, 0, -0, true, false, null ] ,\r\n \"a\" : \"\\u00e9\\ud83c\\udffa\\n\\/é\" , \"\" : { } , \"b\":[] }\n";
        let Value::Record(fields) = read(text).unwrap() else { panic!("a record") };
        let names: Vec<&str> = fields.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["a", "a", "", "b"]);
        assert_eq!(fields[1].1, Value::Text("é🏺\n/é".into()));
        assert_eq!(fields[2].1, Value::Record(vec![]));
        let Value::List(items) = &fields[0].1 else { panic!("a list") };
        assert_eq!(items[1], Value::Number(-0.0025));
        assert!(matches!(items[3], Value::Number(zero) if zero.to_bits() == (-0.0_f64).to_bits()));
    }

    #[test]
    fn what_is_not_json_is_told_by_its_place() {
        let cases = [
            ("", "this JSON text ends in the middle, at line 1, column 1; is it cut short?"),
            ("{\"a\": [1, 2", "this JSON text ends in the middle, at line 1, column 12; is it cut short?"),
            ("{\"a\"\n 1}", "this is not JSON: expected a colon after the name of a field at line 2, column 2"),
            ("[1,]", "this is not JSON: expected a value at line 1, column 4"),
            ("{a: 1}", "this is not JSON: expected the name of a field in quotation marks at line 1, column 2"),
            ("[1 2]", "this is not JSON: expected a comma or the closing bracket at line 1, column 4"),
            ("[01]", "this is not JSON: expected a comma or the closing bracket at line 1, column 3"),
            ("[.5]", "this is not JSON: expected a value at line 1, column 2"),
            ("[1.]", "this is not JSON: expected a digit at line 1, column 4"),
            ("[NaN]", "this is not JSON: expected a value at line 1, column 2"),
            ("1 1", "this is not JSON: expected nothing after the design at line 1, column 3"),
            ("[\"é\n\"]", "this is not JSON: a line break or control character in a text at line 1, column 4"),
            ("\"\\x\"", "this is not JSON: a backslash that escapes nothing at line 1, column 3"),
            ("\"\\ud800\"", "this is not JSON: an escaped character that does not exist at line 1, column 8"),
            ("\"\\u00g0\"", "this is not JSON: expected four hexadecimal digits at line 1, column 4"),
        ];
        for (text, message) in cases {
            let error = read(text).unwrap_err();
            assert_eq!((error.code(), error.message()), ("not-json", message), "{text}");
        }
    }

    #[test]
    fn a_number_beyond_all_doubles_is_told_by_its_path() {
        let error = read(r#"{"parts": [{"a": 1e400}]}"#).unwrap_err();
        assert_eq!((error.code(), error.path()), ("not-finite", "parts[0].a"));
    }

    #[test]
    fn nesting_has_a_bottom() {
        let deep = |n: usize| format!("{}{}", "[".repeat(n), "]".repeat(n));
        assert!(read(&deep(DEEPEST)).is_ok());
        assert!(read(&deep(DEEPEST + 1)).unwrap_err().message().contains("nested more than 64 levels deep"));
        assert!(read(&"[".repeat(1 << 20)).is_err());
    }

    /// Texts that are nearly JSON, made of its pieces.
    fn pieces() -> impl Strategy<Value = String> {
        let piece = prop::sample::select(vec![
            "{",
            "}",
            "[",
            "]",
            ":",
            ",",
            "\"a\"",
            "\"\\u00e9\"",
            "\"\\ud83c\\udffa\"",
            "\"\\udffa\"",
            "\"\\ud83c\\u0041\"",
            "\"",
            "\\",
            "1",
            "-",
            "0",
            ".5",
            "e",
            "E+2",
            "1e999",
            "1e-999",
            "true",
            "fals",
            "null",
            " ",
            "\n",
            "é",
            "\u{1}",
        ]);
        prop::collection::vec(piece, 0..12).prop_map(|pieces| pieces.concat())
    }

    proptest! {
        #[test]
        fn numbers_are_read_to_the_bit(bits in any::<u64>()) {
            let number = f64::from_bits(bits);
            prop_assume!(number.is_finite());
            for text in [format!("{number}"), format!("{number:e}"), format!("{number:.17e}")] {
                let read = read(&text).unwrap();
                prop_assert!(matches!(read, Value::Number(x) if x.to_bits() == number.to_bits()), "{}", text);
            }
        }

        #[test]
        fn another_reader_accepts_the_same_texts_with_the_same_meaning(text in pieces()) {
            let theirs = serde_json::from_str::<Value>(&text).ok();
            prop_assert_eq!(read(&text).ok(), theirs);
        }
    }
}
