//! The state that viewers and the engine of a live string share.

use std::{
    sync::{
        Arc, Mutex, MutexGuard, PoisonError,
        atomic::{AtomicUsize, Ordering},
    },
    time::Duration,
};

use tokio::sync::{oneshot, watch};
use wholestring::operation::Operation;
use wholestring_case::Case;
use wholestring_runner::Instant;
use wholestring_units::UnitSet;

use super::{
    checkpoints::{CheckpointEntry, Checkpoints},
    command::{Command, LiveError, Reply},
    layout::Layout,
    pace::Pace,
    recording::{RecordedEvent, Recording},
    ring::{Ring, Samples},
    set_points::SetPoints,
    status::{LiveState, Status},
    wanted::{Asked, Ending, Wanted},
};

/// The whole string at one moment, as sent.
#[derive(Debug, Default)]
pub struct FrameNow {
    /// Number of rewinds so far.
    pub epoch: u32,
    /// Its time, s.
    pub time_s: f64,
    /// The columns, one after the other.
    pub columns: Vec<f32>,
}

/// A live string, for its viewers.
pub struct LiveString {
    /// The layout that a viewer needs first.
    pub layout: Layout,
    pub(super) case: Arc<Case>,
    pub(super) operation: Operation,
    /// The text of the case at the start.
    pub text: String,
    pub(super) frames: watch::Sender<Arc<FrameNow>>,
    pub(super) status: watch::Sender<Arc<Status>>,
    pub(super) ring: Mutex<Ring>,
    pub(super) checkpoints: Mutex<Checkpoints>,
    pub(super) recording: Mutex<Recording>,
    pub(super) wanted: Wanted,
    viewers: AtomicUsize,
    looked: Mutex<Instant>,
}

/// The parts of a live string.
pub(super) struct Parts {
    pub(super) layout: Layout,
    pub(super) case: Arc<Case>,
    pub(super) operation: Operation,
    pub(super) text: String,
    pub(super) events: Vec<RecordedEvent>,
    pub(super) checkpoint_bytes: usize,
    pub(super) time_s: f64,
    pub(super) pace: Pace,
}

/// Counts a viewer until it is dropped.
pub struct Viewer(Arc<LiveString>);

impl Drop for Viewer {
    fn drop(&mut self) {
        self.0.viewers.fetch_sub(1, Ordering::Relaxed);
        self.0.look();
    }
}

