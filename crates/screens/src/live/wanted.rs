//! Requests of viewers, until the engine handles them.

use std::{
    collections::VecDeque,
    sync::{Condvar, Mutex, MutexGuard, PoisonError},
    time::Duration,
};

use super::{
    command::{Command, LiveError},
    pace::Pace,
    set_points::SetPoints,
};

/// Maximum number of commands that wait for their responses.
const MOST_COMMANDS: usize = 16;

/// Maximum simulated time of pending steps, s.
const MOST_STEPS_S: f64 = 10.0;

/// Pending requests of viewers, in constant memory however many there are: a later one replaces an
/// earlier one.
#[derive(Debug, Default)]
pub struct Asked {
    pub(super) set: Option<SetPoints>,
    pub(super) pace: Option<Pace>,
    pub(super) run: Option<bool>,
    pub(super) step_s: f64,
    pub(super) commands: VecDeque<Command>,
    /// A request to end.
    pub end: Option<Ending>,
}

/// Request to end a string.
#[derive(Debug)]
pub struct Ending {
    /// Reason.
    pub sentence: String,
    /// Whether it is saved, to be continued.
    pub keeps: bool,
}

impl Asked {
    fn is_empty(&self) -> bool {
        let Self { set, pace, run, step_s, commands, end } = self;
        set.is_none()
            && pace.is_none()
            && run.is_none()
            && *step_s == 0.0
            && commands.is_empty()
            && end.is_none()
    }
}

/// Mailbox for the requests of viewers.
#[derive(Debug, Default)]
pub(super) struct Wanted {
    asked: Mutex<Asked>,
    news: Condvar,
}

impl Wanted {
    fn asked(&self) -> MutexGuard<'_, Asked> {
        self.asked.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn change(&self, how: impl FnOnce(&mut Asked)) {
        how(&mut self.asked());
        self.news.notify_one();
    }

    pub(super) fn set(&self, set: SetPoints) {
        self.change(|requests| match &mut requests.set {
            Some(before) => before.merge(set),
            none => *none = Some(set),
        });
    }

    pub(super) fn pace(&self, pace: Pace) {
        self.change(|requests| requests.pace = Some(pace));
    }

    pub(super) fn run(&self, runs: bool) {
        self.change(|requests| {
            requests.run = Some(runs);
            requests.step_s = 0.0;
        });
    }

    pub(super) fn step(&self, seconds: f64) {
        self.change(|requests| {
            requests.run = Some(false);
            requests.step_s = (requests.step_s + seconds).min(MOST_STEPS_S);
        });
    }

    pub(super) fn end(&self, end: Ending) {
        self.change(|requests| requests.end = requests.end.take().or(Some(end)));
    }

    pub(super) fn command(&self, command: Command) -> Result<(), LiveError> {
        let mut requests = self.asked();
        if requests.commands.len() == MOST_COMMANDS {
            let message = format!("{MOST_COMMANDS} requests wait for this string already");
            return Err(LiveError::TooMany(message));
        }
        requests.commands.push_back(command);
        self.news.notify_one();
        Ok(())
    }

    /// Takes the pending requests.
    pub(super) fn take(&self) -> Asked {
        std::mem::take(&mut self.asked())
    }

    /// Takes the pending requests, after waiting for one at most this long.
    pub(super) fn take_within(&self, within: Duration) -> Asked {
        let requests = self.asked();
        let waited = self.news.wait_timeout_while(requests, within, |requests| requests.is_empty());
        let (mut requests, _) = waited.unwrap_or_else(PoisonError::into_inner);
        std::mem::take(&mut requests)
    }
}
