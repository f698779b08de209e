//! A table of a study: as data, as Markdown, and for the page.

use wholestring_results::{Column, Table};
use wholestring_study::{NumberTable, Row, Wanted};
use wholestring_units::{UnitSet, significant, without_trailing_zeros};

use super::{
    Grid, StudyPart, Verdict,
    figure::{Series, names, unit},
};
use crate::grid_cells::head;

/// A table of a study with its computed numbers.
#[derive(Debug, Clone)]
pub struct StudyTable<'a> {
    /// The table.
    pub table: &'a NumberTable,
    /// Series of the columns.
    pub series: Vec<Series>,
    /// By row and series; `None` if there is no result, or none was requested.
    pub numbers: Vec<Vec<Option<f64>>>,
    /// Names of the sweeps of the study.
    pub sweeps: &'a [String],
    /// Units of the grid.
    pub units: UnitSet,
}

impl StudyTable<'_> {
    /// The table as it is on the page; its files are in `tables`.
    pub fn part(&self, grid: Grid) -> StudyPart {
        StudyPart::Table {
            title: self.table.title.clone(),
            caption: self.table.caption.clone(),
            grid,
            files: format!("tables/{}", self.table.name),
            endings: &["md", "csv"],
        }
    }

    /// Data of the table: a row for each number and series, in SI.
    pub fn data(&self) -> Table {
        let rows = self.table.rows.iter().zip(&self.numbers);
        let cells: Vec<_> = rows
            .flat_map(|(row, numbers)| {
                let numbers = self.series.iter().zip(numbers);
                numbers.filter_map(move |(series, number)| Some((row, series, (*number)?)))
            })
            .collect();
        let word = |name: &str, word: &dyn Fn(&Row, &Series, f64) -> &'static str| {
            let words = cells.iter().map(|(row, series, value)| word(row, series, *value));
            Column::words(name, words.map(str::to_owned).collect())
        };
        let text = |name: &str, text: &dyn Fn(&Row, &Series) -> String| {
            Column::words(name, cells.iter().map(|(row, series, _)| text(row, series)).collect())
        };
        let number = |name: &str, number: &dyn Fn(&Row) -> Option<f64>| {
            Column::numbers(name, cells.iter().map(|(row, ..)| number(row)).collect())
        };
        Table::new(vec![
            text("label", &|row, _| row.label.clone()),
            text("source", &|row, _| row.source.clone()),
            text("sweep", &|_, series| self.sweeps[series.0].clone()),
            word("model", &|_, series, _| series.1.name()),
            word("operation", &|_, series, _| series.2.name()),
            word("unit", &|row, _, _| {
                row.dimension().map_or("", |dimension| dimension.si_symbol())
            }),
            number("expected", &|row| row.wanted.expected),
            number("least", &|row| row.wanted.least),
            number("most", &|row| row.wanted.most),
            Column::numbers("computed", cells.iter().map(|(.., value)| Some(*value)).collect()),
            word("agrees", &|row, _, value| match agrees(row, value) {
                Some(true) => "yes",
                Some(false) => "no",
                None => "",
            }),
        ])
    }

    /// The table in display units.
    pub fn grid(&self) -> Grid {
        let sources = self.table.rows.iter().any(|row| !row.source.is_empty());
        let mut heads = vec![head("", true), head("unit", true), head("given", false)];
        let series = names(&self.series, self.sweeps).into_iter();
        heads.extend(series.map(|name| head(name, false)));
        heads.extend(sources.then(|| head("given in", true)));
        let rows = self.table.rows.iter().zip(&self.numbers);
        let rows = rows.map(|(row, numbers)| {
            let (symbol, worth) = unit(row.dimension(), "", self.units);
            let mut cells = vec![
                (row.label.clone(), Verdict::None),
                (symbol, Verdict::None),
                (given(&row.wanted, worth), Verdict::None),
            ];
            for number in numbers {
                cells.push(match number {
                    Some(number) => (against(row, *number, worth), verdict(row, *number)),
                    None => (String::new(), Verdict::None),
                });
            }
            if sources {
                cells.push((row.source.clone(), Verdict::None));
            }
            cells
        });
        let rows = rows.collect();
        Grid { heads, rows }
    }

    /// The grid as Markdown.
    pub fn markdown(&self, grid: &Grid) -> String {
        let line = |cells: &mut dyn Iterator<Item = String>| {
            let cells: Vec<String> = cells.map(|cell| cell.replace('|', "\\|")).collect();
            format!("| {} |\n", cells.join(" | "))
        };
        let mut text = format!("# {}\n\n", self.table.title);
        text += &line(&mut grid.heads.iter().map(|head| head.text.clone()));
        text += &line(&mut grid.heads.iter().map(|_| "---".to_owned()));
        for row in &grid.rows {
            text += &line(&mut row.iter().map(|(cell, verdict)| match verdict {
                Verdict::Differs => format!("**{cell}**"),
                _ => cell.clone(),
            }));
        }
        let caption = &self.table.caption;
        if !caption.is_empty() {
            text += &format!("\n{caption}\n");
        }
        text += "\nNumbers in bold type differ from the given ones by more than is allowed.\n";
        text
    }
}

