//! Meaning of a heading: its column and unit.

use wholestring_units::{Dimension, Unit};

use super::names::Sort;
use crate::columns::{
    column::Column,
    names::{NAMES, columns_named, is_beside, is_subsea, written_out},
    words::Words,
};

/// A heading that names a column.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Heading {
    pub(crate) column: Column,
    /// Rank: of two headings for one column the lower is used.
    pub(crate) rank: u8,
    pub(crate) unit: HeadingUnit,
}

/// The unit in a heading.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum HeadingUnit {
    None,
    Unit(&'static Unit),
    /// A text in brackets that is not a unit of the column's dimension.
    Wrong {
        found: String,
        is: Option<Dimension>,
    },
}

/// Maximum length of a heading, bytes; longer texts are sentences.
const LONGEST: usize = 80;

/// Maximum number of words of a unit, such as `ft MD KB`.
const UNIT_WORDS: usize = 3;

/// Parses a heading that names a column of this sort of table.
pub(crate) fn recognise(text: &str, sort: &Sort) -> Option<Heading> {
    // Most cells are numbers, which do not name a column.
    if text.len() > LONGEST || !text.contains(char::is_alphabetic) {
        return None;
    }
    let (name, brackets) = part_brackets(text);
    let words = Words::of(&name);
    let mut inside = Words::default();
    brackets.iter().for_each(|bracket| inside.add(bracket));
    if words.lower().chain(inside.lower()).any(is_subsea) {
        return None;
    }

    // "MD (m)": the whole name; "md_m": its last word is the unit; "MD ftKB": its last words.
    let all = words.len();
    let (column, mut rank, last) = match named(&words, all, sort) {
        Some((column, rank)) => (column, rank, None),
        None => (1..all.min(UNIT_WORDS + 1)).find_map(|count| {
            let (column, rank) = named(&words, all - count, sort)?;
            let unit = column.dimension().find_unit(words.written_after(all - count))?;
            Some((column, rank, Some(unit)))
        })?,
    };
    let has = |word: &str| words.lower().chain(inside.lower()).any(|other| other == word);
    match column {
        Column::Azimuth if has("grid") || has("corr") || has("corrected") => rank = 0,
        Column::Azimuth if has("true") => rank = 2,
        Column::Azimuth if has("mag") || has("magnetic") => rank = 3,
        Column::North | Column::East if has("map") => rank = 1,
        _ => {}
    }
    let unit = match last {
        Some(unit) => HeadingUnit::Unit(unit),
        None => unit_in(column, &brackets, sort),
    };
    Some(Heading { column, rank, unit })
}

/// The unit that a cell in a row of units names: `ft`, `(ft)`, `[ft]`.
pub(crate) fn bare_unit(text: &str) -> &str {
    text.trim().trim_matches(['(', ')', '[', ']', '{', '}']).trim()
}

/// Whether a text is a unit of any dimension.
pub(crate) fn dimension_of(text: &str) -> Option<Dimension> {
    Dimension::ALL.iter().copied().find(|dimension| dimension.find_unit(text).is_some())
}

/// Returns how similar the column's name is to a heading, from 0 to 1.
pub(crate) fn nearness(column: Column, text: &str) -> f64 {
    let (name, _) = part_brackets(text);
    let words = Words::of(&name);
    let written = words.first(words.len());
    if written.is_empty() || written.len() > LONGEST {
        return 0.0;
    }
    NAMES
        .iter()
        .filter(|(named, _, _)| *named == column)
        .flat_map(|(_, _, names)| names.split(' '))
        .map(|name| strsim::normalized_damerau_levenshtein(name, written))
        .fold(0.0, f64::max)
}

/// The column named by the first `count` words.
fn named(words: &Words, count: usize, sort: &Sort) -> Option<(Column, u8)> {
    let find = |joined: &str| {
        columns_named(joined).iter().find(|(column, _)| sort.columns.contains(column)).copied()
    };
    find(words.first(count))
        .or_else(|| {
            let first = || words.lower().take(count);
            // Without such a word there are no other candidates.
            first().any(is_beside).then_some(())?;
            let core: String = first().filter(|word| !is_beside(word)).collect();
            find(&core)
        })
        .or_else(|| {
            // "Tq off btm": only in readings, where no other column has this name.
            let is_read = sort.columns.contains(&Column::BitDepth);
            let first = || words.lower().take(count);
            (is_read && first().any(|word| written_out(word) != word)).then_some(())?;
            let whole: String = first().filter(|word| !is_beside(word)).map(written_out).collect();
            find(&whole)
        })
}

/// The unit in the bracketed parts of a heading.
fn unit_in(column: Column, brackets: &[String], sort: &Sort) -> HeadingUnit {
    let dimension = column.dimension();
    if let Some(unit) = brackets.iter().find_map(|bracket| dimension.find_unit(bracket)) {
        return HeadingUnit::Unit(unit);
    }
    // "Measured Depth (MD)", "Azimuth (T)", "MD (RKB)", "N(+)/S(-)": brackets without units.
    let meant_otherwise = |bracket: &String| {
        let words = Words::of(bracket);
        let beside =
            |word: &str| word.chars().count() == 1 && column == Column::Azimuth || is_beside(word);
        words.lower().all(beside) || named(&words, words.len(), sort).is_some()
    };
    match brackets.iter().find(|bracket| !meant_otherwise(bracket)) {
        Some(bracket) => HeadingUnit::Wrong { found: bracket.clone(), is: dimension_of(bracket) },
        None => HeadingUnit::None,
    }
}