pub(super) fn held<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    // The state behind these locks is consistent between any two lines.
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl LiveString {
    pub(super) fn new(parts: Parts) -> Self {
        let Parts { layout, case, operation, text, events, checkpoint_bytes, time_s, pace } = parts;
        let next = (time_s / layout.sample_interval_s).round() as u64;
        let ring = Ring::new(layout.samples_kept, next);
        Self {
            layout,
            case,
            operation,
            text,
            frames: watch::Sender::new(Arc::default()),
            status: watch::Sender::new(Arc::new(Status::new(pace, time_s))),
            ring: Mutex::new(ring),
            checkpoints: Mutex::new(Checkpoints::new(checkpoint_bytes)),
            recording: Mutex::new(Recording::of(events)),
            wanted: Wanted::default(),
            viewers: AtomicUsize::new(0),
            looked: Mutex::new(Instant::now()),
        }
    }

    /// Counts a viewer.
    pub fn view(self: &Arc<Self>) -> Viewer {
        self.viewers.fetch_add(1, Ordering::Relaxed);
        Viewer(self.clone())
    }

    fn look(&self) {
        *held(&self.looked) = Instant::now();
    }

    /// Number of pages that view it.
    pub(super) fn viewers(&self) -> usize {
        self.viewers.load(Ordering::Relaxed)
    }

    /// Time since the last viewer left.
    pub fn unseen(&self) -> Duration {
        if self.viewers() > 0 { Duration::ZERO } else { held(&self.looked).elapsed() }
    }

    /// Receiver of the latest frame.
    pub fn frames(&self) -> watch::Receiver<Arc<FrameNow>> {
        self.frames.subscribe()
    }

    /// Receiver of the status.
    pub fn status(&self) -> watch::Receiver<Arc<Status>> {
        self.status.subscribe()
    }

    /// Samples from this number of an epoch on.
    pub fn samples(&self, epoch: u32, number: u64, most: usize) -> Option<Samples> {
        held(&self.ring).since(epoch, number, most)
    }

    /// Takes the pending requests of the viewers, after waiting for one at most this long.
    pub fn wanted_within(&self, time: Duration) -> Asked {
        self.wanted.take_within(time)
    }

    /// Takes the pending requests of the viewers.
    pub fn wanted_now(&self) -> Asked {
        self.wanted.take()
    }

    /// Marks the string as ended, with the reason.
    pub fn ended(&self, sentence: String) -> Status {
        let now = self.status.borrow().clone();
        let status = Status { state: LiveState::Ended, sentence: Some(sentence), ..(*now).clone() };
        self.status.send_replace(Arc::new(status.clone()));
        status
    }

    /// Whether it has ended.
    pub fn has_ended(&self) -> bool {
        self.status.borrow().state == LiveState::Ended
    }

    /// Applies set points.
    ///
    /// # Errors
    /// Set points that the operation does not accept.
    pub fn set(&self, set: SetPoints) -> Result<(), LiveError> {
        if let Some(fault) = set.fault(&self.operation) {
            return Err(LiveError::Refused(fault));
        }
        let judge = self.case.judge(UnitSet::Si);
        let too_heavy = set
            .weight_on_bit_N
            .and_then(|weight_N| judge.set_weight(&self.case.model, &self.operation, weight_N));
        if let Some(check) = too_heavy {
            return Err(LiveError::Refused(format!("{}. It was not set", check.wording)));
        }
        if !set.is_empty() {
            self.wanted.set(set);
        }
        Ok(())
    }

    /// Changes the pace.
    ///
    /// # Errors
    /// An invalid pace.
    pub fn pace(&self, pace: Pace) -> Result<(), LiveError> {
        if !pace.is_sound() {
            let message = "a pace is 0.01 to 1000 times real time, or \"max\"";
            return Err(LiveError::Refused(message.to_owned()));
        }
        self.wanted.pace(pace);
        Ok(())
    }

    /// Runs or pauses the string.
    pub fn run(&self, runs: bool) {
        self.wanted.run(runs);
    }

    /// Advances by this many seconds, and pauses then.
    ///
    /// # Errors
    /// An invalid time.
    pub fn step(&self, seconds: f64) -> Result<(), LiveError> {
        if !(seconds > 0.0 && seconds <= 10.0) {
            return Err(LiveError::Refused("a step is more than 0 s and at most 10 s".to_owned()));
        }
        self.wanted.step(seconds);
        Ok(())
    }

    /// Ends the string, and saves it for continuation if requested.
    pub fn end(&self, why: &str, keeps: bool) {
        self.wanted.end(Ending { sentence: why.to_owned(), keeps });
    }

    /// Its case.
    pub fn case(&self) -> Arc<Case> {
        self.case.clone()
    }

    /// The set points so far.
    pub fn events(&self) -> Vec<RecordedEvent> {
        held(&self.recording).events().to_vec()
    }

    async fn ask<T>(&self, command: impl FnOnce(Reply<T>) -> Command) -> Result<T, LiveError> {
        let ended = || {
            let sentence = self.status.borrow().sentence.clone();
            LiveError::Ended(sentence.unwrap_or_else(|| "this string has ended".to_owned()))
        };
        if self.has_ended() {
            return Err(ended());
        }
        let (reply, answer) = oneshot::channel();
        self.wanted.command(command(reply))?;
        answer.await.unwrap_or_else(|_| Err(ended()))
    }

    /// Rewinds to a checkpoint; with `replay`, the later events are applied again.
    ///
    /// # Errors
    /// An unknown checkpoint.
    pub async fn rewind(&self, number: u64, replay: bool) -> Result<(), LiveError> {
        self.look();
        self.ask(|reply| Command::Rewind { number, replay, reply }).await
    }

    /// A checkpoint of now, or the one with this number, with the events until then.
    ///
    /// # Errors
    /// An unknown checkpoint.
    pub(super) async fn moment(&self, number: Option<u64>) -> Result<Moment, LiveError> {
        self.look();
        let number = match number {
            Some(number) => number,
            None => self.ask(|reply| Command::Checkpoint { reply }).await?,
        };
        let found = held(&self.checkpoints).get(number);
        let (CheckpointEntry { time_s, .. }, bytes) =
            found.ok_or(LiveError::Nothing("checkpoint"))?;
        let mut recording = held(&self.recording).clone();
        recording.split_from(time_s);
        Ok(Moment { time_s, bytes, events: recording.events().to_vec() })
    }
}

/// A complete moment of a live string.
pub(super) struct Moment {
    /// Its time, s.
    pub(super) time_s: f64,
    /// The checkpoint.
    pub(super) bytes: Arc<Vec<u8>>,
    /// The events until then.
    pub(super) events: Vec<RecordedEvent>,
}
