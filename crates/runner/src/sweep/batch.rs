//! Sets of cases that are solved together, on all cores.

use std::{
    path::Path,
    sync::{Mutex, PoisonError},
};

use wholestring_results::ResultsError;

use super::{
    cases::Cases, checked_points::CheckedPoints, ending::Ending, pace::Pace, points::Point,
    set::Set,
};
use crate::{
    batch::{BatchOptions, BatchOutcome},
    cancellation::CancellationToken,
    clock::Instant,
    observer::{BatchSize, CaseEnded, Observer},
    parallel::{in_parallel, lock},
    share::{Gathering, Share},
};

/// Progress of a batch.
struct Reached {
    /// Outcome of each case of all shards, `None` until it has ended.
    endings: Vec<Option<Ending>>,
    count: usize,
    /// Interval for writing a `sweep.csv`.
    pace: Pace,
}

/// Sets of cases that are solved together.
pub(crate) struct Batch<'a> {
    options: &'a BatchOptions,
    cases: Cases,
    observer: &'a dyn Observer,
    cancellation: &'a CancellationToken,
    share: Share,
    /// Held from the end of the cases of this share, because tables and page contain all shares.
    gathering: Option<Gathering>,
    /// Cases of this shard, the longest first.
    mine: Vec<usize>,
    progress: Mutex<Reached>,
    start: Instant,
}

impl<'a> Batch<'a> {
    /// Creates a batch of valid cases that belong to these sets.
    pub(crate) fn new(
        options: &'a BatchOptions,
        share: Share,
        sets: Vec<Set>,
        valid: CheckedPoints,
        observer: &'a dyn Observer,
        cancellation: &'a CancellationToken,
    ) -> Self {
        Self::of(options, share, Cases::new(sets, valid), observer, cancellation)
    }

    /// Creates a batch of these cases.
    pub(super) fn of(
        options: &'a BatchOptions,
        share: Share,
        cases: Cases,
        observer: &'a dyn Observer,
        cancellation: &'a CancellationToken,
    ) -> Self {
        let endings = cases.points.iter().map(|_| None).collect();
        Self {
            options,
            observer,
            cancellation,
            share,
            gathering: None,
            mine: cases.longest_first(options.shard),
            cases,
            progress: Mutex::new(Reached { endings, count: 0, pace: Pace::default() }),
            start: Instant::now(),
        }
    }

    /// Solves the cases of this shard, and writes table and page of each set for all cases that
    /// have ended, including those of other shares. No other share writes them until this is
    /// dropped.
    pub(crate) fn solve_all(&mut self) -> Result<(), ResultsError> {
        let simulated_s = self.mine.iter().map(|case| self.cases.checked[*case].simulated_s);
        self.observer.batch_started(&BatchSize {
            cases: self.mine.len(),
            finished: 0,
            simulated_s: simulated_s.sum(),
        });
        in_parallel(self.options.jobs(), &self.mine, |case| self.solve(case));
        self.observer.batch_ended();
        let reached = self.progress.get_mut().unwrap_or_else(PoisonError::into_inner);
        let gathering = self.cases.gather(&mut reached.endings, &self.share, self.options)?;
        self.cases.write(&reached.endings)?;
        self.gathering = Some(gathering);
        Ok(())
    }

    /// Each case with its set and outcome; `None` until it has ended.
    pub(crate) fn cases(&mut self) -> impl Iterator<Item = (&Set, &Point, Option<&Ending>)> {
        let reached = self.progress.get_mut();
        let reached = reached.unwrap_or_else(PoisonError::into_inner);
        let (sets, points) = (&self.cases.sets, self.cases.points.iter());
        points
            .zip(&reached.endings)
            .map(move |(point, ending)| (&sets[point.set], point, ending.as_ref()))
    }

    /// Solves one case, unless it is cancelled.
    fn solve(&self, case: usize) {
        if self.cancellation.is_cancelled() {
            return;
        }
        let solve = || self.cases.solve(case, self.options, self.observer, self.cancellation);
        let ending = Ending::of(solve);
        let reused_s = ending.reused_s;
        let mut reached = lock(&self.progress);
        reached.endings[case] = Some(ending);
        reached.count += 1;
        self.observer.case_ended(&CaseEnded {
            ended: reached.count,
            of: self.mine.len(),
            reused_s,
        });
        if self.share.is_part() {
            return;
        }
        let Reached { endings, pace, .. } = &mut *reached;
        pace.when_due(|| {
            // A failure to write is reported at the end.
            let _ = self.cases.write_table(self.cases.points[case].set, endings);
        });
    }

    /// Outcome of the batch, with results in `place`.
    pub(crate) fn outcome(self, place: &Path) -> BatchOutcome {
        let endings = std::mem::take(&mut lock(&self.progress).endings);
        let outcome = BatchOutcome::begin(place, self.mine.len(), self.start, self.cancellation);
        self.cases.conclude(&endings, &self.share, outcome)
    }
}