/// A heading without its bracketed parts, and these parts.
pub(crate) fn part_brackets(text: &str) -> (String, Vec<String>) {
    let mut name = String::new();
    let mut brackets = Vec::new();
    let mut inside: Option<String> = None;
    for c in text.chars() {
        match (c, &mut inside) {
            ('(' | '[' | '{', None) => inside = Some(String::new()),
            (')' | ']' | '}', Some(bracket)) => {
                brackets.push(bracket.trim().to_owned());
                inside = None;
                name.push(' ');
            }
            (c, Some(bracket)) => bracket.push(c),
            (c, None) => name.push(c),
        }
    }
    brackets.extend(inside.map(|bracket| bracket.trim().to_owned()));
    brackets.retain(|bracket| !bracket.is_empty());
    (name, brackets)
}

#[cfg(test)]
mod tests {
    use super::{super::names::SURVEY, Column, HeadingUnit, recognise};

    #[test]
    fn common_headings_are_recognised() {
        use Column::*;
        for (text, column, unit) in [
            ("MD (m)", MeasuredDepth, "m"),
            ("MD[m]", MeasuredDepth, "m"),
            ("md_m", MeasuredDepth, "m"),
            ("MD m", MeasuredDepth, "m"),
            ("MD (M)", MeasuredDepth, "m"),
            ("MD, ft", MeasuredDepth, "ft"),
            ("#MD (usft)", MeasuredDepth, "usft"),
            ("Measured Depth ( ft )", MeasuredDepth, "ft"),
            ("MeasuredDepth_ft", MeasuredDepth, "ft"),
            ("Measured Depth RKB (ft)", MeasuredDepth, "ft"),
            ("Measured Depth (MD) [m]", MeasuredDepth, "m"),
            ("DEPTH (FEET)", MeasuredDepth, "ft"),
            ("Depth (metres)", MeasuredDepth, "m"),
            ("Inc[deg]", Inclination, "deg"),
            ("MD (ftKB)", MeasuredDepth, "ft"),
            ("MD ftKB", MeasuredDepth, "ft"),
            ("Measured Depth [m RT]", MeasuredDepth, "m"),
            ("Depth (ftMDRKB)", MeasuredDepth, "ft"),
            ("TVD (mTVDRT)", TrueVerticalDepth, "m"),
            ("inc_deg", Inclination, "deg"),
            ("INCL", Inclination, ""),
            ("Incl. (°)", Inclination, "deg"),
            ("Inclination °", Inclination, "deg"),
            ("Hole Angle (deg)", Inclination, "deg"),
            ("inc_rad", Inclination, "rad"),
            ("Azimuth Grid ( deg )", Azimuth, "deg"),
            ("Azi", Azimuth, ""),
            ("AZ (T)", Azimuth, ""),
            ("azi_deg", Azimuth, "deg"),
            ("True Azimuth [dega]", Azimuth, "deg"),
            ("TVD", TrueVerticalDepth, ""),
            ("True Vertical Depth (m)", TrueVerticalDepth, "m"),
            ("Vertical Depth (ft)", TrueVerticalDepth, "ft"),
            ("North", North, ""),
            ("N/S (ft)", North, "ft"),
            ("+N/-S (ft)", North, "ft"),
            ("N(+)/S(-) (m)", North, "m"),
            ("Northing ( m )", North, "m"),
            ("east_m", East, "m"),
            ("+E/-W", East, ""),
        ] {
            let heading = recognise(text, &SURVEY).unwrap_or_else(|| panic!("{text}"));
            assert_eq!(heading.column, column, "{text}");
            match heading.unit {
                HeadingUnit::Unit(found) => assert_eq!(found.symbol, unit, "{text}"),
                HeadingUnit::None => assert_eq!(unit, "", "{text}"),
                HeadingUnit::Wrong { found, .. } => panic!("{text}: {found}"),
            }
        }
    }

    #[test]
    fn other_headings_are_not() {
        for text in [
            "TVDSS (m)",
            "TVD SS",
            "TVD (subsea)",
            "TVD (mMSL)",
            "DLS (deg/30m)",
            "Dogleg",
            "Vertical Section",
            "Tool face",
            "Comment",
            "well",
            "Survey",
            "Date",
            "#",
            "",
            "1500.0",
            "Closure",
            "Inclination error model",
            "Build rate",
        ] {
            assert_eq!(recognise(text, &SURVEY), None, "{text}");
        }
    }

    #[test]
    fn a_unit_of_something_else_is_kept_for_the_error() {
        for (text, unit) in [("MD (deg)", "deg"), ("Inc (furlong)", "furlong")] {
            match recognise(text, &SURVEY).map(|heading| heading.unit) {
                Some(HeadingUnit::Wrong { found, .. }) => assert_eq!(found, unit),
                other => panic!("{text}: {other:?}"),
            }
        }
    }

    #[test]
    fn grid_comes_before_true_and_true_before_magnetic() {
        let rank = |text| recognise(text, &SURVEY).map(|heading| heading.rank);
        assert!(rank("Azimuth (grid)") < rank("Azimuth"));
        assert!(rank("Azimuth") < rank("Azimuth True"));
        assert!(rank("Azimuth True") < rank("Azimuth Magnetic"));
        assert!(rank("MD") < rank("Depth"));
        assert!(rank("N/S") < rank("Northing"));
        assert!(rank("N/S") < rank("Map North"));
    }
}
