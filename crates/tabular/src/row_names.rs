//! Rows of a file in a sentence.

/// Maximum number of rows in a sentence; further ones are counted.
const NAMED: usize = 12;

/// Formats rows for a sentence: `line 3`, `lines 3 to 6 and 9`, `rows 2 and 3 of sheet 'weights'`.
pub fn row_names(places: &[String]) -> String {
    let parsed: Option<Vec<(&str, usize, &str)>> =
        places.iter().map(|place| numbered(place)).collect();
    let alike = parsed.as_ref().and_then(|all| {
        let &(noun, _, behind) = all.first()?;
        all.iter().all(|row| (row.0, row.2) == (noun, behind)).then_some((noun, behind))
    });
    let (Some(parsed), Some((noun, behind))) = (&parsed, alike) else {
        let listed_names: Vec<&str> = places.iter().take(NAMED).map(String::as_str).collect();
        return match places.len() - listed_names.len() {
            0 => listed(&listed_names),
            more => format!("{} and {more} more", listed_names.join(", ")),
        };
    };
    let mut numbers: Vec<usize> = parsed.iter().map(|parsed| parsed.1).collect();
    numbers.sort_unstable();
    numbers.dedup();
    if let [only] = numbers[..] {
        return format!("{noun} {only}{behind}");
    }
    let runs = numbers.chunk_by(|a, b| a + 1 == *b).flat_map(|run| match run {
        [first, .., last] if run.len() > 2 => vec![format!("{first} to {last}")],
        others => others.iter().map(usize::to_string).collect(),
    });
    let runs: Vec<String> = runs.collect();
    let listed_names: Vec<&str> = runs.iter().take(NAMED).map(String::as_str).collect();
    let text = match runs.len() - listed_names.len() {
        0 => listed(&listed_names),
        more => format!("{} and {more} more", listed_names.join(", ")),
    };
    format!("{noun}s {text}{behind}")
}

/// Splits `line 3` or `row 3 of sheet 'weights'` into its noun, its number, and the rest.
fn numbered(place: &str) -> Option<(&str, usize, &str)> {
    let (noun, rest) = place.split_once(' ')?;
    let end = rest.find(' ').unwrap_or(rest.len());
    let number = rest[..end].parse().ok()?;
    matches!(noun, "line" | "row").then_some((noun, number, &rest[end..]))
}

/// Formats a list: `3, 4 and 5`.
fn listed(names: &[&str]) -> String {
    match names {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [others @ .., last] => format!("{} and {last}", others.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::row_names;

    #[test]
    fn rows_next_to_each_other_are_joined() {
        let names = |places: &[&str]| {
            row_names(&places.iter().map(|place| (*place).to_owned()).collect::<Vec<_>>())
        };
        assert_eq!(names(&["line 3"]), "line 3");
        assert_eq!(names(&["line 3", "line 4"]), "lines 3 and 4");
        assert_eq!(names(&["line 9", "line 3", "line 4", "line 5"]), "lines 3 to 5 and 9");
        let rows = ["row 2 of sheet 'a b'", "row 4 of sheet 'a b'"];
        assert_eq!(names(&rows), "rows 2 and 4 of sheet 'a b'");
        assert_eq!(names(&["line 3", "stand 4, 1 h"]), "line 3 and stand 4, 1 h");
        assert_eq!(names(&[]), "");
    }
}
