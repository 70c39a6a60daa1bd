//! JSON text in and out (RFC 8259).
//!
//! Not by a general library: this reader fills one type, knows at every moment where in the design it is, and is a tenth of the weight.

use super::decimal::parse;
use super::limits::BYTES;
use super::number::plain;
use super::path::Path;
use super::value::{DEEPEST, Value};
use crate::error::{Code, Error, Result};

/// Reads JSON text, whose faults are told by their place.
pub(crate) fn read(text: &str) -> Result<Value> {
    if text.len() > BYTES {
        let message = format!("expected a design of at most {BYTES} bytes of JSON, found {}", text.len());
        return Err(Error::new(Code::TooLarge, "", message));
    }
    let mut reader = Reader { text, at: 0 };
    let start = Path::Start("");
    let value = reader.value(&start, 0)?;
    match reader.next_byte() {
        None => Ok(value),
        Some(_) => Err(reader.fault(&start, "trailing characters")),
    }
}

struct Reader<'a> {
    text: &'a str,
    /// Bytes read.
    at: usize,
}

impl Reader<'_> {
    fn value(&mut self, path: &Path, depth: usize) -> Result<Value> {
        match self.next_byte() {
            Some(b'"') => Ok(Value::Text(self.string(path)?)),
            Some(b'-' | b'0'..=b'9') => self.number(path),
            Some(b'[' | b'{') if depth == DEEPEST => {
                Err(self.fault(path, &format!("nested more than {DEEPEST} levels deep")))
            }
            Some(b'[') => self.list(path, depth),
            Some(b'{') => self.record(path, depth),
            _ => {
                for (word, value) in [("null", Value::Null), ("true", Value::Bool(true)), ("false", Value::Bool(false))]
                {
                    if self.rest().starts_with(word) {
                        self.at += word.len();
                        return Ok(value);
                    }
                    if word.starts_with(self.rest()) {
                        return Err(self.cut_short(path));
                    }
                }
                Err(self.fault(path, "expected value"))
            }
        }
    }

    fn list(&mut self, path: &Path, depth: usize) -> Result<Value> {
        let mut items = Vec::new();
        self.at += 1;
        if self.next_byte() == Some(b']') {
            self.at += 1;
            return Ok(Value::List(items));
        }
        loop {
            let item = self.value(&path.item(items.len()), depth + 1)?;
            items.push(item);
            match self.next_byte() {
                Some(b',') => self.at += 1,
                Some(b']') => break,
                _ => return Err(self.fault(path, "expected `,` or `]`")),
            }
            if self.next_byte() == Some(b']') {
                return Err(self.fault(path, "trailing comma"));
            }
        }
        self.at += 1;
        Ok(Value::List(items))
    }

    fn record(&mut self, path: &Path, depth: usize) -> Result<Value> {
        let mut fields = Vec::new();
        self.at += 1;
        if self.next_byte() == Some(b'}') {
            self.at += 1;
            return Ok(Value::Record(fields));
        }
        loop {
            if self.next_byte() != Some(b'"') {
                return Err(self.fault(path, "key must be a string"));
            }
            let name = self.string(path)?;
            let field = path.field(&name);
            if self.next_byte() != Some(b':') {
                return Err(self.fault(&field, "expected `:`"));
            }
            self.at += 1;
            let value = self.value(&field, depth + 1)?;
            fields.push((name, value));
            match self.next_byte() {
                Some(b',') => self.at += 1,
                Some(b'}') => break,
                _ => return Err(self.fault(path, "expected `,` or `}`")),
            }
            if self.next_byte() == Some(b'}') {
                return Err(self.fault(path, "trailing comma"));
            }
        }
        self.at += 1;
        Ok(Value::Record(fields))
    }

    fn number(&mut self, path: &Path) -> Result<Value> {
        let start = self.at;
        self.skip(|byte| byte == b'-');
        let sign = self.at - start;
        let first = self.peek();
        let whole = self.digits(path)?;
        if sign > 1 || (first == Some(b'0') && whole > 1) {
            return Err(self.fault(path, "invalid number"));
        }
        if self.peek() == Some(b'.') {
            self.at += 1;
            self.digits(path)?;
        }
        if matches!(self.peek(), Some(b'e' | b'E')) {
            self.at += 1;
            if matches!(self.peek(), Some(b'-' | b'+')) {
                self.at += 1;
            }
            self.digits(path)?;
        }
        match parse(self.since(start)) {
            Some(number) if number.is_finite() => Ok(Value::Number(number)),
            _ => Err(path.error(Code::NotFinite, "expected a number, found one too large to be computed with")),
        }
    }

    /// At least one digit; returns how many.
    fn digits(&mut self, path: &Path) -> Result<usize> {
        let start = self.at;
        self.skip(|byte| byte.is_ascii_digit());
        if self.at == start { Err(self.fault(path, "invalid number")) } else { Ok(self.at - start) }
    }

    fn string(&mut self, path: &Path) -> Result<String> {
        let mut string = String::new();
        self.at += 1;
        loop {
            let start = self.at;
            self.skip(|byte| byte >= b' ' && byte != b'"' && byte != b'\\');
            string.push_str(self.since(start));
            match self.peek() {
                Some(b'"') => break,
                Some(b'\\') => string.push(self.escaped(path)?),
                _ => return Err(self.fault(path, "a control character within a text")),
            }
        }
        self.at += 1;
        Ok(string)
    }

    fn escaped(&mut self, path: &Path) -> Result<char> {
        self.at += 1;
        let Some(letter) = self.peek() else { return Err(self.cut_short(path)) };
        let c = match letter {
            b'"' | b'\\' | b'/' => char::from(letter),
            b'b' => '\u{8}',
            b't' => '\t',
            b'n' => '\n',
            b'f' => '\u{c}',
            b'r' => '\r',
            b'u' => return self.hexadecimal(path),
            _ => return Err(self.fault(path, "invalid escape")),
        };
        self.at += 1;
        Ok(c)
    }

    /// `u0041`, or the two halves of a character beyond U+FFFF.
    fn hexadecimal(&mut self, path: &Path) -> Result<char> {
        let high = self.unit(path)?;
        let code = match high {
            0xd800..0xdc00 if self.rest().starts_with("\\u") => {
                self.at += 1;
                let low = self.unit(path)?;
                // Whatever is no second half leads out of the characters, or to another half.
                0x10000
                    + ((high - 0xd800) << 10)
                    + low.checked_sub(0xdc00).filter(|low| *low < 0x400).unwrap_or(1 << 24)
            }
            _ => high,
        };
        char::from_u32(code).ok_or_else(|| self.fault(path, "half of a character in an escape"))
    }

    /// `u` and four digits.
    fn unit(&mut self, path: &Path) -> Result<u32> {
        let mut unit = 0;
        for _ in 0..4 {
            self.at += 1;
            let digit = self.peek().and_then(|byte| char::from(byte).to_digit(16));
            let Some(digit) = digit else { return Err(self.fault(path, "invalid escape")) };
            unit = 16 * unit + digit;
        }
        self.at += 1;
        Ok(unit)
    }

    fn skip(&mut self, accepts: impl Fn(u8) -> bool) {
        while self.peek().is_some_and(&accepts) {
            self.at += 1;
        }
    }

    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    /// The next byte that is no white space.
    fn next_byte(&mut self) -> Option<u8> {
        self.skip(|byte| matches!(byte, b' ' | b'\t' | b'\n' | b'\r'));
        self.peek()
    }

    fn rest(&self) -> &str {
        self.text.get(self.at..).unwrap_or_default()
    }

    fn since(&self, start: usize) -> &str {
        self.text.get(start..self.at).unwrap_or_default()
    }

    /// An error at the next character.
    fn fault(&self, path: &Path, what: &str) -> Error {
        if self.rest().is_empty() {
            return self.cut_short(path);
        }
        let (line, column) = self.place();
        path.error(Code::NotJson, format!("This is not JSON: {what} at line {line}, column {}.", column + 1))
    }

    fn cut_short(&self, path: &Path) -> Error {
        let (line, column) = Reader { at: self.text.len(), ..*self }.place();
        let message = format!("This JSON text ends in the middle, at line {line}, column {column}; is it cut short?");
        path.error(Code::NotJson, message)
    }

    /// The line, and how many characters of it have been read.
    fn place(&self) -> (usize, usize) {
        let read = self.since(0);
        let line = read.split('\n').count();
        (line, read.rsplit('\n').next().unwrap_or_default().chars().count())
    }
}

