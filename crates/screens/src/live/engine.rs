//! The engine that advances a string, one turn at a time.

use std::{collections::VecDeque, sync::Arc, time::Duration};

use wholestring_runner::{CancellationToken, Instant, Silent, run::Live};

use super::{
    begin::{Beginning, Begun, Keeps, begin, last_controller},
    channels,
    command::LiveError,
    lamps::{Lamps, Watched},
    live_string::{FrameNow, LiveString, held},
    pace::{Next, Pace, Pacer},
    recording::RecordedEvent,
    status::{LiveState, Status},
    wanted::Asked,
};

/// Simulated time between two checkpoints, and between two starts of the window, s.
const CHECKPOINT_S: f64 = 10.0;

/// Minimum wall-clock time between two checkpoints.
const CHECKPOINT_CLOCK: Duration = Duration::from_secs(1);

/// Wall-clock time between two statuses if only the time changes.
const STATUS: Duration = Duration::from_millis(200);

/// Time until the next turn of a paused engine.
const IDLE: Duration = Duration::from_millis(250);

/// End of an engine.
#[derive(Debug)]
pub struct End {
    /// Reason.
    pub sentence: String,
    /// The final state of the string, if it can be continued.
    pub checkpoint: Option<Vec<u8>>,
}

/// A string and its simulation.
pub struct Engine {
    pub(super) string: Arc<LiveString>,
    pub(super) live: Live,
    pub(super) pacer: Pacer,
    pub(super) runs: bool,
    pub(super) step_s: f64,
    pub(super) failed: Option<String>,
    /// The last refusal.
    pub(super) refused: Option<String>,
    pub(super) controller: Option<&'static str>,
    pub(super) watched: Watched,
    pub(super) lamps: Lamps,
    /// Number of rows of the series that are sent.
    pub(super) rows: usize,
    pub(super) epoch: u32,
    pub(super) replay: VecDeque<RecordedEvent>,
    /// Simulated time and wall-clock time of the last checkpoint.
    pub(super) checkpoint: (f64, Instant),
    pub(super) last_status: Instant,
}

pub(super) fn watched(live: &Live, string: &LiveString) -> Watched {
    let (case, operation) = (&string.case, &string.operation);
    let limit = case.dynamics.top_drive.torque_limit_N_m();
    let limit = limit.or(case.model.rig.top_drive_torque_N_m);
    Watched::new(live.simulation(), limit, operation.kind.rotates())
}

impl Engine {
    /// Starts a string, initially paused. This takes a second or more.
    ///
    /// # Errors
    /// A string that cannot be solved, and one whose state takes too much memory.
    pub fn begin(id: &str, from: Beginning, keeps: &Keeps) -> Result<Self, LiveError> {
        let engine = Self::new(begin(id, from, keeps)?);
        match engine.too_large(keeps) {
            Some(large) => Err(large),
            None => Ok(engine),
        }
    }

    /// The error if the state of a string takes too much memory for it to be live.
    fn too_large(&self, keeps: &Keeps) -> Option<LiveError> {
        let bytes = held(&self.string.checkpoints).bytes();
        let most = keeps.checkpoint_bytes / 4;
        (bytes > most).then(|| {
            let message = format!(
                "the state of this string takes {} MB and may take {}: give it a coarser mesh",
                bytes >> 20,
                most >> 20
            );
            LiveError::Refused(message)
        })
    }

    /// A paused engine. Its first checkpoint is the initial state.
    fn new(begun: Begun) -> Self {
        let Begun { live, string } = begun;
        let now = Instant::now();
        let time_s = live.simulation().time_s();
        let pace = string.status.borrow().pace;
        let mut engine = Self {
            pacer: Pacer::new(pace, now, time_s),
            runs: false,
            step_s: 0.0,
            failed: None,
            refused: None,
            controller: last_controller(&string.case, &string.events()),
            watched: watched(&live, &string),
            lamps: Lamps::default(),
            rows: live.simulation().series().time_s.len(),
            epoch: 0,
            replay: VecDeque::new(),
            checkpoint: (time_s, now),
            last_status: now,
            live,
            string,
        };
        // A failure to write it is reported when one is requested.
        let _ = engine.put_checkpoint();
        engine.show();
        engine.tell();
        engine
    }

    pub(super) fn time_s(&self) -> f64 {
        self.live.simulation().time_s()
    }

    pub(super) fn sample_s(&self) -> f64 {
        self.string.layout.sample_interval_s
    }

    /// The state shared with its viewers.
    pub fn string(&self) -> Arc<LiveString> {
        self.string.clone()
    }

    /// Handles the requests and advances as far as is due; returns the time until the next turn. A
    /// request to end is left to the owner.
    pub fn turn(&mut self, requests: Asked) -> Duration {
        let mut news = requests.set.is_some() || requests.pace.is_some() || requests.run.is_some();
        if let Some(pace) = requests.pace {
            self.restart_pace(pace);
        }
        if let Some(runs) = requests.run {
            self.restart_pace(self.pacer.pace());
            self.runs = runs && self.failed.is_none();
            self.step_s = 0.0;
        }
        if self.failed.is_none() {
            self.step_s += requests.step_s;
        }
        if let Some(set) = requests.set {
            // A manual change of a set point ends a replay.
            self.replay.clear();
            self.set(set);
        }
        for command in requests.commands {
            news = true;
            self.command(command);
        }
        let wait = self.go(&mut news);
        if news || self.last_status.elapsed() >= STATUS {
            self.tell();
        }
        wait
    }

