//! The unit that was probably intended by an unknown one.
//!
//! Users follow a wrong suggestion, so that no unit is suggested that differs from another by a
//! factor. `mbar` is not a misspelt `bar`, `deg/30ft` is not `deg/30m`, and a `ton` may be either
//! of two.

use crate::{
    Dimension, Unit,
    symbol::{LONGEST, bare},
};

/// Prefixes of SI and of field units, in lower case: a prefix makes another unit.
const PREFIXES: &[&str] = &[
    "da", "d", "c", "m", "u", "µ", "n", "p", "h", "k", "g", "t", "mega", "giga", "kilo", "milli",
    "micro", "centi", "deci", "hecto",
];

/// Unsupported units, or those of other quantities, in lower case: a text that contains one is not
/// misspelt.
const OTHERS: &[&str] = &[
    "bbl", "cwt", "d", "dyn", "furlong", "grain", "imp", "k", "kt", "kw", "mi", "mil", "mile",
    "nmi", "oz", "pdl", "pt", "qt", "slug", "st", "stone", "thou", "torr", "uk", "us", "w", "week",
    "yr",
];

/// Minimum length of a word that may have a wrong letter: in shorter words another letter is
/// another unit.
const SHORTEST: usize = 4;

/// The meanings of a unit that is not accepted because it is ambiguous.
pub(crate) fn meanings(written: &str) -> Option<&'static str> {
    let word = bare(written).to_lowercase();
    // A `tonne` is unambiguously 1000 kg.
    let is_ton = word.split('/').any(|part| {
        let rest = ["", "long", "uk", "metric"]
            .iter()
            .find_map(|kind| part.strip_prefix(kind)?.strip_prefix("ton"));
        rest.is_some_and(|rest| !rest.starts_with('n')) && !["tonfus", "tonus"].contains(&part)
    });
    is_ton.then_some(
        "a ton is 2000 lb to some, 2240 lb or 1000 kg to others; write 't' for 1000 kg, 'tonfUS' or \
         'tonUS' for 2000 lb",
    )
}

