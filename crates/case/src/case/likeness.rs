//! Whether a text is intended as a case file, valid or not.

use wholestring_config::table::Keys as _;

use crate::case::table::CaseTable;

/// Whether a text is intended as a case file, by the names of its tables and of its keys above the
/// first one; neither its mistakes nor the name of its file matter.
///
/// ```
/// use wholestring_case::is_case;
///
/// assert!(is_case("# a well\n[well]\nstations = [oops"));
/// assert!(!is_case("MD (m),Inc (deg),Azi (deg)\n0,0,0\n30,1,45\n"));
/// ```
pub fn is_case(text: &str) -> bool {
    let names = CaseTable::names();
    let is_key = |word: &str| names.contains(&word.trim().trim_matches(['"', '\'']));
    let mut above = true;
    text.trim_start_matches('\u{feff}').lines().map(str::trim_start).any(|line| {
        if let Some(header) = line.strip_prefix('[') {
            above = false;
            let header = header.trim_start_matches('[');
            let name = header.split(['.', ']']).next().unwrap_or_default();
            return header.contains(']') && is_key(name);
        }
        let is_value = |value: &str| value.trim_start().starts_with(['"', '\'', '[', '{']);
        above && line.split_once('=').is_some_and(|(key, value)| is_key(key) && is_value(value))
    })
}
