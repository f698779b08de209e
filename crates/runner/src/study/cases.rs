//! The cases of a study.

use std::{
    collections::{BTreeMap, BTreeSet},
    path::Path,
    sync::Arc,
};

use wholestring_case::{Override, Template};
use wholestring_study::{Study, Sweep};

use crate::{
    error::Error,
    sweep::{Point, points},
};

/// Source of the case files of a study.
#[derive(Debug, Clone, Copy)]
pub enum CaseFiles<'a> {
    /// On the disk, relative to a folder: that of the study's own file.
    Beside(&'a Path),
    /// In memory, by the names used in the study.
    Given(&'a BTreeMap<String, Arc<Template>>),
}

impl CaseFiles<'_> {
    fn read(self, name: &str) -> Result<Arc<Template>, Error> {
        match self {
            Self::Beside(folder) => Ok(Arc::new(Template::read(&folder.join(name))?)),
            Self::Given(all) => all.get(name).cloned().ok_or_else(|| {
                Error::BadInput(format!("the study names the case `{name}`, which is not given"))
            }),
        }
    }
}

/// Names of the case files that a study requires, each once.
pub fn case_files(study: &Study) -> BTreeSet<&str> {
    study.sweeps.iter().flat_map(files).collect()
}

/// The case files of a study, each read once.
pub(super) struct Templates(BTreeMap<String, Arc<Template>>);

impl Templates {
    /// Reads every case file that the study names.
    pub(super) fn read(study: &Study, from: CaseFiles<'_>) -> Result<Self, Error> {
        let read = |name: &str| Ok((name.to_owned(), from.read(name)?));
        Ok(Self(case_files(study).into_iter().map(read).collect::<Result<_, Error>>()?))
    }

    /// Cases of all sweeps, with these changes to every one of them.
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
                for exception in
                    exceptions.filter(|exception| exception.when.has(&keys, &point.values))
                {
                    if let Some(case) = &exception.case {
                        point.template = self.0[case].clone();
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
}

/// Case files of a sweep.
fn files(sweep: &Sweep) -> impl Iterator<Item = &str> {
    let others = sweep.exceptions.iter().filter_map(|exception| exception.case.as_deref());
    std::iter::once(sweep.case.as_str()).chain(others)
}
