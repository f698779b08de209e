//! Checked cases of a batch, and the folder of their results.

use std::path::{Path, PathBuf};

use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_results::{Occupant, digest};

use super::{
    checked::{Checked, check},
    points::Point,
};
use crate::{
    batch::BatchOptions,
    cancellation::CancellationToken,
    claim::{Claim, Claimed},
    error::Error,
    observer::Observer,
};

/// Checked cases of a batch.
pub(crate) struct CheckedPoints {
    pub(super) points: Vec<Point>,
    pub(super) checked: Vec<Checked>,
}

impl CheckedPoints {
    /// Reads and checks every case, so that no batch fails at its end on a mistake in its last
    /// case.
    pub(crate) fn check(
        points: Vec<Point>,
        options: &BatchOptions,
        observer: &dyn Observer,
        cancellation: &CancellationToken,
    ) -> Result<Self, Error> {
        let checked = check(&points, options.jobs(), observer, cancellation)?;
        Ok(Self { points, checked })
    }

    /// Name of the first case.
    pub(crate) fn first_name(&self) -> &str {
        self.checked.first().map_or("", |case| &case.name)
    }

    /// Digest of all settings that the answers depend on: those of all cases, by set and name.
    fn identity(&self) -> String {
        let cases = self.points.iter().zip(&self.checked);
        let cases = cases.map(|(point, case)| (point.set, &point.name, &case.identity));
        digest(&cases.collect::<Vec<_>>())
    }

    /// Methods and operations that each case solves, with the number of its set.
    pub(crate) fn solves(
        &self,
    ) -> impl Iterator<Item = (usize, &[ModelKind], &[OperationKind])> + '_ {
        let cases = self.points.iter().zip(&self.checked);
        cases.map(|(point, case)| (point.set, &case.solves.0[..], &case.solves.1[..]))
    }

    /// Claims the folder of a batch with this name; `within` returns the folder of a numbered set
    /// in the batch's folder.
    pub(crate) fn claim(
        &self,
        kind: &str,
        name: &str,
        options: &BatchOptions,
        observer: &dyn Observer,
        within: &dyn Fn(&Path, usize) -> PathBuf,
    ) -> Result<Claimed, Error> {
        let shard = options.shard;
        let mine = || {
            let cases = self.points.iter().enumerate();
            cases.filter_map(|(case, point)| shard.has(case).then_some(point))
        };
        let case = |path: &Path, point: &Point| within(path, point.set).join(&point.name);
        let occupant =
            Occupant { kind: kind.to_owned(), name: name.to_owned(), identity: self.identity() };
        Claim {
            shared: shard.is_part(),
            is_unfinished: &|path| {
                mine().any(|point| case(path, point).join("checkpoint.bin").is_file())
            },
            within: &|path| {
                let sets = self.points.iter().map(|point| within(path, point.set));
                let cases = self.points.iter().map(|point| case(path, point));
                sets.chain(cases).filter(|place| *place != path).collect()
            },
            is_part: &|path| self.points.iter().any(|point| case(path, point).is_dir()),
            ..Claim::new(occupant, &options.output, observer)
        }
        .folder()
    }
}
