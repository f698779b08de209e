//! The screen: a small table, and whether text is coloured.

use std::{
    env,
    io::{self, IsTerminal},
};

/// Space between columns.
const GAP: usize = 2;

/// Rows of cells under headings. Words are aligned left, numbers right.
pub(crate) struct Table {
    title: String,
    /// Number of columns of words; they precede the numbers.
    words: usize,
    rows: Vec<Vec<String>>,
}

impl Table {
    pub(crate) fn new(title: &str, words: usize, headings: &[&str]) -> Self {
        Self {
            title: title.to_owned(),
            words,
            rows: vec![headings.iter().map(|text| (*text).to_owned()).collect()],
        }
    }

    /// Adds a row, with one cell for each heading.
    pub(crate) fn row(&mut self, cells: Vec<String>) {
        self.rows.push(cells);
    }

    pub(crate) fn text(&self) -> String {
        let width = |column: usize| {
            let cells = self.rows.iter().map(|row| row[column].chars().count());
            cells.max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..self.rows[0].len()).map(width).collect();
        let across = widths.iter().sum::<usize>() + GAP * (widths.len() - 1);
        let mut text = format!("{}\n", self.title);
        for (index, row) in self.rows.iter().enumerate() {
            let mut line = String::new();
            for (column, (cell, &width)) in row.iter().zip(&widths).enumerate() {
                let gap = if column == 0 { 0 } else { GAP };
                line += &if column < self.words {
                    format!("{:gap$}{cell:<width$}", "")
                } else {
                    format!("{:gap$}{cell:>width$}", "")
                };
            }
            text += line.trim_end();
            text.push('\n');
            if index == 0 {
                text += &"─".repeat(across);
                text.push('\n');
            }
        }
        text
    }
}

// Whether text is coloured: on a terminal, unless the user has turned colours off.

/// Whether diagnostics are coloured: on a terminal, unless the user has turned colours off.
pub(crate) fn color() -> bool {
    io::stderr().is_terminal() && env::var_os("NO_COLOR").is_none_or(|no| no.is_empty())
}

/// Whether text on standard output is coloured.
pub(crate) fn screen_color() -> bool {
    io::stdout().is_terminal() && env::var_os("NO_COLOR").is_none_or(|no| no.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_to_the_left_numbers_to_the_right() {
        let mut table = Table::new("Wells", 1, &["name", "depth"]);
        table.row(vec!["a".to_owned(), "1000".to_owned()]);
        table.row(vec!["Süd 2".to_owned(), "20.5 m".to_owned()]);
        assert_eq!(
            table.text(),
            "Wells\n\
             name    depth\n\
             ─────────────\n\
             a        1000\n\
             Süd 2  20.5 m\n"
        );
    }
}