/// Writes a tree on one line, exactly as JavaScript's `JSON.stringify` would.
pub(crate) fn write(value: &Value) -> String {
    let mut text = String::new();
    write_value(value, &mut text);
    text
}

fn write_value(value: &Value, into: &mut String) {
    match value {
        Value::Null => into.push_str("null"),
        Value::Bool(b) => into.push_str(if *b { "true" } else { "false" }),
        Value::Number(x) if x.is_finite() => into.push_str(&plain(*x)),
        Value::Number(_) => into.push_str("null"),
        Value::Text(text) => write_text(text, into),
        Value::List(items) => {
            into.push('[');
            for (index, item) in items.iter().enumerate() {
                if index > 0 {
                    into.push(',');
                }
                write_value(item, into);
            }
            into.push(']');
        }
        Value::Record(fields) => {
            into.push('{');
            for (index, (name, value)) in fields.iter().enumerate() {
                if index > 0 {
                    into.push(',');
                }
                write_text(name, into);
                into.push(':');
                write_value(value, into);
            }
            into.push('}');
        }
    }
}

fn write_text(text: &str, into: &mut String) {
    into.push('"');
    for c in text.chars() {
        match c {
            '"' => into.push_str("\\\""),
            '\\' => into.push_str("\\\\"),
            '\u{8}' => into.push_str("\\b"),
            '\t' => into.push_str("\\t"),
            '\n' => into.push_str("\\n"),
            '\u{c}' => into.push_str("\\f"),
            '\r' => into.push_str("\\r"),
            c if c < ' ' => into.push_str(&format!("\\u{:04x}", u32::from(c))),
            c => into.push(c),
        }
    }
    into.push('"');
}