/// Whether a computed number agrees with the expected one; `None` if there is none.
fn agrees(row: &Row, computed: f64) -> Option<bool> {
    let target = &row.wanted;
    let any = target.least.is_some() || target.most.is_some();
    any.then(|| {
        target.least.is_none_or(|least| computed >= least)
            && target.most.is_none_or(|most| computed <= most)
    })
}

fn verdict(row: &Row, number: f64) -> Verdict {
    match agrees(row, number) {
        None => Verdict::None,
        Some(true) => Verdict::Agrees,
        Some(false) => Verdict::Differs,
    }
}

/// Text of the expected value: `13.61 ± 1.089`, `at least 0.95`.
fn given(target: &Wanted, worth: f64) -> String {
    let show = |value: f64| as_given(value / worth);
    let bounds = (target.least, target.most);
    match (target.expected, bounds) {
        (Some(expected), (Some(least), Some(most)))
            if (least + most - 2.0 * expected).abs() <= 1e-6 * (most - least) =>
        {
            let off = expected - least;
            let percent = 100.0 * off / expected.abs();
            // A tolerance with so few digits was written in percent.
            let share = significant(percent, 2);
            match (share - percent).abs() <= 1e-6 * percent {
                true => format!("{} ± {share} %", show(expected)),
                false => format!("{} ± {}", show(expected), short(off / worth)),
            }
        }
        (Some(expected), (None, None)) => show(expected),
        (Some(expected), bounds) => format!("{} ({})", show(expected), between(bounds, show)),
        (None, bounds) => between(bounds, show),
    }
}

fn between(bounds: (Option<f64>, Option<f64>), show: impl Fn(f64) -> String) -> String {
    match bounds {
        (Some(least), Some(most)) => format!("{} to {}", show(least), show(most)),
        (Some(least), None) => format!("at least {}", show(least)),
        (None, Some(most)) => format!("at most {}", show(most)),
        (None, None) => String::new(),
    }
}

/// A computed number and its deviation from the expected one.
fn against(row: &Row, number: f64, worth: f64) -> String {
    let value = short(number / worth);
    match row.wanted.expected.filter(|expected| *expected != 0.0) {
        Some(expected) => {
            let off = 100.0 * (number - expected) / expected.abs();
            let off = if off.abs() < 0.05 { 0.0 } else { off };
            format!("{value} ({off:+.1} %)").replace('-', "\u{2212}").replace("+0.0 %", "0.0 %")
        }
        None => value.replace('-', "\u{2212}"),
    }
}

/// A number as written: all of its digits, if there are at most seven.
fn as_given(value: f64) -> String {
    let whole = significant(value, 7);
    let written = format!("{whole}");
    match (whole - value).abs() <= 1e-12 * value.abs() && written.len() <= 9 {
        true => written.replace('-', "\u{2212}"),
        false => short(value),
    }
}

/// A number in four digits.
fn short(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let size = libm::log10(value.abs()).floor();
    if !(-5.0..7.0).contains(&size) {
        let text = format!("{value:.3e}");
        let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
        let power = power.chars().map(raised).collect::<String>();
        return format!("{digits}·10{power}").replace('-', "\u{2212}");
    }
    let decimals = (3.0 - size).max(0.0) as usize;
    let text = format!("{value:.decimals$}").replace('-', "\u{2212}");
    without_trailing_zeros(&text).to_owned()
}

/// A digit or a minus sign as an exponent.
fn raised(letter: char) -> char {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    match letter.to_digit(10) {
        Some(digit) => DIGITS[digit as usize],
        None => '⁻',
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        for (value, expected) in [
            (13.612_345, "13.61"),
            (0.0, "0"),
            (1075.04, "1075"),
            (43_051.0, "43051"),
            (0.012_34, "0.01234"),
            (2.0, "2"),
            (-8.715e-5, "\u{2212}0.00008715"),
            (1.234e-9, "1.234·10⁻⁹"),
        ] {
            assert_eq!(short(value), expected);
        }
        for (value, expected) in [
            (579.6152, "579.6152"),
            (0.999_999, "0.999999"),
            (-13.61, "\u{2212}13.61"),
            (34.6e3 / 1.355_817_948_331_4, "25520"),
            (1e-6, "0.000001"),
        ] {
            assert_eq!(as_given(value), expected);
        }
    }

    /// A tolerance is shown as written: in percent or as a quantity.
    #[test]
    fn what_is_given_is_shown_as_it_was_written() {
        let row = |expected: f64, least: f64, most: f64| {
            let target = Wanted { expected: Some(expected), least: Some(least), most: Some(most) };
            given(&target, 1e3)
        };
        assert_eq!(row(13.61e3, 0.92 * 13.61e3, 1.08 * 13.61e3), "13.61 ± 8 %");
        assert_eq!(row(4124e3, 4123e3, 4125e3), "4124 ± 1");
        assert_eq!(row(2e3, 1e3, 4e3), "2 (1 to 4)");
    }
}
