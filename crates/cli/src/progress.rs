//! Progress bars on the terminal, and speed and duration of a simulation in words.

use std::{
    collections::HashMap,
    fmt,
    sync::{Mutex, MutexGuard, PoisonError},
    time::{Duration, Instant},
};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use wholestring_case::Report;
use wholestring_runner::{BatchSize, CaseEnded, Observer, Progress, Task};

use crate::{screen::color, terminal::print_stderr};

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Shows a run: a bar for each operation.
pub(crate) struct RunScreen {
    /// Hides the bars.
    quiet: bool,
    /// Hides the notes.
    without_notes: bool,
    shown: Mutex<Shown>,
}

/// Current content of the screen.
enum Shown {
    Nothing,
    Preparing(ProgressBar),
    Operation(OwnBar),
}

impl Drop for Shown {
    fn drop(&mut self) {
        match self {
            Self::Nothing => {}
            Self::Preparing(bar) | Self::Operation(OwnBar { bar, .. }) => bar.finish_and_clear(),
        }
    }
}

impl RunScreen {
    pub(crate) fn new(quiet: bool, without_notes: bool) -> Self {
        Self { quiet, without_notes, shown: Mutex::new(Shown::Nothing) }
    }

    /// Replaces the current content of the screen.
    fn show(&self, new: Shown) {
        let mut current = lock(&self.shown);
        // The old content is removed before the new is drawn.
        *current = Shown::Nothing;
        *current = new;
    }
}

impl Observer for RunScreen {
    fn note(&self, text: &str) {
        if !self.without_notes {
            print_stderr(&format!("note: {text}\n"));
        }
    }

    fn warning(&self, text: &str) {
        print_stderr(&format!("warning: {text}\n"));
    }

    fn preparing(&self, task: &Task<'_>, what: &str) {
        self.show(Shown::Preparing(preparation(task.name, what, self.quiet)));
    }

    fn prepared(&self, _: &Task<'_>) {
        self.show(Shown::Nothing);
    }

    fn started(&self, task: &Task<'_>, from_s: f64, end_s: f64) {
        let name = match task.trial {
            None => task.name.to_owned(),
            Some(trial) => {
                let (number, most) = (trial.number, trial.most);
                format!("{}, lift {number} of at most {most}", task.name)
            }
        };
        self.show(Shown::Operation(OwnBar::new(&name, from_s, end_s, self.quiet)));
    }

    fn reached(&self, _: &Task<'_>, progress: &Progress) {
        if let Shown::Operation(bar) = &*lock(&self.shown) {
            bar.reach(progress);
        }
    }

    fn ended(&self, _: &Task<'_>) {
        self.show(Shown::Nothing);
    }
}

/// Shows a batch: one bar for all of its cases.
pub(crate) struct BatchScreen {
    /// Name of the batch: `sweep`.
    noun: &'static str,
    /// Name of its cases.
    items: &'static str,
    /// Whether the speed is shown.
    with_pace: bool,
    quiet: bool,
    shown: Mutex<Option<BatchBar>>,
}

struct BatchBar {
    bar: ProgressBar,
    start: Instant,
    /// Milliseconds of the operation that each running case solves: reached, and end.
    operations: HashMap<usize, (u64, u64)>,
}

impl BatchScreen {
    /// The screen of a sweep, or of the sweeps of a study.
    pub(crate) fn sweep(noun: &'static str, quiet: bool) -> Self {
        Self { noun, items: "cases", with_pace: true, quiet, shown: Mutex::new(None) }
    }

    /// The screen of a bit test.
    pub(crate) fn bit_test(quiet: bool) -> Self {
        Self { noun: "bit test", items: "points", with_pace: false, ..Self::sweep("", quiet) }
    }

    /// The screen of a plan.
    pub(crate) fn plan(quiet: bool) -> Self {
        Self { noun: "plan", items: "tasks", with_pace: false, ..Self::sweep("", quiet) }
    }

    /// The screen of the samples of a reach.
    pub(crate) fn reach(quiet: bool) -> Self {
        Self { noun: "reach", items: "samples", with_pace: false, ..Self::sweep("", quiet) }
    }

    /// The screen of dynamic runs of a check.
    pub(crate) fn dynamics(quiet: bool) -> Self {
        Self { noun: "dynamics", items: "runs", ..Self::sweep("", quiet) }
    }

    fn count(&self, ended: usize, total: usize) -> String {
        format!("{ended} of {total} {}", self.items)
    }
}

impl Observer for BatchScreen {
    fn diagnostics(&self, report: &Report) {
        if !self.quiet {
            print_stderr(&report.render(color()));
        }
    }

    fn note(&self, text: &str) {
        if !self.quiet {
            print_stderr(&format!("note: {text}\n"));
        }
    }

    fn warning(&self, text: &str) {
        let warning = format!("warning: {text}\n");
        match &*lock(&self.shown) {
            Some(batch) => batch.bar.suspend(|| print_stderr(&warning)),
            None => print_stderr(&warning),
        }
    }

    fn batch_started(&self, size: &BatchSize) {
        // In addition to its simulated time, a case counts as one millisecond, so that soft strings
        // move the bar too.
        let length = size.cases as u64 + milliseconds(size.simulated_s);
        let bar = bar(length, self.quiet);
        bar.set_prefix(self.noun);
        if !self.with_pace {
            bar.set_message(self.count(size.finished, size.cases));
        }
        *lock(&self.shown) =
            Some(BatchBar { bar, start: Instant::now(), operations: HashMap::new() });
    }

