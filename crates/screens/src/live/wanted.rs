//! What viewers want of a string, until its engine takes it.

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

/// Requests that wait for their answers.
const MOST_COMMANDS: usize = 16;

/// Simulated time that steps may ask for at once, s.
const MOST_STEPS_S: f64 = 10.0;

/// What viewers want. It takes no more memory however often they ask: the later holds.
#[derive(Debug, Default)]
pub struct Asked {
    pub(super) set: Option<SetPoints>,
    pub(super) pace: Option<Pace>,
    pub(super) run: Option<bool>,
    pub(super) step_s: f64,
    pub(super) commands: VecDeque<Command>,
    /// It is to end.
    pub end: Option<Ending>,
}

/// How a string is to end.
#[derive(Debug)]
pub struct Ending {
    /// Why.
    pub sentence: String,
    /// Whether it is kept, to be continued.
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

/// Where viewers leave what they want.
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
        self.change(|asked| match &mut asked.set {
            Some(before) => before.merge(set),
            none => *none = Some(set),
        });
    }

    pub(super) fn pace(&self, pace: Pace) {
        self.change(|asked| asked.pace = Some(pace));
    }

    pub(super) fn run(&self, runs: bool) {
        self.change(|asked| {
            asked.run = Some(runs);
            asked.step_s = 0.0;
        });
    }

    pub(super) fn step(&self, seconds: f64) {
        self.change(|asked| {
            asked.run = Some(false);
            asked.step_s = (asked.step_s + seconds).min(MOST_STEPS_S);
        });
    }

    pub(super) fn end(&self, end: Ending) {
        self.change(|asked| asked.end = asked.end.take().or(Some(end)));
    }

    pub(super) fn command(&self, command: Command) -> Result<(), LiveError> {
        let mut asked = self.asked();
        if asked.commands.len() == MOST_COMMANDS {
            let message = format!("{MOST_COMMANDS} requests wait for this string already");
            return Err(LiveError::TooMany(message));
        }
        asked.commands.push_back(command);
        self.news.notify_one();
        Ok(())
    }

    /// What is wanted now.
    pub(super) fn take(&self) -> Asked {
        std::mem::take(&mut self.asked())
    }

    /// What is wanted now, or comes to be within a time.
    pub(super) fn take_within(&self, within: Duration) -> Asked {
        let asked = self.asked();
        let waited = self.news.wait_timeout_while(asked, within, |asked| asked.is_empty());
        let (mut asked, _) = waited.unwrap_or_else(PoisonError::into_inner);
        std::mem::take(&mut asked)
    }
}