/// Returns the symbol of the unit whose spelling is nearest to an unknown one: the same except for
/// capitals, or for a letter that cannot change its value.
pub(crate) fn nearest(units: &'static [Unit], written: &str) -> Option<&'static str> {
    if written.len() > LONGEST || meanings(written).is_some() {
        return None;
    }
    let bare_written = bare(written);
    let written = bare_written.to_lowercase();
    let first = |text: &str| text.chars().next();
    let mut best: Option<(usize, &'static Unit)> = None;
    let mut differs = false;
    for unit in units {
        for spelling in unit.spellings() {
            let bare_spelling = bare(spelling);
            let spelling = bare_spelling.to_lowercase();
            let Some(distance) = misspelt(&written, &spelling) else { continue };
            // Milli is never mega.
            if first(&spelling) == Some('m') && first(&bare_spelling) != first(&bare_written) {
                continue;
            }
            match best {
                Some((least, _)) if least < distance => {}
                Some((least, other)) if least == distance => {
                    differs |= other.factor != unit.factor;
                }
                _ => (best, differs) = (Some((distance, unit)), false),
            }
        }
    }
    best.filter(|_| !differs).map(|(_, unit)| unit.symbol)
}

/// Distance of a spelling from the written text; `None` if their values may differ.
fn misspelt(written: &str, spelling: &str) -> Option<usize> {
    if written == spelling {
        return Some(0);
    }
    let (words, others) = (words(written), words(spelling));
    if words.len() != others.len() {
        return None;
    }
    let mut distance = 0;
    for (word, other) in words.iter().zip(&others) {
        if word == other {
            continue;
        }
        let is_letters = |text: &str| text.chars().all(char::is_alphabetic);
        if !is_letters(word) || !is_letters(other) || is_unit(word) {
            return None;
        }
        distance += slip(word, other)?;
    }
    (distance > 0).then_some(distance)
}

/// Number of letters that were doubled, swapped or mistaken within a word.
fn slip(word: &str, other: &str) -> Option<usize> {
    let count = |text: &str| text.chars().count();
    let (longest, shortest) = (count(word).max(count(other)), count(word).min(count(other)));
    // Checked first: the distance is quadratic in the lengths.
    if longest - shortest > longest.div_ceil(3) || word.chars().next() != other.chars().next() {
        return None;
    }
    let single = |text: &str| {
        let mut letters: Vec<char> = text.chars().collect();
        letters.dedup();
        letters
    };
    let is_doubled = shortest >= 2 && single(word).len() >= 2 && single(word) == single(other);
    let distance = strsim::damerau_levenshtein(word, other);
    // `pis` is `psi`: the same letters in another order.
    let sorted = |text: &str| {
        let mut letters: Vec<char> = text.chars().collect();
        letters.sort_unstable();
        letters
    };
    let is_swapped = shortest >= 3 && distance == 1 && sorted(word) == sorted(other);
    let is_near = shortest >= SHORTEST && distance <= longest.div_ceil(4);
    (is_doubled || is_swapped || is_near).then_some(distance)
}

/// The words, numbers and signs of a unit.
fn words(text: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let sort = |c: char| (c.is_alphabetic(), c.is_ascii_digit());
    let mut before = None;
    for c in text.chars() {
        match words.last_mut() {
            Some(word) if before == Some(sort(c)) => word.push(c),
            _ => words.push(c.to_string()),
        }
        before = Some(sort(c));
    }
    words
}

/// Whether a word is a unit of any dimension, with or without a prefix.
fn is_unit(word: &str) -> bool {
    let known = |text: &str| {
        OTHERS.contains(&text)
            || Dimension::ALL.iter().any(|dimension| dimension.find_unit(text).is_some())
    };
    let is_imperial = word.ends_with("uk") || word.starts_with("imp");
    is_imperial
        || known(word)
        || PREFIXES.iter().any(|prefix| {
            // A doubled letter is a typing error.
            let rest = word.strip_prefix(prefix).filter(|rest| !rest.starts_with(prefix));
            rest.is_some_and(known)
        })
}

#[cfg(test)]
mod tests {
    use super::nearest;
    use crate::Dimension;

    /// No unit with another value is suggested.
    #[test]
    fn what_is_another_unit_is_no_misspelling() {
        for (dimension, written) in [
            (Dimension::Force, "ton"),
            (Dimension::Force, "tons"),
            (Dimension::Force, "tonfUK"),
            (Dimension::Force, "tonfm"),
            (Dimension::Force, "cN"),
            (Dimension::Force, "GN"),
            (Dimension::Force, "mN"),
            (Dimension::Force, "dN"),
            (Dimension::Force, "klbm/ft"),
            (Dimension::Pressure, "mbar"),
            (Dimension::Pressure, "kbar"),
            (Dimension::Pressure, "hPa"),
            (Dimension::Pressure, "uPa"),
            (Dimension::Pressure, "torr"),
            (Dimension::Torque, "cN.m"),
            (Dimension::Torque, "oz-in"),
            (Dimension::Length, "mi"),
            (Dimension::Length, "dm"),
            (Dimension::Length, "um"),
            (Dimension::Length, "nmi"),
            (Dimension::DoglegSeverity, "deg/30ft"),
            (Dimension::DoglegSeverity, "deg/100m"),
            (Dimension::DoglegSeverity, "deg/300m"),
            (Dimension::MassPerLength, "kg/ft"),
            (Dimension::MassPerLength, "lb/m"),
            (Dimension::MassPerLength, "g/m"),
            (Dimension::Density, "kg/ft3"),
            (Dimension::Density, "lb/bbl"),
            (Dimension::Density, "mg/m3"),
            (Dimension::FlowRate, "gal/h"),
            (Dimension::FlowRate, "galUK/min"),
            (Dimension::FlowRate, "bbl/h"),
            (Dimension::RateOfPenetration, "m/d"),
            (Dimension::RateOfPenetration, "km/h"),
            (Dimension::RotarySpeed, "rph"),
            (Dimension::Viscosity, "uPa.s"),
            (Dimension::Time, "us"),
            (Dimension::Time, "week"),
        ] {
            assert_eq!(nearest(dimension.units(), written), None, "{written}");
        }
    }

    /// Typing errors are recognised.
    #[test]
    fn a_misspelling_is_one() {
        for (dimension, written, meant) in [
            (Dimension::Density, "sgg", "sg"),
            (Dimension::Density, "pppg", "ppg"),
            (Dimension::Pressure, "pis", "psi"),
            (Dimension::Length, "metrs", "m"),
            (Dimension::Length, "feett", "ft"),
            (Dimension::Force, "klbff", "klbf"),
            (Dimension::Force, "tonnees", "t"),
            (Dimension::Torque, "kft-lbff", "kft-lbf"),
            (Dimension::DoglegSeverity, "degr/30m", "deg/30m"),
            (Dimension::RotarySpeed, "rppm", "rpm"),
        ] {
            assert_eq!(nearest(dimension.units(), written), Some(meant), "{written}");
        }
    }
}
