//! The cases of a study.

use std::{collections::BTreeMap, path::Path, sync::Arc};

use wholestring_case::{Override, Template};
use wholestring_study::{Study, Sweep};

use crate::{
    error::Error,
    sweep::{Point, points},
};

/// The case files of a study, each read once.
pub(super) struct Templates(BTreeMap<String, Arc<Template>>);

impl Templates {
    /// Reads every case file that the study names, as seen from the folder.
    pub(super) fn read(study: &Study, folder: &Path) -> Result<Self, Error> {
        let mut templates = BTreeMap::new();
        for name in study.sweeps.iter().flat_map(files) {
            if !templates.contains_key(name) {
                let template = Template::read(&folder.join(name))?;
                templates.insert(name.to_owned(), Arc::new(template));
            }
        }
        Ok(Self(templates))
    }

    /// The cases of all sweeps, with these changes of every one of them.
    pub(super) fn points(
        &self,
        study: &Study,
        overrides: &[Override],
    ) -> Result<Vec<Point>, Error> {
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
            let mut points = points(&self.0[&sweep.case], &sweep.set, &sweep.vary)?;
            for point in &mut points {
                point.set = set;
                let exceptions = sweep.exceptions.iter();
                for exception in exceptions.filter(|of| of.when.has(&keys, &point.values)) {
                    if let Some(case) = &exception.case {
                        point.template = self.0[case].clone();
                    }
                    // What is varied has the last word.
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
}

/// The case files of a sweep.
fn files(sweep: &Sweep) -> impl Iterator<Item = &str> {
    let others = sweep.exceptions.iter().filter_map(|of| of.case.as_deref());
    std::iter::once(sweep.case.as_str()).chain(others)
}
