//! The rows of WITSML 2: `[[[index, ...], [value, ...]], ...]` as JSON.

use super::super::record::Row;

/// Maximum nesting of arrays: an array channel with attributes has five levels.
const DEEPEST: usize = 16;

/// Reads rows out of a text.
pub(super) struct Json {
    text: Vec<u8>,
    at: usize,
    begun: bool,
}

impl Json {
    pub(super) fn new(text: String) -> Self {
        Self { text: text.into_bytes(), at: 0, begun: false }
    }

    /// Number of lines passed so far.
    pub(super) fn lines(&self, from: usize) -> u64 {
        self.text[from..self.at].iter().filter(|b| **b == b'\n').count() as u64
    }

    /// Current offset in the text, bytes.
    pub(super) fn at(&self) -> usize {
        self.at
    }

    /// Reads the next row: the values of the index, then those of the channels.
    ///
    /// # Errors
    /// The text that was expected.
    pub(super) fn row(&mut self, row: &mut Row) -> Result<Option<usize>, &'static str> {
        if !self.begun {
            self.begun = true;
            match self.peek() {
                None => return Ok(None),
                Some(b'[') => self.at += 1,
                Some(_) => return Err("'[' before the rows was expected"),
            }
        } else if self.peek() == Some(b',') {
            self.at += 1;
        }
        match self.peek() {
            Some(b']') => {
                self.at += 1;
                return match self.peek() {
                    None => Ok(None),
                    Some(_) => Err("nothing after the rows was expected"),
                };
            }
            Some(b'[') => self.at += 1,
            _ => return Err("'[' before a row or ']' after the rows was expected"),
        }
        self.list(row)?;
        let index = row.cells.len();
        if self.peek() == Some(b',') {
            self.at += 1;
            self.list(row)?;
        }
        if self.peek() != Some(b']') {
            return Err("']' after a row was expected");
        }
        self.at += 1;
        Ok(Some(index))
    }

    /// Reads `[value, ...]`, one cell each.
    fn list(&mut self, row: &mut Row) -> Result<(), &'static str> {
        if self.peek() != Some(b'[') {
            return Err("'[' before values was expected");
        }
        self.at += 1;
        if self.peek() == Some(b']') {
            self.at += 1;
            return Ok(());
        }
        loop {
            self.cell(row)?;
            match self.peek() {
                Some(b',') => self.at += 1,
                Some(b']') => {
                    self.at += 1;
                    return Ok(());
                }
                _ => return Err("',' or ']' after a value was expected"),
            }
        }
    }

    /// Reads a value; of an array only the first element, which its attributes follow.
    fn cell(&mut self, row: &mut Row) -> Result<(), &'static str> {
        let cells = row.cells.len();
        self.value(row, 0)?;
        if row.cells.len() == cells {
            let end = row.bytes.len() as u32;
            row.cells.push((end, end));
        }
        row.cells.truncate(cells + 1);
        Ok(())
    }

    fn value(&mut self, row: &mut Row, depth: usize) -> Result<(), &'static str> {
        let (from, cells) = (row.bytes.len(), row.cells.len());
        match self.peek() {
            Some(b'[') if depth < DEEPEST => {
                self.at += 1;
                let mut first = true;
                while self.peek() != Some(b']') {
                    if !std::mem::take(&mut first) {
                        if self.peek() != Some(b',') {
                            return Err("',' or ']' after a value was expected");
                        }
                        self.at += 1;
                    }
                    self.value(row, depth + 1)?;
                    // Only the first is kept, however long the array.
                    row.cells.truncate(cells + 1);
                    if let Some(&(_, end)) = row.cells.get(cells) {
                        row.bytes.truncate(end as usize);
                    }
                }
                self.at += 1;
                return Ok(());
            }
            Some(b'[') => return Err("fewer nested arrays were expected"),
            Some(b'"') => {
                self.at += 1;
                loop {
                    match self.text.get(self.at) {
                        Some(b'"') => break,
                        Some(b'\\') => {
                            row.bytes.extend(self.text.get(self.at + 1));
                            self.at += 2;
                        }
                        Some(&byte) => {
                            row.bytes.push(byte);
                            self.at += 1;
                        }
                        None => return Err("'\"' after a text was expected"),
                    }
                }
                self.at += 1;
            }
            Some(b'{') => return Err("a value, not an object, was expected"),
            _ => {
                while let Some(&byte) = self.text.get(self.at)
                    && !matches!(byte, b',' | b']' | b'[' | b'"')
                    && !byte.is_ascii_whitespace()
                {
                    row.bytes.push(byte);
                    self.at += 1;
                }
                if row.bytes.len() == from {
                    return Err("a value was expected");
                }
                if &row.bytes[from..] == b"null" {
                    row.bytes.truncate(from);
                }
            }
        }
        row.push(from, row.bytes.len());
        Ok(())
    }

    fn peek(&mut self) -> Option<u8> {
        while self.text.get(self.at).is_some_and(u8::is_ascii_whitespace) {
            self.at += 1;
        }
        self.text.get(self.at).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::{Json, Row};

    fn rows(text: &str) -> Result<Vec<String>, &'static str> {
        let mut json = Json::new(text.to_owned());
        let mut rows = Vec::new();
        let mut row = Row::default();
        loop {
            row.clear();
            if json.row(&mut row)?.is_none() {
                return Ok(rows);
            }
            let cells = (0..row.cells.len()).map(|at| String::from_utf8_lossy(row.cell(at)));
            rows.push(cells.collect::<Vec<_>>().join("|"));
        }
    }

    #[test]
    fn rows_are_read() {
        let text = r#" [ [["2021-03-24T00:00:00Z"],[1.5, null, "a\"b", [7, true], []]],
            [[2],[]], [[3]] ] "#;
        assert_eq!(
            rows(text),
            Ok(vec![
                "2021-03-24T00:00:00Z|1.5||a\"b|7|".to_owned(),
                "2".to_owned(),
                "3".to_owned(),
            ])
        );
        assert_eq!(rows(""), Ok(vec![]));
        assert_eq!(rows("[]"), Ok(vec![]));
    }

    #[test]
    fn what_is_no_row_is_refused() {
        for text in [
            "{}",
            "[1]",
            "[[1,2]]",
            "[[[1],[2]",
            "[[[1],[2]]",
            "[[[1],[\"2]]]",
            "[[[1],[{}]]]",
            "[] x",
            "[[[1],[2]]]]",
            "[[[1] [2]]]",
            "[[[1],[,]]]",
        ] {
            assert!(rows(text).is_err(), "{text}");
        }
        let deep = format!("[[[1],[{}", "[".repeat(100_000));
        assert!(rows(&deep).is_err());
    }
}
