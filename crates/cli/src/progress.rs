//! The progress of a dynamic run on the terminal.

use std::time::Instant;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// A bar with the simulated time and the speed against real time; nothing where nobody watches.
pub(crate) struct Progress {
    bar: ProgressBar,
    start: Instant,
    end_s: f64,
}

/// The bar counts whole milliseconds of simulated time.
fn milliseconds(seconds: f64) -> u64 {
    (seconds * 1e3).round() as u64
}

impl Progress {
    /// A bar for one operation that ends at `end_s` of simulated time.
    pub(crate) fn new(operation: &str, end_s: f64, quiet: bool) -> Self {
        // Hidden by itself where standard error is no terminal.
        let target = if quiet {
            ProgressDrawTarget::hidden()
        } else {
            ProgressDrawTarget::stderr()
        };
        let bar = ProgressBar::with_draw_target(Some(milliseconds(end_s)), target);
        let style = ProgressStyle::with_template("{prefix} {bar:32} {msg}");
        bar.set_style(style.expect("the template is sound").progress_chars("━╸─"));
        bar.set_prefix(operation.replace('_', " "));
        Self {
            bar,
            start: Instant::now(),
            end_s,
        }
    }

    /// Shows the simulated time reached.
    pub(crate) fn reach(&self, time_s: f64) {
        let speed = time_s / self.start.elapsed().as_secs_f64();
        self.bar.set_position(milliseconds(time_s));
        self.bar.set_message(format!(
            "{time_s:.1} of {:.0} s, {speed:.0} × real time",
            self.end_s
        ));
    }

    /// Takes the bar from the screen.
    pub(crate) fn finish(self) {
        self.bar.finish_and_clear();
    }
}
