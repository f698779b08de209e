//! The verdict on a whole result.

use serde::Serialize;

use crate::{Check, Severity, Verdict};

/// The most severe check of a result in words.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Overall {
    /// Its severity.
    pub severity: Severity,
    /// Its sentence, and the number of other errors and warnings; `OK` for a result without either.
    pub words: String,
}

impl Overall {
    /// Summarizes all checks of a result; `None` for a result without checks.
    pub fn of<'a>(checks: impl IntoIterator<Item = &'a Check>) -> Option<Self> {
        let checks: Vec<&Check> = checks.into_iter().collect();
        // Takes the first of equals, because `max_by_key` returns the last.
        let worst = checks.iter().rev().max_by_key(|check| check.severity)?;
        let count = |severity| checks.iter().filter(|check| check.severity == severity).count();
        if worst.severity <= Severity::Note {
            let words = match count(Severity::Note) {
                0 => Verdict::Ok.words().to_owned(),
                notes => format!("{}, {}", Verdict::Ok.words(), number(notes, "note")),
            };
            return Some(Self { severity: worst.severity, words });
        }
        let others = [(Severity::Error, "error"), (Severity::Warning, "warning")];
        let others = others.into_iter().filter_map(|(severity, noun)| {
            let own = usize::from(severity == worst.severity);
            let more = count(severity) - own;
            (more > 0).then(|| format!("{more} {}{noun}{}", ["", "more "][own], plural(more)))
        });
        let others: Vec<String> = others.collect();
        let words = match others.is_empty() {
            true => worst.sentence.clone(),
            false => format!("{} ({})", worst.sentence, others.join(", ")),
        };
        Some(Self { severity: worst.severity, words })
    }
}

fn number(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", plural(count))
}

const fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::CheckKind;

    fn check(severity: Severity, sentence: &str) -> Check {
        Check { sentence: sentence.to_owned(), ..Check::reported(CheckKind::GoesDown, severity) }
    }

    /// Among reported states of one severity the one farther from its limit is the more severe,
    /// whichever comes first: a hook load farther below zero, a compression farther above the
    /// critical one.
    #[test]
    fn states_without_a_factor_are_ranked() {
        let hook_load = |value_N: f64| check(Severity::Error, "").value(value_N).limit(0.0);
        let [slack, pushed] = [9e3, -64e3].map(hook_load);
        assert!(pushed.cmp_severity(&slack).is_gt() && slack.cmp_severity(&pushed).is_lt());
        let buckled = |value_N: f64| {
            Check::reported(CheckKind::HelicalBuckling, Severity::Warning).value(value_N).limit(5e3)
        };
        assert!(buckled(8e3).cmp_severity(&buckled(6e3)).is_gt());
        assert!(hook_load(1.0).cmp_severity(&buckled(1e9)).is_gt());
    }

    #[test]
    fn the_most_severe_check_is_the_verdict() {
        let words = |checks: &[Check]| Overall::of(checks).map(|overall| overall.words);
        assert_eq!(words(&[]), None);
        let passed = check(Severity::Ok, "Hoist");
        let note = check(Severity::Note, "Helix");
        let warning = check(Severity::Warning, "Tension");
        let errors = ["Lock-up", "Hoist"].map(|sentence| check(Severity::Error, sentence));
        assert_eq!(words(std::slice::from_ref(&passed)).unwrap(), "OK");
        assert_eq!(words(&[passed.clone(), note]).unwrap(), "OK, 1 note");
        assert_eq!(words(&[passed, warning.clone()]).unwrap(), "Tension");
        let [first, second] = errors;
        let all = [warning.clone(), first, second, warning];
        assert_eq!(words(&all).unwrap(), "Lock-up (1 more error, 2 warnings)");
    }
}
