//! Laying a run aside and taking it up again.
//!
//! A checkpoint holds all that a run knows: what it has solved, and the operation under way as it
//! stands. The results in the folder are not read, so that it does not matter what was being written
//! when the run was killed. Only frames are too many to hold: a checkpoint knows how many parts of them were on
//! the disk, and holds the rest.

use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};
use serde_json::Value;
use wholestring::{
    dynamics::{Checkpoint, TunedLift},
    operation::Operation,
};
use wholestring_case::Case;
use wholestring_results::{ENGINE_VERSION, ResultsError, ResultsFolder, Summary, digest};

use crate::{
    failure::Failure,
    record::{Record, Solved},
};

/// An operation that the dynamics were solving.
#[derive(Serialize, Deserialize)]
pub(crate) struct UnderWay<'a> {
    /// Name of the operation.
    operation: String,
    /// What it had taken until then, s.
    pub(crate) wall_time_s: f64,
    /// The lift that was found for it, where it hangs on one.
    pub(crate) lift: Option<TunedLift>,
    pub(crate) simulation: Checkpoint<'a>,
}

impl<'a> UnderWay<'a> {
    pub(crate) fn new(
        operation: &Operation,
        took: Duration,
        lift: Option<TunedLift>,
        simulation: Checkpoint<'a>,
    ) -> Self {
        Self {
            operation: operation.kind.name().to_owned(),
            wall_time_s: took.as_secs_f64(),
            lift,
            simulation,
        }
    }

    pub(crate) fn is(&self, operation: &Operation) -> bool {
        self.operation == operation.kind.name()
    }
}

/// A run that was laid aside.
#[derive(Serialize, Deserialize)]
pub(crate) struct Laid<'a> {
    /// All that the case's answers depend on, as JSON.
    identity: String,
    /// The case's settings, as JSON: the same in words that people know.
    settings: String,
    pub(crate) solved: Solved<'a>,
    pub(crate) under_way: Option<UnderWay<'a>>,
}

impl<'a> Laid<'a> {
    /// What a run knows.
    pub(crate) fn new(record: &'a Record, under_way: Option<UnderWay<'a>>) -> Self {
        Self {
            identity: record.identity.to_string(),
            settings: record.summary.settings.to_string(),
            solved: record.solved_so_far(),
            under_way,
        }
    }

    /// The checkpoint in the folder, if there is one.
    ///
    /// # Errors
    /// Why the case cannot go on from it.
    pub(crate) fn read(folder: &ResultsFolder, case: &Case) -> Result<Option<Self>, String> {
        let laid: Option<Self> = folder.read_checkpoint().map_err(|e| e.to_string())?;
        let Some(laid) = laid else { return Ok(None) };
        let read = |text: &str| serde_json::from_str(text).map_err(|e| e.to_string());
        let (identity, settings): (Value, Value) = (read(&laid.identity)?, read(&laid.settings)?);
        let here = case.identity();
        if let Some(under_way) = &laid.under_way
            && Duration::try_from_secs_f64(under_way.wall_time_s).is_err()
        {
            let place = folder.path().display();
            return Err(format!(
                "the checkpoint in {place} is damaged: its time on the clock"
            ));
        }
        if identity == here {
            return Ok(Some(laid));
        }
        // In the words of the settings where they tell it.
        let difference = difference(&settings, &case.settings);
        let difference = difference.or_else(|| self::difference(&identity, &here));
        Err(format!(
            "the checkpoint in {} is of another case: {}",
            folder.path().display(),
            difference.unwrap_or_default()
        ))
    }
}

/// Whether a summary's answers are those of the case.
///
/// # Errors
/// Why they are not: of another case, of another version of the program, or of one that did not say of which case.
pub(crate) fn is_of(summary: &Summary, case: &Case) -> Result<(), String> {
    match &summary.identity {
        None => Err("it is of an earlier version, which did not say of which case".to_owned()),
        Some(identity) if *identity != digest(&case.identity()) => Err(format!(
            "it is of another case: {}",
            difference(&summary.settings, &case.settings)
                .unwrap_or_else(|| "it differs in what its settings do not tell".to_owned())
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

/// Writes checkpoints of a run as time goes by.
pub(crate) struct Keeper<'a> {
    folder: &'a ResultsFolder,
    every: Duration,
    last: Instant,
}

impl<'a> Keeper<'a> {
    /// A keeper that writes to the folder after each such while.
    pub(crate) fn new(folder: &'a ResultsFolder, every: Duration) -> Self {
        Self {
            folder,
            every,
            last: Instant::now(),
        }
    }

    /// Whether the time for a checkpoint has come.
    pub(crate) fn is_due(&self) -> bool {
        self.last.elapsed() >= self.every
    }

    /// Writes what is needed to go on.
    pub(crate) fn write(&mut self, content: &impl Serialize) -> Result<(), ResultsError> {
        let written = self.folder.write_checkpoint(content);
        self.last = Instant::now();
        written
    }

    /// The run has come to its end: there is nothing to go on with.
    pub(crate) fn finish(self) -> Result<(), Failure> {
        Ok(self.folder.remove_checkpoint()?)
    }
}

/// Settings that leave the answer as it is.
const WITHOUT_EFFECT: &[&str] = &[
    "name",
    "units",
    "well.survey",
    "dynamics.checkpoint_interval_s",
];

/// The first difference between the settings of the run in a folder and those of the case.
pub(crate) fn difference(there: &Value, here: &Value) -> Option<String> {
    let (path, there, here) = first_difference(String::new(), Some(there), Some(here))?;
    let tell = |value: Option<&Value>| value.map_or("not given".to_owned(), Value::to_string);
    Some(format!(
        "`{path}` is {} there and {} here",
        tell(there),
        tell(here)
    ))
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
        (a, b) => (a != b && !WITHOUT_EFFECT.contains(&path.as_str())).then_some((path, a, b)),
    }
}

/// What to tell whoever goes on with a run on a processor of another kind.
pub(crate) fn other_processor(then: &str, now: &str) -> Option<String> {
    (then != now).then(|| {
        format!(
            "warning: the run was computed with {then} until now and goes on with {now}: as good, but not the same to the last bit\n"
        )
    })
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
        let tell = |here: Value| difference(&there, &here).unwrap();
        assert_eq!(
            tell(json!({"a": {"b": [1, 3]}})),
            "`a.b.1` is 2.5 there and 3 here"
        );
        assert_eq!(
            tell(json!({"a": {"b": [1, 2.5, "x"]}})),
            "`a.b.2` is not given there and \"x\" here"
        );
        assert_eq!(
            tell(json!({"a": {}})),
            "`a.b` is [1,2.5] there and not given here"
        );
    }

    #[test]
    fn another_processor_is_told() {
        assert_eq!(other_processor("AVX2", "AVX2"), None);
        let told = other_processor("AVX-512", "baseline").unwrap();
        assert!(
            told.contains("AVX-512") && told.contains("baseline"),
            "{told}"
        );
    }
}
