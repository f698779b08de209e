//! The progress of dynamic runs on the terminal.

use std::{
    cell::Cell,
    fmt,
    time::{Duration, Instant},
};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

use crate::pace::{duration, pace};

/// Who watches a run.
#[derive(Debug, Clone)]
pub(crate) enum Watch {
    /// The user: a bar for each operation, unless nothing is to be shown.
    Screen {
        /// Show nothing.
        quiet: bool,
    },
    /// The bar of a sweep, of which this run is a part.
    Sweep(ProgressBar),
}

impl Watch {
    /// The progress of one operation that goes on at `from_s` of simulated time and ends at `end_s`.
    pub(crate) fn operation(&self, name: &str, from_s: f64, end_s: f64) -> Progress {
        match self {
            Self::Screen { quiet } => Progress::Own(OwnBar::new(name, from_s, end_s, *quiet)),
            Self::Sweep(bar) => Progress::Part {
                bar: bar.clone(),
                reached: Cell::new(0),
                end: Cell::new(milliseconds(end_s)),
            },
        }
    }

    /// The progress of a run that only serves to find a setting; a sweep shows none, for nobody knows how many there will be.
    pub(crate) fn trial(&self, name: &str, end_s: f64) -> Option<OwnBar> {
        match self {
            Self::Screen { quiet } => Some(OwnBar::new(name, 0.0, end_s, *quiet)),
            Self::Sweep(_) => None,
        }
    }

    /// Shows what is done before an operation's time begins, which takes seconds, or minutes on rock, and counts nothing, until what it gives is
    /// dropped. A sweep goes on showing its bar.
    pub(crate) fn preparing(&self, name: &str, what: &'static str) -> Option<Preparing> {
        match self {
            Self::Screen { quiet } => Some(Preparing::new(name, what, *quiet)),
            Self::Sweep(_) => None,
        }
    }

    /// Says something on standard error, beside the bar.
    pub(crate) fn tell(&self, text: &str) {
        match self {
            Self::Screen { .. } => crate::tell(text),
            Self::Sweep(bar) => bar.suspend(|| crate::tell(text)),
        }
    }
}

/// Bars count whole milliseconds of simulated time.
pub(crate) fn milliseconds(seconds: f64) -> u64 {
    (seconds * 1e3).round() as u64
}

/// The progress of one operation.
pub(crate) enum Progress {
    Own(OwnBar),
    Part {
        bar: ProgressBar,
        reached: Cell<u64>,
        end: Cell<u64>,
    },
}

impl Progress {
    /// Says when the operation ends now; at the latest while it `settles`. Of the bar of a sweep that is what it is shorter by.
    pub(crate) fn ends(&self, end_s: f64, settles: bool) {
        match self {
            Self::Own(own) => own.ends(end_s, settles),
            Self::Part { bar, end, .. } => {
                let now = milliseconds(end_s);
                bar.dec_length(end.replace(now).saturating_sub(now));
            }
        }
    }

    /// Shows the simulated time reached.
    pub(crate) fn reach(&self, time_s: f64) {
        match self {
            Self::Own(own) => own.reach(time_s),
            Self::Part { bar, reached, .. } => {
                let now = milliseconds(time_s);
                bar.inc(now.saturating_sub(reached.replace(now)));
            }
        }
    }

    /// Takes the operation's own bar from the screen.
    pub(crate) fn finish(self) {
        if let Self::Own(own) = self {
            own.clear();
        }
    }
}

/// Where progress is shown: on standard error, unless that is no terminal or nothing is to be shown.
fn screen(quiet: bool) -> ProgressDrawTarget {
    if quiet {
        ProgressDrawTarget::hidden()
    } else {
        ProgressDrawTarget::stderr()
    }
}

/// A bar on the screen.
pub(crate) fn bar(length: u64, quiet: bool) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(length), screen(quiet));
    let style = ProgressStyle::with_template("{prefix} {bar:32} {msg}{left}");
    let style = style.expect("the template is sound");
    let left = |state: &ProgressState, to: &mut dyn fmt::Write| {
        // Nobody knows before something is done.
        let (done, all) = (state.pos(), state.len().unwrap_or(0));
        if done > 0 && done < all {
            let _ = write!(to, ", {} left", duration(state.eta()));
        }
    };
    bar.set_style(style.with_key("left", left).progress_chars("━╸─"));
    bar
}

/// What an operation is called on the screen.
fn title(operation: &str) -> String {
    operation.replace('_', " ")
}

/// Time on the clock between two movements of what shows that something is done.
const TICK: Duration = Duration::from_millis(100);

/// What is done before an operation's time begins, and for how long already.
pub(crate) struct Preparing(ProgressBar);

impl Preparing {
    fn new(operation: &str, what: &'static str, quiet: bool) -> Self {
        let bar = ProgressBar::with_draw_target(None, screen(quiet));
        let style = ProgressStyle::with_template("{prefix} {spinner} {msg}, {elapsed}");
        bar.set_style(style.expect("the template is sound"));
        bar.set_prefix(title(operation));
        bar.set_message(what);
        bar.enable_steady_tick(TICK);
        Self(bar)
    }
}

impl Drop for Preparing {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}

/// A bar with the simulated time and the speed against real time.
pub(crate) struct OwnBar {
    bar: ProgressBar,
    start: Instant,
    from_s: f64,
    end_s: Cell<f64>,
    settles: Cell<bool>,
}

impl OwnBar {
    fn new(operation: &str, from_s: f64, end_s: f64, quiet: bool) -> Self {
        let bar = bar(milliseconds(end_s), quiet);
        bar.set_prefix(title(operation));
        Self {
            bar,
            start: Instant::now(),
            from_s,
            end_s: Cell::new(end_s),
            settles: Cell::new(false),
        }
    }

    /// Says when it ends now; at the latest while it `settles`.
    pub(crate) fn ends(&self, end_s: f64, settles: bool) {
        self.bar.set_length(milliseconds(end_s));
        self.end_s.set(end_s);
        self.settles.set(settles);
    }

    /// Takes the bar from the screen.
    pub(crate) fn clear(self) {
        self.bar.finish_and_clear();
    }

    /// Shows the simulated time reached.
    pub(crate) fn reach(&self, time_s: f64) {
        let speed = (time_s - self.from_s) / self.start.elapsed().as_secs_f64();
        self.bar.set_position(milliseconds(time_s));
        let (end_s, pace) = (self.end_s.get(), pace(speed));
        self.bar.set_message(match self.settles.get() {
            true => format!("{time_s:.1} of at most {end_s:.0} s, settling, {pace}"),
            false => format!("{time_s:.1} of {end_s:.0} s, {pace}"),
        });
    }
}
