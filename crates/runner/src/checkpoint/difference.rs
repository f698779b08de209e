//! Checks that stored results are those of the current case.

use serde_json::Value;
use wholestring_case::Case;
use wholestring_results::{ENGINE_VERSION, Summary, digest};

/// Checks that a summary contains the answers of the case.
///
/// # Errors
/// The reason why it does not: another case, another version of the program, or no record of its
/// case.
pub(crate) fn is_of(summary: &Summary, case: &Case) -> Result<(), String> {
    match &summary.identity {
        None => Err("it is of an earlier version, which did not record its case".to_owned()),
        Some(identity) if *identity != digest(&case.identity()) => Err(format!(
            "it is of another case: {}",
            difference(&summary.settings, &case.settings).unwrap_or_else(|| {
                "it differs in inputs that are not among its settings".to_owned()
            })
        )),
        Some(_) => match summary.engine_version.as_deref() {
            Some(ENGINE_VERSION) => Ok(()),
            version => Err(format!(
                "wholestring {} computed it, this is {ENGINE_VERSION}",
                version.unwrap_or("of an unknown version")
            )),
        },
    }
}

/// Settings without effect on the answer.
const WITHOUT_EFFECT: &[&str] = &["name", "units", "well.survey", "dynamics.checkpoint_interval_s"];

/// The first difference between the settings of the run in a folder and those of the case.
pub(crate) fn difference(there: &Value, here: &Value) -> Option<String> {
    let (path, there, here) = first_difference(String::new(), Some(there), Some(here))?;
    let text = |value: Option<&Value>| value.map_or("not given".to_owned(), Value::to_string);
    Some(format!("`{path}` is {} there and {} here", text(there), text(here)))
}

type Difference<'a> = (String, Option<&'a Value>, Option<&'a Value>);

fn first_difference<'a>(
    path: String,
    there: Option<&'a Value>,
    here: Option<&'a Value>,
) -> Option<Difference<'a>> {
    let below = |key: &str| match path.as_str() {
        "" => key.to_owned(),
        path => format!("{path}.{key}"),
    };
    match (there, here) {
        (Some(Value::Object(a)), Some(Value::Object(b))) => a
            .keys()
            .chain(b.keys().filter(|key| !a.contains_key(*key)))
            .find_map(|key| first_difference(below(key), a.get(key), b.get(key))),
        (Some(Value::Array(a)), Some(Value::Array(b))) => (0..a.len().max(b.len()))
            .find_map(|i| first_difference(below(&i.to_string()), a.get(i), b.get(i))),
        // A missing value and null are equal, because earlier versions wrote null.
        (None, Some(Value::Null)) | (Some(Value::Null), None) => None,
        (a, b) => (a != b && !WITHOUT_EFFECT.contains(&path.as_str())).then_some((path, a, b)),
    }
}

/// Note for a run that is resumed on a processor with different rounding of products: in single
/// precision, with fused multiply-add or without.
pub(crate) fn other_arithmetic(then: bool, now: bool) -> Option<&'static str> {
    match (then, now) {
        (true, false) => Some(
            "the run was computed with fused multiply-add until now and continues without: as \
             good, but not the same to the last bit",
        ),
        (false, true) => Some(
            "the run was computed without fused multiply-add until now and continues with it: as \
             good, but not the same to the last bit",
        ),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn the_first_difference_is_named() {
        let there = json!({"a": {"b": [1, 2.5]}, "dynamics": {"checkpoint_interval_s": 30.0}});
        assert_eq!(difference(&there, &there), None);
        let here = json!({"a": {"b": [1, 2.5]}, "dynamics": {"checkpoint_interval_s": 1.0}});
        assert_eq!(difference(&there, &here), None);
        let null =
            json!({"a": {"b": [1, 2.5], "c": null}, "dynamics": {"checkpoint_interval_s": 30.0}});
        assert_eq!(difference(&there, &null), None);
        assert_eq!(difference(&null, &there), None);
        let text = |here: Value| difference(&there, &here).unwrap();
        assert_eq!(text(json!({"a": {"b": [1, 3]}})), "`a.b.1` is 2.5 there and 3 here");
        assert_eq!(
            text(json!({"a": {"b": [1, 2.5, "x"]}})),
            "`a.b.2` is not given there and \"x\" here"
        );
        assert_eq!(text(json!({"a": {}})), "`a.b` is [1,2.5] there and not given here");
    }

    #[test]
    fn other_arithmetic_is_told() {
        for alike in [true, false] {
            assert_eq!(other_arithmetic(alike, alike), None);
            let note = other_arithmetic(alike, !alike).unwrap();
            assert!(note.contains("fused multiply-add until now"), "{note}");
        }
    }
}