    /// Advances as far as is due; returns the time until the next turn.
    fn go(&mut self, news: &mut bool) -> Duration {
        let (time_s, sample_s) = (self.time_s(), self.sample_s());
        let steps = self.step_s > 0.0;
        let samples = if steps {
            let left = ((self.step_s / sample_s).round() as u64).max(1);
            // In slices, so that the picture moves.
            left.min(((0.02 * self.pacer.able()) / sample_s).max(1.0) as u64)
        } else if self.runs {
            match self.pacer.next(Instant::now(), time_s, sample_s) {
                Next::Go(samples) => samples,
                Next::Wait(time) => return time,
            }
        } else {
            return IDLE;
        };
        let went_s = self.advance(samples, news);
        if steps {
            self.step_s -= went_s;
            if self.step_s < 0.5 * sample_s || self.failed.is_some() {
                self.step_s = 0.0;
                *news = true;
            }
        }
        Duration::ZERO
    }

    /// Advances by a number of samples, or to the next replayed event before; returns the advance,
    /// s.
    fn advance(&mut self, samples: u64, news: &mut bool) -> f64 {
        let (sample_s, before_s) = (self.sample_s(), self.time_s());
        while self.replay.front().is_some_and(|front| front.at_s <= before_s + 0.5 * sample_s) {
            if let Some(event) = self.replay.pop_front() {
                self.set(event.set);
                *news = true;
            }
        }
        let until = self.replay.front().map_or(samples, |front| {
            (((front.at_s - before_s) / sample_s).round() as u64).clamp(1, samples)
        });
        let began = Instant::now();
        let none = CancellationToken::new();
        let advanced = self.live.advance(until as f64 * sample_s, &Silent, &none);
        let time_s = self.time_s();
        self.pacer.went(began, Instant::now(), time_s - before_s, time_s);
        if let Err(error) = advanced {
            self.failed = Some(format!("the string cannot continue from here: {error}"));
            (self.runs, self.step_s) = (false, 0.0);
            *news = true;
        }
        self.show();
        if time_s - self.checkpoint.0 >= CHECKPOINT_S {
            self.lamps = self.watched.lamps(self.live.simulation());
            self.live.restart_window();
            self.rows = 0;
            if self.checkpoint.1.elapsed() >= CHECKPOINT_CLOCK && self.failed.is_none() {
                // The next one may succeed.
                let _ = self.put_checkpoint();
                *news = true;
            }
            self.checkpoint.0 = time_s;
        }
        time_s - before_s
    }

    /// Publishes new samples and frames to the viewers.
    pub(super) fn show(&mut self) {
        let simulation = self.live.simulation();
        let series = simulation.series();
        if series.time_s.len() > self.rows {
            let rows = channels::sample_rows(series, self.rows);
            self.watched.add(simulation, self.rows);
            self.rows = series.time_s.len();
            held(&self.string.ring).extend(&rows);
        }
        if self.string.frames.receiver_count() > 0 || !self.runs {
            let columns = channels::frame_columns(&simulation.frame());
            let frame = FrameNow { epoch: self.epoch, time_s: simulation.time_s(), columns };
            self.string.frames.send_replace(Arc::new(frame));
        }
    }

    /// Publishes the status.
    fn tell(&mut self) {
        self.last_status = Instant::now();
        self.lamps = self.watched.lamps(self.live.simulation());
        let state = match (&self.failed, self.runs || self.step_s > 0.0) {
            (Some(_), _) => LiveState::Failed,
            (None, true) => LiveState::Running,
            (None, false) => LiveState::Paused,
        };
        let status = Status {
            state,
            sentence: self.failed.clone().or(self.refused.clone()),
            time_s: self.time_s(),
            pace: self.pacer.pace(),
            reached: if self.runs { self.pacer.reached() } else { 0.0 },
            checkpoints: held(&self.string.checkpoints).entries(),
            events: held(&self.string.recording).events().len(),
            replaying: self.replay.len(),
            friction: self.live.simulation().friction(),
            controller: self.controller.map(str::to_owned),
            lamps: self.lamps,
            viewers: self.string.viewers(),
        };
        self.string.status.send_replace(Arc::new(status));
    }

    pub(super) fn restart_pace(&mut self, pace: Pace) {
        self.pacer.restart(pace, Instant::now(), self.time_s());
    }

    /// Ends the string, with its final checkpoint if it is to be saved and has one.
    pub fn end(self, sentence: String, keeps: bool) -> End {
        let whole = keeps && self.failed.is_none();
        let checkpoint = whole.then(|| self.live.checkpoint().ok()).flatten();
        End { sentence, checkpoint }
    }
}
