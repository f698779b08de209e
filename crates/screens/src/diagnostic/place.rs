//! Places in an editor's UTF-16 units.

/// A stretch of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Place {
    /// Its start.
    pub(super) start: usize,
    /// One past its end.
    pub(super) end: usize,
    /// Its line, from 1.
    pub(super) line: usize,
    /// Its column, from 1.
    pub(super) column: usize,
}

impl Place {
    /// The place of a stretch of bytes, cut to the text and to whole characters.
    pub(super) fn of(text: &str, start: usize, end: usize) -> Self {
        let boundary = |mut at: usize| {
            while !text.is_char_boundary(at) {
                at -= 1;
            }
            at
        };
        let start = boundary(start.min(text.len()));
        let end = boundary(end.clamp(start, text.len()));
        let before = &text[..start];
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        let units = |text: &str| text.chars().map(char::len_utf16).sum::<usize>();
        Self {
            start: units(before),
            end: units(&text[..end]),
            line: before.matches('\n').count() + 1,
            column: units(&before[line_start..]) + 1,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Place;

    #[test]
    fn letters_beyond_the_first_plane_are_two() {
        let text = "a = \"ä𝄞\"\nb = 1\n";
        let b = text.find('b').unwrap();
        assert_eq!(Place::of(text, b, b + 1), Place { start: 10, end: 11, line: 2, column: 1 });
        let note = text.find('𝄞').unwrap();
        assert_eq!(Place::of(text, note, b), Place { start: 6, end: 10, line: 1, column: 7 });
        // In the middle of a letter, and beyond the end.
        assert_eq!(Place::of(text, note + 1, note + 2).start, 6);
        assert_eq!(Place::of("", 5, 9), Place { start: 0, end: 0, line: 1, column: 1 });
    }
}
