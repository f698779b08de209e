//! Catalogue entries that the words of a tally designate.

use wholestring::string::catalogue::{CatalogueEntry, find};

/// Tolerance of diameters, m: sheets round 4.778 in to 4.78 in, 121.36 mm to 121.4 mm.
const DIAMETER_TOLERANCE_M: f64 = 0.0003;

/// Maximum length of names of pipe, bytes.
const LONGEST: usize = 100;

/// The entry that a description plainly designates by its own words, without those of a connection.
pub(crate) fn designated(name: &str, connection: Option<&str>) -> Option<CatalogueEntry> {
    if name.len() > LONGEST || !name.bytes().any(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let lower = name.to_lowercase();
    // The catalogue's collars are not of these materials.
    if ["nmdc", "nm ", "non-mag", "nonmag", "monel", "spiral"]
        .iter()
        .any(|word| lower.contains(word))
    {
        return None;
    }
    let words: Vec<&str> = name.split_whitespace().filter(|word| !is_connection(word)).collect();
    let plain = words.join(" ").replace([',', ';', '(', ')'], " ");
    let without = connection.map_or(plain.clone(), |connection| plain.replace(connection, " "));
    let without = ["to surface", "TO SURFACE", "to Surface", "To Surface", "joints", "jts"]
        .iter()
        .fold(without, |text, phrase| text.replace(phrase, " "));
    find(&without).ok().or_else(|| find(after_count(&without)?).ok())
}

/// Text after a number of joints: `12 x 5" HWDP`, `12 jts 5" HWDP`.
fn after_count(name: &str) -> Option<&str> {
    let mut words = name.trim().splitn(3, ' ');
    let (count, sign, rest) = (words.next()?, words.next()?, words.next()?);
    let is_count = !count.is_empty() && count.bytes().all(|byte| byte.is_ascii_digit());
    let is_sign =
        ["x", "×", "jt", "stands", ""].iter().any(|known| sign.eq_ignore_ascii_case(known));
    (is_count && is_sign).then_some(rest)
}

/// The connection that a name contains as a word.
pub(crate) fn connection_of(name: &str) -> Option<&str> {
    name.split_whitespace().find(|word| is_connection(word) && word.len() > 2)
}

/// Whether a word is a thread: `NC50`, `HT55`, `XT-57`, `5-1/2FH`, `GPDS50`.
fn is_connection(word: &str) -> bool {
    let word: String =
        word.chars().filter(|c| c.is_alphanumeric()).collect::<String>().to_uppercase();
    let letters = word.trim_end_matches(|c: char| c.is_ascii_digit());
    let is_numbered = letters.len() < word.len();
    let numbered =
        ["NC", "HT", "XT", "XTM", "GPDS", "DS", "TT", "TTM", "WT", "VX", "DSTJ", "UXT", "CET"];
    let plain = ["IF", "FH", "REG", "XH", "HTSLH90", "R1", "R2", "R3"];
    (is_numbered && numbered.contains(&letters)) || plain.contains(&word.as_str())
}

/// Difference between an entry and the diameters of a row: which diameter, and both values in m;
/// `None` if they agree.
pub(crate) fn differs(
    entry: &CatalogueEntry,
    od_m: f64,
    id_m: Option<f64>,
) -> Option<(&'static str, f64, f64)> {
    // A sheet gives worn pipe with its nominal diameter.
    let nominal =
        entry.designation.strip_suffix(entry.class.suffix()).and_then(|stem| find(stem).ok());
    let entry = nominal.as_ref().unwrap_or(entry);
    let far = |one: f64, other: f64| (one - other).abs() > DIAMETER_TOLERANCE_M;
    if far(entry.od_m, od_m) {
        return Some(("outside diameter", entry.od_m, od_m));
    }
    let id_m = id_m.filter(|&id_m| far(entry.id_m, id_m))?;
    Some(("inside diameter", entry.id_m, id_m))
}

#[cfg(test)]
mod tests {
    use super::{designated, differs};

    fn called(name: &str) -> Option<String> {
        designated(name, None).map(|entry| entry.designation)
    }

    #[test]
    fn plain_designations_are_found_and_others_are_not() {
        for (name, designation) in [
            ("DP 5 1/2in 21.90# S-135 HT55", "5-1/2 in 21.90 lb/ft S-135"),
            ("5\" DP 19.5# G-105 NC50", "5 in 19.50 lb/ft G-105"),
            ("HWDP 5in", "HWDP 5 in 49.3 lb/ft"),
            ("12 x 5\" HWDP", "HWDP 5 in 49.3 lb/ft"),
            ("12 jts 5\" HWDP", "HWDP 5 in 49.3 lb/ft"),
            ("8 x 2-13/16 in collar", "8 in x 2-13/16 in collar"),
            ("Drill pipe 5 in 19.50 lb/ft S-135 (NC50) to surface", "5 in 19.50 lb/ft S-135"),
        ] {
            assert_eq!(called(name).as_deref(), Some(designation), "{name}");
        }
        for name in ["6 3/4\" NMDC w/ MWD", "Jar", "XO 5 in 19.50 lb/ft S-135", "5 in DP", "Stab"] {
            assert_eq!(called(name), None, "{name}");
        }
    }

    #[test]
    fn diameters_agree_within_their_rounding() {
        let entry = designated("DP 5 1/2 in 21.90# S-135", None).unwrap();
        let inch = 0.0254;
        assert_eq!(differs(&entry, 5.5 * inch, Some(4.78 * inch)), None);
        assert_eq!(differs(&entry, 5.5 * inch, None), None);
        assert!(differs(&entry, 5.5 * inch, Some(4.67 * inch)).is_some());
        let worn = designated("DP 5 1/2 in 21.90# S-135 premium", None).unwrap();
        assert_eq!(differs(&worn, 5.5 * inch, Some(4.778 * inch)), None);
    }
}
