//! A line of a LAS head: `MNEM.UNIT  DATA : DESCRIPTION`.

/// Parts of such a line, trimmed.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Item {
    pub(super) mnemonic: String,
    pub(super) unit: String,
    pub(super) data: String,
    pub(super) description: String,
    /// Whether the point after the mnemonic is missing.
    pub(super) without_point: bool,
}

/// Splits a line. In the line of a curve the first colon begins the description. Other lines may
/// have times in their data, so that the last colon outside digits counts.
pub(super) fn item(line: &str, is_curve: bool) -> Item {
    let line = line.trim();
    let colon = line.find(':').unwrap_or(line.len());
    let Some(point) = line.find('.').filter(|&point| point < colon) else {
        let (head, description) = line.split_at(colon);
        let (mnemonic, data) =
            head.trim().split_once(char::is_whitespace).unwrap_or((head.trim(), ""));
        let description = description.trim_start_matches(':').trim().to_owned();
        let (mnemonic, data) = (mnemonic.to_owned(), data.trim().to_owned());
        return Item { mnemonic, unit: String::new(), data, description, without_point: true };
    };
    let mnemonic = line[..point].trim().to_owned();
    // A second point is padding of the mnemonic: `TIME..s`.
    let rest = line[point + 1..].trim_start_matches('.');
    let (unit, rest) = unit_and_rest(rest);
    let split = if is_curve { rest.find(':') } else { lonely_colon(rest) };
    let (data, description) = match split {
        Some(at) => (rest[..at].trim(), rest[at + 1..].trim()),
        None => (rest.trim(), ""),
    };
    Item {
        mnemonic,
        unit: unit.to_owned(),
        data: data.to_owned(),
        description: description.to_owned(),
        without_point: false,
    }
}

/// Splits off the unit directly after the point, up to a blank; `1000 lbf` contains one.
fn unit_and_rest(rest: &str) -> (&str, &str) {
    let end = rest.find(char::is_whitespace).unwrap_or(rest.len());
    let token = &rest[..end];
    // `hh:mm:ss` is a unit; the colon of `M:` begins the description.
    let is_time = token.to_ascii_lowercase().starts_with("hh:");
    let end = match token.find(':') {
        Some(colon) if !is_time => colon,
        _ => end,
    };
    let unit = &rest[..end];
    let behind = &rest[end..];
    let is_number = !unit.is_empty() && unit.bytes().all(|b| b.is_ascii_digit());
    if is_number {
        let word = behind.trim_start();
        let length = word.find([' ', '\t', ':']).unwrap_or(word.len());
        let blanks = behind.len() - word.len();
        if blanks == 1 && word[..length].starts_with(|c: char| c.is_ascii_alphabetic()) {
            return rest.split_at(end + blanks + length);
        }
    }
    (unit, behind)
}

/// The last colon that is not between digits, else the last.
fn lonely_colon(text: &str) -> Option<usize> {
    let bytes = text.as_bytes();
    let digit = |at: Option<usize>| at.and_then(|at| bytes.get(at)).is_some_and(u8::is_ascii_digit);
    let lonely = |&at: &usize| !(digit(at.checked_sub(1)) && digit(Some(at + 1)));
    let colons: Vec<usize> = text.match_indices(':').map(|(at, _)| at).collect();
    // Blanks before it distinguish it from one within the description.
    let apart = colons.iter().copied().find(|&at| at > 0 && bytes[at - 1].is_ascii_whitespace());
    apart.or_else(|| colons.iter().copied().find(lonely)).or(colons.last().copied())
}

#[cfg(test)]
mod tests {
    use super::item;

    fn parts(line: &str, is_curve: bool) -> [String; 4] {
        let item = item(line, is_curve);
        [item.mnemonic, item.unit, item.data, item.description]
    }

    #[test]
    fn lines_of_curves_are_parted() {
        for (line, expected) in [
            (" DEPT.M                      :  1  DEPTH", ["DEPT", "M", "", "1  DEPTH"]),
            ("TQA  .ft-lbs  : 7 Torque", ["TQA", "ft-lbs", "", "7 Torque"]),
            ("HKLA .1000 lbf  : Hook load", ["HKLA", "1000 lbf", "", "Hook load"]),
            ("TIME .hh:mm:ss : Time: of day", ["TIME", "hh:mm:ss", "", "Time: of day"]),
            ("GR.GAPI 45 310 01 00 : Gamma: ray", ["GR", "GAPI", "45 310 01 00", "Gamma: ray"]),
            ("C01.: ", ["C01", "", "", ""]),
            (".M : nameless", ["", "M", "", "nameless"]),
            ("HKLA klbf : no point", ["HKLA", "", "klbf", "no point"]),
            ("\tHKLA\t.klbf\t:\ttabs", ["HKLA", "klbf", "", "tabs"]),
            ("BPOS.m", ["BPOS", "m", "", ""]),
            ("Temp.°C : x", ["Temp", "°C", "", "x"]),
            ("RPM .1/min 12 : x", ["RPM", "1/min", "12", "x"]),
        ] {
            assert_eq!(parts(line, true), expected, "{line}");
        }
    }

    #[test]
    fn times_in_data_keep_their_colons() {
        for (line, expected) in [
            ("DATE. 2026-11-21T06:00:00Z : START", ["DATE", "", "2026-11-21T06:00:00Z", "START"]),
            ("STRT.S 13:45:10: START", ["STRT", "S", "13:45:10", "START"]),
            ("NULL.   -999.2500:", ["NULL", "", "-999.2500", ""]),
            ("TIME. 13:45 : at 10:00", ["TIME", "", "13:45", "at 10:00"]),
            ("WRAP. NO", ["WRAP", "", "NO", ""]),
        ] {
            assert_eq!(parts(line, false), expected, "{line}");
        }
    }
}
