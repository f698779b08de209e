//! The cases of a study.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

use wholestring_case::{Override, Template};
use wholestring_study::{Study, Sweep};

use crate::{
    error::Error,
    sweep::{self, Point},
};

/// Names of the case files that a study requires, each once.
pub fn case_files(study: &Study) -> BTreeSet<&str> {
    study.sweeps.iter().flat_map(files).collect()
}

/// Cases of all sweeps, with these changes to every one of them.
pub(super) fn points(
    study: &Study,
    cases: &BTreeMap<String, Arc<Template>>,
    overrides: &[Override],
) -> Result<Vec<Point>, Error> {
    let template = |name: &str| {
        cases.get(name).ok_or_else(|| {
            Error::BadInput(format!("the study names the case `{name}`, which is not given"))
        })
    };
    let mut all = Vec::new();
    for (set, sweep) in study.sweeps.iter().enumerate() {
        for change in overrides {
            if sweep.keys().any(|key| key == change.key) {
                return Err(Error::BadInput(format!(
                    "`{}` cannot be set, sweep `{}` varies it",
                    change.key, sweep.name
                )));
            }
        }
        let keys: Vec<String> = sweep.keys().map(str::to_owned).collect();
        let mut points = sweep::points(template(&sweep.case)?, &sweep.set, &sweep.vary)?;
        for point in &mut points {
            point.set = set;
            let exceptions = sweep.exceptions.iter();
            for exception in exceptions.filter(|exception| exception.when.has(&keys, &point.values))
            {
                if let Some(case) = &exception.case {
                    point.template = template(case)?.clone();
                }
                // Varied values take precedence.
                let varied = point.changes.len() - point.values.len();
                let set = exception.set.iter().cloned();
                point.changes.splice(varied..varied, set);
            }
            let varied = point.changes.len() - point.values.len();
            let set = overrides.iter().cloned();
            point.changes.splice(varied..varied, set);
        }
        all.extend(points);
    }
    Ok(all)
}

/// Case files of a sweep.
fn files(sweep: &Sweep) -> impl Iterator<Item = &str> {
    let others = sweep.exceptions.iter().filter_map(|exception| exception.case.as_deref());
    std::iter::once(sweep.case.as_str()).chain(others)
}
