//! How wide texts are, roughly: who shows a drawing chooses the letters.

use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

/// The mean width of a letter, of its size. Wide ones, as those of Chinese, have twice this.
const LETTER: f64 = 0.55;

/// The width of a text whose letters have a size.
pub(super) fn width(text: &str, size: f64) -> f64 {
    LETTER * size * text.width() as f64
}

/// As much of the beginning of a text as is no wider than so many letters.
pub(super) fn beginning(text: &str, letters: usize) -> &str {
    let mut room = letters;
    let end = text.char_indices().find(|(_, letter)| {
        let width = letter.width().unwrap_or(1);
        let is_beyond = width > room;
        room = room.saturating_sub(width);
        is_beyond
    });
    end.map_or(text, |(end, _)| &text[..end])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wide_letters_count_twice_and_marks_on_letters_not_at_all() {
        assert_eq!(width("vase", 2.0), width("花瓶", 2.0));
        assert_eq!(width("a\u{308}", 1.0), width("ä", 1.0));
        assert_eq!(width("", 3.0), 0.0);
        assert!((width("🏺", 1.0) - 1.1).abs() < 1e-12);
    }

    #[test]
    fn a_beginning_is_as_long_as_it_has_room() {
        assert_eq!(beginning("vase", 3), "vas");
        assert_eq!(beginning("vase", 4), "vase");
        assert_eq!(beginning("花瓶", 3), "花");
        assert_eq!(beginning("花瓶", 4), "花瓶");
        assert_eq!(beginning("花瓶", 0), "");
        // A mark goes with its letter.
        assert_eq!(beginning("a\u{308}o\u{308}", 1), "a\u{308}");
    }
}
