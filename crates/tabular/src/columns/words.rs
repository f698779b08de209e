//! The words of a heading.

/// Consecutive words without blanks, as written and in lower case. Column names are looked up for
/// several beginnings of a heading, for some hundred thousand cells of a file.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Words {
    written: String,
    lower: String,
    /// End of each word in `written` and in `lower`.
    ends: Vec<(usize, usize)>,
}

impl Words {
    /// Words of a name: runs of letters and digits; `MeasuredDepth` has two.
    pub(crate) fn of(name: &str) -> Self {
        let mut words = Self::default();
        words.add(name);
        words
    }

    /// Adds the words of another name.
    pub(crate) fn add(&mut self, name: &str) {
        let mut before = ' ';
        for c in name.chars() {
            if matches!(c, '°' | 'º' | '˚') {
                self.begin();
                "deg".chars().for_each(|c| self.push(c));
                // The next text starts another word.
                before = ' ';
                continue;
            }
            if c.is_alphanumeric() {
                if !before.is_alphanumeric() || (before.is_lowercase() && c.is_uppercase()) {
                    self.begin();
                }
                self.push(c);
            }
            before = c;
        }
    }

    fn begin(&mut self) {
        self.ends.push((self.written.len(), self.lower.len()));
    }

    fn push(&mut self, c: char) {
        self.written.push(c);
        if c.is_ascii() {
            self.lower.push(c.to_ascii_lowercase());
        } else {
            self.lower.extend(c.to_lowercase());
        }
        if let Some(end) = self.ends.last_mut() {
            *end = (self.written.len(), self.lower.len());
        }
    }

    /// Number of words.
    pub(crate) fn len(&self) -> usize {
        self.ends.len()
    }

    /// The first `count` words without blanks, in lower case.
    pub(crate) fn first(&self, count: usize) -> &str {
        &self.lower[..self.end(count).1]
    }

    /// The words after the first `count` without blanks, as written.
    pub(crate) fn written_after(&self, count: usize) -> &str {
        &self.written[self.end(count).0..]
    }

    /// Each word in lower case.
    pub(crate) fn lower(&self) -> impl Iterator<Item = &str> {
        (0..self.len()).map(|word| &self.lower[self.end(word).1..self.end(word + 1).1])
    }

    fn end(&self, count: usize) -> (usize, usize) {
        count.checked_sub(1).map_or((0, 0), |last| self.ends[last])
    }
}

#[cfg(test)]
mod tests {
    use super::Words;

    #[test]
    fn a_name_is_parted_at_blanks_signs_and_capitals() {
        for (name, expected) in [
            ("Measured Depth", &["measured", "depth"] as &[&str]),
            ("MeasuredDepth_ft", &["measured", "depth", "ft"]),
            ("+N/-S", &["n", "s"]),
            ("Incl.°T", &["incl", "deg", "t"]),
            ("Größe ÜBER", &["größe", "über"]),
            ("", &[]),
        ] {
            let words = Words::of(name);
            assert_eq!(words.lower().collect::<Vec<_>>(), expected, "{name}");
            assert_eq!(words.len(), expected.len());
            assert_eq!(words.first(words.len()), expected.concat());
        }
        let words = Words::of("MD ftKB");
        assert_eq!((words.first(1), words.written_after(1)), ("md", "ftKB"));
        assert_eq!((words.first(0), words.written_after(3)), ("", ""));
    }
}