    fn started(&self, task: &Task<'_>, _: f64, end_s: f64) {
        // The number of trials is not known in advance.
        if task.trial.is_none()
            && let Some(batch) = &mut *lock(&self.shown)
        {
            let end = milliseconds(end_s);
            batch.operations.insert(task.case, (0, end));
        }
    }

    fn reached(&self, task: &Task<'_>, progress: &Progress) {
        if task.trial.is_none()
            && let Some(BatchBar { bar, operations, .. }) = &mut *lock(&self.shown)
            && let Some((reached, end)) = operations.get_mut(&task.case)
        {
            let (now, ends) = (milliseconds(progress.time_s), milliseconds(progress.end_s));
            // The operation is shorter than expected.
            bar.dec_length(end.saturating_sub(ends));
            bar.inc(now.saturating_sub(*reached));
            (*reached, *end) = (now, ends);
        }
    }

    fn case_ended(&self, ended: &CaseEnded) {
        let Some(BatchBar { bar, start, .. }) = &*lock(&self.shown) else {
            return;
        };
        bar.inc(1 + milliseconds(ended.reused_s));
        let count = self.count(ended.ended, ended.of);
        bar.set_message(if self.with_pace {
            let simulated_s = bar.position() as f64 * 1e-3;
            let speed = simulated_s / start.elapsed().as_secs_f64();
            format!("{count}, {}", real_time_factor(speed))
        } else {
            count
        });
    }

    fn batch_ended(&self) {
        if let Some(batch) = lock(&self.shown).take() {
            batch.bar.finish_and_clear();
        }
    }
}

/// Bars count whole milliseconds of simulated time.
fn milliseconds(seconds: f64) -> u64 {
    (seconds * 1e3).round() as u64
}

/// Target of the progress bars: standard error, hidden if that is no terminal or if `quiet` is set.
fn screen(quiet: bool) -> ProgressDrawTarget {
    if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() }
}

/// A bar on the screen.
pub(crate) fn bar(length: u64, quiet: bool) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(length), screen(quiet));
    let style = ProgressStyle::with_template("{prefix} {bar:32} {msg}{left}");
    let style = style.expect("the template is valid");
    let left = |state: &ProgressState, to: &mut dyn fmt::Write| {
        // Unknown before the first progress.
        let (done, all) = (state.pos(), state.len().unwrap_or(0));
        if done > 0 && done < all {
            let _ = write!(to, ", {} left", duration(state.eta()));
        }
    };
    bar.set_style(style.with_key("left", left).progress_chars("━╸─"));
    bar
}

/// Title of an operation on the screen.
fn title(operation: &str) -> String {
    operation.replace('_', " ")
}

/// Wall-clock time between two updates of a spinner.
const TICK: Duration = Duration::from_millis(100);

/// Shows the preparation of an operation and its elapsed time.
fn preparation(operation: &str, what: &str, quiet: bool) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(None, screen(quiet));
    let style = ProgressStyle::with_template("{prefix} {spinner} {msg}, {elapsed}");
    bar.set_style(style.expect("the template is valid"));
    bar.set_prefix(title(operation));
    bar.set_message(what.to_owned());
    bar.enable_steady_tick(TICK);
    bar
}

/// A bar with the simulated time and the speed against real time.
struct OwnBar {
    bar: ProgressBar,
    start: Instant,
    from_s: f64,
}

impl OwnBar {
    fn new(operation: &str, from_s: f64, end_s: f64, quiet: bool) -> Self {
        let bar = bar(milliseconds(end_s), quiet);
        bar.set_prefix(title(operation));
        Self { bar, start: Instant::now(), from_s }
    }

    /// Moves the bar to this progress.
    fn reach(&self, progress: &Progress) {
        let (time_s, end_s) = (progress.time_s, progress.end_s);
        self.bar.set_length(milliseconds(end_s));
        let speed = (time_s - self.from_s) / self.start.elapsed().as_secs_f64();
        self.bar.set_position(milliseconds(time_s));
        let real_time_factor = real_time_factor(speed);
        self.bar.set_message(match progress.settling {
            true => format!("{time_s:.1} of at most {end_s:.0} s, settling, {real_time_factor}"),
            false => format!("{time_s:.1} of {end_s:.0} s, {real_time_factor}"),
        });
    }
}

// Speed and duration of a simulation, in words.

/// Simulated over real time, rounded for reading.
pub(crate) fn real_time_factor(times: f64) -> String {
    if times >= 100.0 {
        format!("{times:.0} × real time")
    } else if times > 0.0 && times < 0.1 {
        format!("1/{:.0} of real time", 1.0 / times)
    } else {
        format!("{times:.1} × real time")
    }
}

/// A remaining time, rounded to its precision.
fn duration(time: Duration) -> String {
    let seconds = time.as_secs();
    match seconds {
        0..120 => format!("{seconds} s"),
        120..7200 => format!("{} min", (seconds + 30) / 60),
        _ => format!("{:.1} h", seconds as f64 / 3600.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_to_come_is_no_more_exact_than_it_is_known() {
        for (seconds, words) in [
            (0, "0 s"),
            (119, "119 s"),
            (120, "2 min"),
            (3629, "60 min"),
            (7199, "120 min"),
            (9000, "2.5 h"),
        ] {
            assert_eq!(duration(Duration::from_secs(seconds)), words);
        }
    }

    #[test]
    fn slow_runs_have_a_pace_too() {
        for (times, words) in [
            (151.6, "152 × real time"),
            (30.24, "30.2 × real time"),
            (0.42, "0.4 × real time"),
            (1.0 / 125.8, "1/126 of real time"),
            (0.0, "0.0 × real time"),
        ] {
            assert_eq!(real_time_factor(times), words);
        }
    }
}
