//! Value of a tally's cell.

use super::{
    header::{OfUnit, unit_of},
    imported::Holds,
    layout::Laid,
};
use crate::{
    cells::{
        number::{self, Fault, Style, is_null_word},
        table::Cell,
    },
    columns::{column::Column, heading},
    error::TableErrorKind,
};

/// Returns the value of a cell; `None` if it is blank or a dash.
pub(crate) fn holds(
    cell: &Cell,
    laid: &Laid,
    style: Style,
) -> Result<Option<Holds>, TableErrorKind> {
    let text = cell.text.as_str();
    if is_blank(text) {
        return Ok(None);
    }
    let column = laid.column;
    if column == Column::Joints {
        return joints(cell, style);
    }
    if column.is_words() {
        return Ok(Some(Holds::Words));
    }
    if is_to_surface(text) {
        let is_length = column.dimension() == wholestring_units::Dimension::Length;
        return Ok(is_length.then_some(Holds::ToSurface));
    }
    if is_date(text) {
        return Err(TableErrorKind::DateCell { column });
    }
    let not_a_number = || TableErrorKind::NotANumber { column, found: text.to_owned() };
    let missing = || TableErrorKind::MissingReadingUnit { column, header: laid.heading.clone() };
    let quantity = |number: f64, (unit, dimension): OfUnit| {
        if unit.to_si(number).is_finite() {
            Ok(Some(Holds::Quantity { number, unit, dimension }))
        } else {
            Err(TableErrorKind::NotFinite { column, found: text.to_owned() })
        }
    };
    if let Some(number) = cell.number {
        // Neither blades nor joints: without them no unit is needed.
        return match laid.unit {
            Some(unit) => quantity(number, unit),
            None if number == 0.0 => Ok(None),
            None => Err(missing()),
        };
    }
    let (digits, rest) = part(text);
    let number = match number::read_or_fraction(digits, style) {
        Ok(number) => number,
        Err(Fault::NotFinite) => {
            return Err(TableErrorKind::NotFinite { column, found: text.to_owned() });
        }
        Err(Fault::NotANumber) => return Err(not_a_number()),
    };
    if rest.is_empty() {
        return match laid.unit {
            Some(unit) => quantity(number, unit),
            None if number == 0.0 => Ok(None),
            None => Err(missing()),
        };
    }
    match unit_of(column, rest) {
        Some((actual, unit)) if actual == column => quantity(number, unit),
        _ => Err(TableErrorKind::WrongUnit {
            column,
            found: rest.to_owned(),
            is: heading::dimension_of(rest),
        }),
    }
}

/// Splits a number from the text after its last digit.
pub(crate) fn part(text: &str) -> (&str, &str) {
    let is_digit = |c: char| c.is_ascii_digit() || "⅛¼⅜½⅝¾⅞".contains(c);
    let end = text.char_indices().rev().find(|(_, c)| is_digit(*c));
    let end = end.map_or(text.len(), |(at, c)| at + c.len_utf8());
    // The point of `5.` belongs to the number.
    let end = if text[end..].starts_with('.') { end + 1 } else { end };
    (text[..end].trim(), text[end..].trim())
}

/// Parses a number of joints: `9`, `9 jts`.
fn joints(cell: &Cell, style: Style) -> Result<Option<Holds>, TableErrorKind> {
    let column = Column::Joints;
    if is_to_surface(&cell.text) {
        return Ok(Some(Holds::ToSurface));
    }
    if is_date(&cell.text) {
        return Err(TableErrorKind::DateCell { column });
    }
    let (digits, rest) = part(&cell.text);
    let is_word = rest.chars().all(|c| c.is_alphabetic() || ". ".contains(c));
    let number = cell.number.or_else(|| number::read(digits, style).ok());
    match number {
        Some(number) if is_word && number >= 0.0 => {
            Ok((number > 0.0).then_some(Holds::Count(number)))
        }
        _ => Err(TableErrorKind::NotANumber { column, found: cell.text.clone() }),
    }
}

/// Whether a cell is empty, or contains a sign for a missing number.
pub(crate) fn is_blank(text: &str) -> bool {
    is_null_word(text) || ["tbc", "tba"].iter().any(|blank| text.eq_ignore_ascii_case(blank))
}

/// Whether the component fills the string to the surface.
pub(crate) fn is_to_surface(text: &str) -> bool {
    let lower = text.to_lowercase();
    let mut words = lower.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    let last = words.next_back();
    let before = words.next_back();
    matches!((before, last), (Some("to"), Some("surface" | "surf" | "rotary" | "rkb")))
}

/// Months, as spreadsheets write them.
const MONTHS: [&str; 12] =
    ["jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec"];

/// Whether a cell is a date that a spreadsheet made of `8-1/2`: a cell with a date, or its text
/// `08-Jan`, `1/8/2026`.
fn is_date(text: &str) -> bool {
    if text == "a date" {
        return true;
    }
    let parts: Vec<&str> =
        text.split([' ', '-', '/', '.', '–']).filter(|part| !part.is_empty()).collect();
    let is_number = |part: &&str| part.len() <= 4 && part.bytes().all(|b| b.is_ascii_digit());
    let is_month = |part: &&str| {
        let lower = part.to_lowercase();
        MONTHS.iter().any(|month| lower.starts_with(month))
            && lower.chars().all(char::is_alphabetic)
            && lower.len() <= 9
    };
    let has_month = parts.len() >= 2 && parts.iter().any(&is_month);
    let with_month = has_month && parts.iter().all(|part| is_month(part) || is_number(part));
    let slashes = text.matches(['/', '-', '.']).count();
    // Three numbers, one of which is a year.
    let three = parts.len() >= 3
        && slashes >= 2
        && parts.iter().take(3).all(is_number)
        && [parts[0], parts[2]].iter().any(|part| part.len() == 4);
    with_month || three
}

#[cfg(test)]
mod tests {
    use super::{is_blank, is_date, is_to_surface, part};

    #[test]
    fn dates_are_told_from_fractions_and_from_units() {
        for date in
            ["a date", "8-Jan", "08-Jan", "Jan-08", "1/8/2026", "2026-01-08", "8 January 2026"]
        {
            assert!(is_date(date), "{date}");
        }
        for number in ["8-1/2", "8 1/2", "12.25", "8.5 in", "1.234.567", "3-1/2\"", "5/8", "ft"] {
            assert!(!is_date(number), "{number}");
        }
    }

    #[test]
    fn a_number_is_parted_from_its_unit() {
        assert_eq!(part("8 1/2 in"), ("8 1/2", "in"));
        assert_eq!(part("8 1/2\""), ("8 1/2", "\""));
        assert_eq!(part("21.90#"), ("21.90", "#"));
        assert_eq!(part("5."), ("5.", ""));
        assert_eq!(part("8½"), ("8½", ""));
        assert_eq!(part("abc"), ("abc", ""));
    }

    #[test]
    fn what_is_no_number_may_be_nothing_or_all_the_rest() {
        assert!(is_to_surface("TO SURFACE") && is_to_surface("5 1/2 DP to surface"));
        assert!(!is_to_surface("surface") && !is_to_surface(""));
        assert!(is_blank("") && is_blank("--") && is_blank("N/A"));
        assert!(!is_blank("0") && !is_blank("-1"));
    }
}
