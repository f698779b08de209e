//! The same mistakes in a case that is displayed in field units: no message has a quantity in other
//! units.

use crate::common::read;

/// Units of the other sets that field units have another for.
const OTHERS: [&str; 17] = [
    "mm", "m", "km", "N", "kN", "N.m", "kN.m", "kg/m", "kg/m3", "sg", "Pa", "MPa", "GPa", "bar",
    "m/s", "m/h", "t",
];

/// Requires that the message for a case in field units shows no quantity in other units. Exceptions
/// are texts in quotes, which the case has or may have unchanged, quantities that are shown in
/// both, and the range of a number, which is in the unit of that number.
#[track_caller]
pub(crate) fn required(name: &str, text: &str) {
    let report = match read(&format!("units = \"field\"\n{text}")) {
        Ok(case) => case.warnings,
        Err(report) => report,
    };
    for diagnostic in &report.diagnostics {
        let labels = diagnostic.labels.iter().map(|label| &label.text);
        for sentence in labels.chain([&diagnostic.message]).chain(&diagnostic.help) {
            let found = in_other_units(sentence);
            assert!(found.is_none(), "`{name}`: {} in \"{sentence}\"", found.unwrap_or_default());
        }
    }
}

/// A number with a unit of the others, outside quotes.
fn in_other_units(sentence: &str) -> Option<String> {
    let is_range = sentence.starts_with("expected ")
        && [" to ", " and at most "].iter().any(|between| sentence.contains(between));
    let is_twofold = sentence.starts_with("taken as ") || sentence.contains("(3.3 ft)");
    if is_range || is_twofold || sentence.contains("is unusually ") {
        return None;
    }
    let unquoted: String = sentence.split(['"', '`']).step_by(2).collect::<Vec<_>>().join(" ");
    let words: Vec<&str> = unquoted.split_whitespace().collect();
    let is_number = |word: &str| word.parse::<f64>().is_ok();
    let unit = |word: &str| word.trim_end_matches([',', ';', ':', ')', '.']).to_owned();
    let mut pairs = words.windows(2);
    let found = pairs.find(|pair| is_number(pair[0]) && OTHERS.contains(&unit(pair[1]).as_str()));
    found.map(|pair| pair.join(" "))
}
