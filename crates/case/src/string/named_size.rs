//! The size with which a component's name begins, compared with its body.

use wholestring::string::DrillString;
use wholestring_config::prelude::*;

use crate::string::component::ComponentTable;

/// Largest difference between a size and the outside diameter that it stands for, m: sizes are
/// rounded to sixteenths of an inch.
const ROUNDED_M: f64 = 0.0254 / 16.0 + 1e-6;

/// Words of components whose size is the outside diameter of the body. Bits, stabilisers, reamers
/// and rotary steerables are also called by their gauge or by the hole, subs by their thread.
const BY_BODY: [&str; 17] = [
    "pipe",
    "pipes",
    "dp",
    "drillpipe",
    "hwdp",
    "hw",
    "heavy",
    "collar",
    "collars",
    "dc",
    "dcs",
    "nmdc",
    "casing",
    "liner",
    "tubing",
    "motor",
    "jar",
];

/// Words of components that are called by their gauge, the hole or a thread, although one of
/// [`BY_BODY`] is in the name too.
const BY_OTHER: [&str; 16] = [
    "bit",
    "stab",
    "reamer",
    "opener",
    "hole",
    "sub",
    "crossover",
    "xo",
    "if",
    "fh",
    "reg",
    "shoe",
    "scraper",
    "hanger",
    "gauge",
    "sleeve",
];

/// Units of sizes in names.
const INCHES: [&str; 7] = ["inches", "inch", "in", "\"", "''", "”", "″"];

/// Warns of a component whose name begins with the size of another body.
pub(crate) fn check(
    string: &DrillString,
    components: &[Spanned<ComponentTable>],
    reader: &mut Reader,
) {
    for (part, table) in string.components().iter().zip(components) {
        let Some(size) = NamedSize::of(&part.name) else { continue };
        if (size.od_m - part.od_m).abs() < ROUNDED_M {
            continue;
        }
        // Worn pipe keeps its nominal size.
        let listed = table.value.catalogue.given();
        let nominal = listed.and_then(|entry| NamedSize::begins(&entry.value));
        if nominal.is_some_and(|nominal| (size.od_m - nominal.od_m).abs() < ROUNDED_M) {
            continue;
        }
        let Some(name) = table.value.component.at() else { continue };
        Diagnostic::warning(format!(
            "`{}` has a body of {}, not {}",
            short(&part.name),
            reader.shown(Dimension::Diameter, part.od_m),
            size.text
        ))
        .at(name.place, "the name begins with a size")
        .at(
            table.value.od_place(table.place),
            format!("outside diameter {}", reader.shown(Dimension::Diameter, part.od_m)),
        )
        .help("the name has no effect: correct the name, or the diameter or entry of the catalogue")
        .report(reader);
    }
}

/// A size at the beginning of a name.
#[derive(Debug, PartialEq)]
struct NamedSize<'a> {
    /// The size as written, with its unit.
    text: &'a str,
    od_m: f64,
    /// The name after the size.
    rest: &'a str,
}

impl<'a> NamedSize<'a> {
    /// Returns the size of a name that is the outside diameter of a body.
    fn of(name: &'a str) -> Option<Self> {
        let size = Self::begins(name)?;
        let lower = size.rest.to_lowercase();
        let words = || lower.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
        let is_other = |word: &str| BY_OTHER.contains(&word) || word.starts_with("stabili");
        let is_body = words().next().is_none() || words().any(|word| BY_BODY.contains(&word));
        (is_body && !words().any(is_other)).then_some(size)
    }

    /// Returns the size at the beginning of a text: `5-7/8 in`, `5 7/8"`, `5.5in`, `127 mm`. A
    /// number without a unit is a size only with a fraction, because it may be a count.
    fn begins(text: &'a str) -> Option<Self> {
        let digits = |c: char| c.is_ascii_digit() || "./- ".contains(c);
        let end = text.find(|c| !digits(c)).unwrap_or(text.len());
        let number = text[..end].trim_end_matches([' ', '-', '.', '/']);
        if !number.starts_with(|c: char| c.is_ascii_digit()) {
            return None;
        }
        let after = text[number.len()..].trim_start_matches([' ', '-']);
        let unit = |unit: &&str| {
            let rest = after.strip_prefix(*unit);
            let is_word = unit.ends_with(|c: char| c.is_alphabetic());
            rest.is_some_and(|rest| !(is_word && rest.starts_with(|c: char| c.is_alphanumeric())))
        };
        let found = INCHES.iter().chain(&["mm"]).find(|known| unit(known)).copied();
        if found.is_none() && !number.contains('/') {
            return None;
        }
        let rest = &after[found.map_or(0, str::len)..];
        let symbol = if found == Some("mm") { "mm" } else { "in" };
        let od_m = Dimension::Diameter.parse(&format!("{number} {symbol}")).ok()?;
        Some(Self { text: text[..text.len() - rest.len()].trim_end(), od_m, rest })
    }
}

#[cfg(test)]
mod tests {
    use super::NamedSize;

    #[test]
    fn sizes_of_bodies_are_read_and_others_are_not() {
        for (name, inches) in [
            ("5-7/8 in drill pipe", 5.875),
            ("5 7/8\" DP", 5.875),
            ("6-5/8 in drill pipe", 6.625),
            ("5.5in DP", 5.5),
            ("5 in HWDP", 5.0),
            ("127 mm drill pipe", 5.0),
            ("6 3/4 collars", 6.75),
            ("8-inch DC", 8.0),
            ("13-3/8 in casing", 13.375),
            ("5 in", 5.0),
        ] {
            let size = NamedSize::of(name).unwrap_or_else(|| panic!("{name} has a size"));
            assert!((size.od_m / 0.0254 - inches).abs() < 1e-9, "{name}: {}", size.od_m);
        }
        for name in [
            "8.5 in bit",
            "8-1/4 in stabiliser",
            "8 1/4\" string stab",
            "12-1/4 in roller reamer",
            "8-1/2 in RSS",
            "4-1/2 IF crossover to drill pipe",
            "drill pipe 5 in",
            "3 drill collars",
            "12 x 5\" HWDP",
            "2 in 1 tool",
            "drill pipe",
            "",
            "-",
        ] {
            assert_eq!(NamedSize::of(name), None, "{name}");
        }
    }
}
