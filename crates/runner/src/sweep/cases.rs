//! Valid cases, their sets, and the tables of their outcomes.

use std::{
    path::PathBuf,
    sync::{Mutex, PoisonError},
};

use wholestring_results::{ENGINE_VERSION, ResultsError, ResultsFolder, Summary};

use super::{
    checked::Checked,
    checked_points::CheckedPoints,
    ending::Ending,
    one_case::OneCase,
    page as sweep_page,
    points::Point,
    set::Set,
    table::{FILE, SweepTable},
};
use crate::{
    batch::{BatchOptions, BatchOutcome, CaseWithErrors, FailedCase},
    cancellation::CancellationToken,
    checks,
    observer::{Observer, Watch},
    parallel::{in_parallel, lock},
    run::Stop,
    shard::Shard,
    share::{Gathering, Share},
};

/// Valid cases and their sets.
pub(crate) struct Cases {
    pub(super) sets: Vec<Set>,
    pub(super) points: Vec<Point>,
    pub(super) checked: Vec<Checked>,
}

impl Cases {
    /// Creates the collection of valid cases that belong to these sets.
    pub(super) fn new(sets: Vec<Set>, valid: CheckedPoints) -> Self {
        let CheckedPoints { points, checked } = valid;
        Self { sets, points, checked }
    }

    /// Indices of a share, the longest case first, so that the last jobs are short and no job waits
    /// long for the others.
    pub(super) fn longest_first(&self, shard: Shard) -> Vec<usize> {
        let mut order: Vec<usize> =
            (0..self.points.len()).filter(|case| shard.has(*case)).collect();
        order.sort_by(|a, b| self.checked[*b].cost.total_cmp(&self.checked[*a].cost));
        order
    }

    /// Solves a case into its folder.
    pub(super) fn solve(
        &self,
        number: usize,
        options: &BatchOptions,
        observer: &dyn Observer,
        cancellation: &CancellationToken,
    ) -> Result<Ending, Stop> {
        let (point, checked) = (&self.points[number], &self.checked[number]);
        let case = match checked.take() {
            Some(case) => case,
            None => point
                .template
                .case(&point.changes)
                .map_err(|report| Stop::Unsolved(report.render(false)))?,
        };
        let folder = ResultsFolder::create(self.folder(number))?;
        let one = OneCase {
            case: &case,
            label: &self.label(number),
            simulated_s: checked.simulated_s,
            keep: self.sets[point.set].keep(&case, options.csv),
            csv: options.csv,
            existing: options.output.existing,
            checkpoint_every: options.checkpoint_every,
            watch: Watch { observer, case: number },
            cancellation,
        };
        one.solve(&folder)
    }

    /// Folder of a case.
    pub(super) fn folder(&self, number: usize) -> PathBuf {
        let point = &self.points[number];
        self.sets[point.set].folder.path().join(&point.name)
    }

    /// Name of a case in messages.
    pub(super) fn label(&self, number: usize) -> String {
        let point = &self.points[number];
        format!("{}{}", self.sets[point.set].prefix, point.name)
    }

    /// Writes the `sweep.csv` of a set: its cases in their order, as far as they have ended.
    pub(super) fn write_table(
        &self,
        set: usize,
        endings: &[Option<Ending>],
    ) -> Result<(), ResultsError> {
        let of_set = |case: &usize| self.points[*case].set == set;
        let cases = || (0..self.points.len()).filter(of_set);
        let dynamic = cases().any(|case| self.checked[case].simulated_s > 0.0);
        let lift = cases().any(|case| self.checked[case].lift);
        let mut table = SweepTable::new(self.sets[set].keys.clone(), dynamic, lift);
        for case in cases() {
            if let Some(Ending { solved, why, .. }) = &endings[case] {
                let failure = why.as_ref().and_then(Stop::reason);
                let point = &self.points[case];
                table.add(&point.values, &point.name, solved, failure.as_deref());
            }
        }
        let path = self.sets[set].folder.path().join(FILE);
        table.table().write_csv(&path)
    }

    /// Reads the results of the other shares, and keeps them from writing tables and page while the
    /// returned value exists.
    pub(super) fn gather(
        &self,
        endings: &mut [Option<Ending>],
        share: &Share,
        options: &BatchOptions,
    ) -> Result<Gathering, ResultsError> {
        let failed = endings.iter().enumerate().filter_map(|(case, ending)| {
            let reason = ending.as_ref()?.why.as_ref()?.reason()?;
            Some((self.label(case), reason))
        });
        let gathering = share.gather(failed.collect())?;
        if share.is_part() {
            let failed = share.failed_of_others();
            let others: Vec<usize> =
                (0..endings.len()).filter(|case| endings[*case].is_none()).collect();
            let found = Mutex::new(Vec::new());
            in_parallel(options.jobs(), &others, |case| {
                let why = failed.get(&self.label(case)).cloned();
                if let Some(ending) = self.left_by_another(case, why) {
                    lock(&found).push((case, ending));
                }
            });
            for (case, ending) in found.into_inner().unwrap_or_else(PoisonError::into_inner) {
                endings[case] = Some(ending);
            }
        }
        Ok(gathering)
    }

    /// Outcome of a case from the files of another share; `None` if it has not begun, or if the
    /// files belong to other settings or another version.
    fn left_by_another(&self, case: usize, why: Option<String>) -> Option<Ending> {
        let summary = Summary::read(&self.folder(case).join("summary.json")).ok();
        let summary = summary.filter(|summary| {
            summary.identity.as_ref() == Some(&self.checked[case].identity)
                && summary.engine_version.as_deref() == Some(ENGINE_VERSION)
        });
        let solved = summary.map_or_else(Vec::new, |summary| summary.operations);
        let why = why.map(Stop::Unsolved);
        (why.is_some() || !solved.is_empty()).then_some(Ending { solved, why, reused_s: 0.0 })
    }

    /// Writes table and page of each set.
    pub(super) fn write(&self, endings: &[Option<Ending>]) -> Result<(), ResultsError> {
        (0..self.sets.len()).try_for_each(|set| {
            self.write_table(set, endings)?;
            sweep_page::write(&self.sets[set].folder, None)
        })
    }

    /// Adds the outcomes of the share's cases to that of the batch.
    pub(super) fn conclude(
        &self,
        endings: &[Option<Ending>],
        share: &Share,
        mut outcome: BatchOutcome,
    ) -> BatchOutcome {
        outcome.known = (endings.iter().flatten().count(), endings.len());
        for (case, ending) in endings.iter().enumerate() {
            let Some(Ending { solved, why, .. }) = ending.as_ref().filter(|_| share.has(case))
            else {
                continue;
            };
            match why.as_ref().map(Stop::reason) {
                None => outcome.finished += 1,
                Some(reason) => outcome
                    .failed
                    .extend(reason.map(|reason| FailedCase { name: self.label(case), reason })),
            }
            let wrong = solved.iter().filter(|solved| checks::has_error(solved));
            let operations: Vec<String> = wrong.map(checks::name).collect();
            if !operations.is_empty() {
                outcome.with_errors.push(CaseWithErrors { name: self.label(case), operations });
            }
        }
        outcome
    }
}
