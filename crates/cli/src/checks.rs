//! Checks under the table of a run.

use wholestring_results::{Check, OperationSummary, Severity, Summary, Unchecked};
use wholestring_units::UnitSet;

/// Indent of lines after the first, characters.
const INDENT: usize = 4;

/// Length of a stand of pipe, m.
const STAND_M: f64 = 30.0;

/// Two models report the same where their values differ by less than this part.
const SAME: f64 = 0.05;

/// Smallest width at which lines are wrapped, characters.
const NARROWEST: usize = 40;

/// The checks of all operations that need attention, the most severe first, in lines of at most
/// `width` characters; then the checks that could not be evaluated. A check that two models
/// share is one line, with the more severe value. Sentences are in these units.
pub(crate) fn lines(
    summary: &Summary,
    units: UnitSet,
    (width, color): (Option<usize>, bool),
) -> String {
    let mut groups: Vec<(&OperationSummary, Vec<&str>, &Check)> = Vec::new();
    for solved in &summary.operations {
        for check in solved.open_checks() {
            let is_same =
                |(other, models, of_other): &&mut (&OperationSummary, Vec<&str>, &Check)| {
                    other.operation == solved.operation
                        && !models.contains(&solved.model.name())
                        && is_alike(of_other, check)
                };
            match groups.iter_mut().find(is_same) {
                Some((_, models, shown)) => {
                    models.push(solved.model.name());
                    if check.cmp_severity(shown).is_gt() {
                        *shown = check;
                    }
                }
                None => groups.push((solved, vec![solved.model.name()], check)),
            }
        }
    }
    groups.sort_by_key(|(_, _, check)| std::cmp::Reverse(check.severity));
    let mut text = String::new();
    for (solved, models, check) in groups {
        let name = format!("{} ({})", solved.operation, models.join(", "));
        text += &line(&name, check, units, (width, color));
    }
    let unchecked = summary.operations.iter().flat_map(|solved| &solved.unchecked);
    for phrase in Unchecked::phrases(unchecked) {
        text += &wrapped(&format!("not checked: {phrase}"), width);
        text.push('\n');
    }
    text
}

/// Whether two models report the same: kind, severity, component, a place within a stand of pipe,
/// and about the same value.
fn is_alike(one: &Check, other: &Check) -> bool {
    let near = match (one.md_m, other.md_m) {
        (Some(one), Some(other)) => (one - other).abs() < STAND_M,
        (one, other) => one.is_some() == other.is_some(),
    };
    let close = match (one.value, other.value) {
        (Some(one), Some(other)) => (one - other).abs() <= SAME * one.abs().max(other.abs()),
        (one, other) => one.is_some() == other.is_some(),
    };
    close
        && one.kind == other.kind
        && one.severity == other.severity
        && one.component == other.component
        && near
}

/// `error: trip in (soft): ...`
pub(crate) fn line(
    name: &str,
    check: &Check,
    units: UnitSet,
    (width, color): (Option<usize>, bool),
) -> String {
    let severity = check.severity.name();
    let line = wrapped(&format!("{severity}: {name}: {}", check.sentence_in(units)), width);
    let painted = painted(check.severity);
    match color {
        true => format!("{painted}{}\n", &line[severity.len()..]),
        false => line + "\n",
    }
}

fn painted(severity: Severity) -> String {
    let color = match severity {
        Severity::Error => "1;31",
        Severity::Warning => "33",
        Severity::Note | Severity::Ok => "36",
    };
    format!("\x1b[{color}m{}\x1b[0m", severity.name())
}

fn wrapped(line: &str, width: Option<usize>) -> String {
    let Some(width) = width.filter(|width| *width >= NARROWEST) else {
        return line.to_owned();
    };
    let mut text = String::new();
    let mut used = 0;
    for word in line.split(' ') {
        let long = word.chars().count();
        if used > 0 && used + 1 + long > width {
            text += &format!("\n{:INDENT$}", "");
            used = INDENT;
        } else if used > 0 {
            text.push(' ');
            used += 1;
        }
        text += word;
        used += long;
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_no_longer_than_the_screen() {
        let line =
            "warning: trip in (soft): Helically buckled from 100 m to 2000 m, and so on and so on";
        assert_eq!(wrapped(line, None), line);
        let text = wrapped(line, Some(45));
        assert!(text.lines().all(|line| line.chars().count() <= 45), "{text}");
        assert!(text.lines().skip(1).all(|line| line.starts_with("    ")));
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(words(&text), words(line));
    }
}
