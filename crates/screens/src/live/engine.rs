//! What takes a string forward, a turn at a time.

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

/// Simulated time between two checkpoints, and between two beginnings of the window, s.
const CHECKPOINT_S: f64 = 10.0;

/// Wall-clock time between two checkpoints at least.
const CHECKPOINT_CLOCK: Duration = Duration::from_secs(1);

/// Wall-clock time between two statuses where nothing changes but time.
const STATUS: Duration = Duration::from_millis(200);

/// How long nothing is due of an engine that waits.
const IDLE: Duration = Duration::from_millis(250);

/// How an engine ended.
#[derive(Debug)]
pub struct End {
    /// Why.
    pub sentence: String,
    /// The string as it stood, where that can be continued.
    pub checkpoint: Option<Vec<u8>>,
}

/// A string and what takes it forward.
pub struct Engine {
    pub(super) string: Arc<LiveString>,
    pub(super) live: Live,
    pub(super) pacer: Pacer,
    pub(super) runs: bool,
    pub(super) step_s: f64,
    pub(super) failed: Option<String>,
    /// What was refused last.
    pub(super) refused: Option<String>,
    pub(super) controller: Option<&'static str>,
    pub(super) watched: Watched,
    pub(super) lamps: Lamps,
    /// Rows of the series that are sent.
    pub(super) rows: usize,
    pub(super) epoch: u32,
    pub(super) replay: VecDeque<RecordedEvent>,
    /// Simulated time and wall-clock time of the last checkpoint.
    pub(super) checkpoint: (f64, Instant),
    pub(super) told: Instant,
}

pub(super) fn watched(live: &Live, string: &LiveString) -> Watched {
    let (case, operation) = (&string.case, &string.operation);
    let limit = case.dynamics.top_drive.torque_limit_N_m();
    let limit = limit.or(case.model.rig.top_drive_torque_N_m);
    Watched::new(live.simulation(), limit, operation.kind.rotates())
}

impl Engine {
    /// Begins a string, which waits. This takes a second or more.
    ///
    /// # Errors
    /// A string that cannot be, and one whose state takes too much memory.
    pub fn begin(id: &str, from: Beginning, keeps: &Keeps) -> Result<Self, LiveError> {
        let engine = Self::new(begin(id, from, keeps)?);
        match engine.too_large(keeps) {
            Some(large) => Err(large),
            None => Ok(engine),
        }
    }

    /// Why a string is not to be live, where its state takes too much memory.
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

    /// An engine that waits. Its first checkpoint is that of now.
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
            told: now,
            live,
            string,
        };
        // One that cannot be written is said when it is asked for.
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

    /// What its viewers share.
    pub fn string(&self) -> Arc<LiveString> {
        self.string.clone()
    }

    /// Does what is asked and goes on as far as is due; how long nothing is due then. That the
    /// string is to end is left to who holds it.
    pub fn turn(&mut self, asked: Asked) -> Duration {
        let mut news = asked.set.is_some() || asked.pace.is_some() || asked.run.is_some();
        if let Some(pace) = asked.pace {
            self.restart_pace(pace);
        }
        if let Some(runs) = asked.run {
            self.restart_pace(self.pacer.pace());
            self.runs = runs && self.failed.is_none();
            self.step_s = 0.0;
        }
        if self.failed.is_none() {
            self.step_s += asked.step_s;
        }
        if let Some(set) = asked.set {
            // Whoever takes hold of a knob ends what is being done again.
            self.replay.clear();
            self.set(set);
        }
        for command in asked.commands {
            news = true;
            self.command(command);
        }
        let wait = self.go(&mut news);
        if news || self.told.elapsed() >= STATUS {
            self.tell();
        }
        wait
    }

    /// Goes on as far as is due; how long nothing is due then.
    fn go(&mut self, news: &mut bool) -> Duration {
        let (time_s, sample_s) = (self.time_s(), self.sample_s());
        let steps = self.step_s > 0.0;
        let samples = if steps {
            let left = ((self.step_s / sample_s).round() as u64).max(1);
            // In slices, so that what is seen moves.
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

    /// Goes on by so many samples, or to what is to be done again before; how far, s.
    fn advance(&mut self, samples: u64, news: &mut bool) -> f64 {
        let (sample_s, before_s) = (self.sample_s(), self.time_s());
        while self.replay.front().is_some_and(|of| of.at_s <= before_s + 0.5 * sample_s) {
            if let Some(event) = self.replay.pop_front() {
                self.set(event.set);
                *news = true;
            }
        }
        let until = self.replay.front().map_or(samples, |of| {
            (((of.at_s - before_s) / sample_s).round() as u64).clamp(1, samples)
        });
        let began = Instant::now();
        let none = CancellationToken::new();
        let advanced = self.live.advance(until as f64 * sample_s, &Silent, &none);
        let time_s = self.time_s();
        self.pacer.went(began, Instant::now(), time_s - before_s, time_s);
        if let Err(error) = advanced {
            self.failed = Some(format!("the string cannot go on from here: {error}"));
            (self.runs, self.step_s) = (false, 0.0);
            *news = true;
        }
        self.show();
        if time_s - self.checkpoint.0 >= CHECKPOINT_S {
            self.lamps = self.watched.lamps(self.live.simulation());
            self.live.restart_window();
            self.rows = 0;
            if self.checkpoint.1.elapsed() >= CHECKPOINT_CLOCK && self.failed.is_none() {
                // The next one may go.
                let _ = self.put_checkpoint();
                *news = true;
            }
            self.checkpoint.0 = time_s;
        }
        time_s - before_s
    }

    /// Gives viewers what is new.
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

    /// Says how it is doing.
    fn tell(&mut self) {
        self.told = Instant::now();
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

    /// Ends it, with what it is continued from where it is to be kept and can be.
    pub fn end(self, sentence: String, keeps: bool) -> End {
        let whole = keeps && self.failed.is_none();
        let checkpoint = whole.then(|| self.live.checkpoint().ok()).flatten();
        End { sentence, checkpoint }
    }
}
