//! Finding entries by the words and numbers that describe them.

use super::parts::{Part, parts};

/// Two numbers closer than this are the same: `5.88` is 5-7/8.
const NUMBER_TOLERANCE: f64 = 0.006;

/// Words that name the unit of a number, which a description need not repeat.
const UNITS: [&str; 10] = ["in", "inch", "inches", "lb", "lbs", "ft", "ppf", "per", "x", "by"];

/// Whether a description has every word and every number that is requested.
///
/// Words count without capitals, and may be cut short; numbers however they are written.
///
/// ```
/// use wholestring::string::catalogue::describes;
///
/// let pipe = "5-1/2 in 21.90 lb/ft S-135 drill pipe";
/// assert!(describes(pipe, "5.5 S135"));
/// assert!(describes(pipe, "drill 5 1/2"));
/// assert!(!describes(pipe, "5"));
/// ```
pub fn describes(description: &str, query: &str) -> bool {
    let own = parts(description);
    parts(query).iter().all(|part| match part {
        Part::Word(word) => {
            UNITS.contains(&word.as_str())
                || own
                    .iter()
                    .any(|own| matches!(own, Part::Word(own) if own.starts_with(word.as_str())))
        }
        Part::Number(number) => own
            .iter()
            .any(|own| matches!(own, Part::Number(own) if (own - number).abs() < NUMBER_TOLERANCE)),
    })
}
