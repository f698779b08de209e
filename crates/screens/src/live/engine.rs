//! The engine that advances a string, one turn at a time.

use std::{collections::VecDeque, sync::Arc, time::Duration};

use wholestring::dynamics::Indicators;
use wholestring_judge::Check;
use wholestring_runner::{CancellationToken, Instant, Silent, run::Live};
use wholestring_units::significant;

use super::{
    begin::{Beginning, Begun, Keeps, begin, last_controller},
    channels,
    command::LiveError,
    lamp::Lamp,
    lamps,
    live_string::{FrameNow, LiveString, held},
    long_elements,
    pace::{Next, Pace, Pacer},
    recording::RecordedEvent,
    status::{LiveState, Status},
    wanted::Asked,
    watched::Watched,
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
    pub(super) indicators: Indicators,
    /// Number of rows of the series that are sent.
    pub(super) rows: usize,
    pub(super) epoch: u32,
    pub(super) replay: VecDeque<RecordedEvent>,
    /// Simulated time and wall-clock time of the last checkpoint.
    pub(super) checkpoint: (f64, Instant),
    pub(super) last_status: Instant,
}

/// Part of the requested pace below which a string is slow.
const SLOW: f64 = 0.9;

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
            watched: Watched::new(live.simulation(), &string),
            indicators: Indicators::default(),
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
            let element = self.live.simulation().buckled_element();
            self.failed = Some(element.map_or_else(
                || format!("The string cannot continue from here: {error}"),
                |element| long_elements::stopped(&element),
            ));
            (self.runs, self.step_s) = (false, 0.0);
            *news = true;
        }
        self.show();
        if time_s - self.checkpoint.0 >= CHECKPOINT_S {
            self.indicators = self.watched.indicators(self.live.simulation());
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
        let frame = simulation.frame();
        if series.time_s.len() > self.rows {
            let rows = channels::sample_rows(series, self.rows);
            self.watched.add(simulation, self.rows);
            self.rows = series.time_s.len();
            held(&self.string.ring).extend(&rows);
            self.watched.add_frame(&frame, simulation.time_s());
        }
        if self.string.frames.receiver_count() > 0 || !self.runs {
            let columns = channels::frame_columns(&frame);
            let frame = FrameNow { epoch: self.epoch, time_s: simulation.time_s(), columns };
            self.string.frames.send_replace(Arc::new(frame));
        }
    }

    /// Publishes the status.
    fn tell(&mut self) {
        self.last_status = Instant::now();
        self.indicators = self.watched.indicators(self.live.simulation());
        let (alarms, lamps) = self.judged();
        let state = match (&self.failed, self.runs || self.step_s > 0.0) {
            (Some(_), _) => LiveState::Failed,
            (None, true) => LiveState::Running,
            (None, false) => LiveState::Paused,
        };
        let status = Status {
            state,
            sentence: self.failed.clone().or(self.refused.clone()),
            slow: self.slow(),
            time_s: self.time_s(),
            pace: self.pacer.pace(),
            reached: if self.runs { self.pacer.reached() } else { 0.0 },
            checkpoints: held(&self.string.checkpoints).entries(),
            events: held(&self.string.recording).events().len(),
            replaying: self.replay.len(),
            friction: self.live.simulation().friction(),
            controller: self.controller.map(str::to_owned),
            hole_depth_m: self.hole_depth_m(),
            alarms,
            lamps,
            viewers: self.string.viewers(),
        };
        self.string.status.send_replace(Arc::new(status));
    }

    /// The judge's checks of the present motion that need attention, and the lamps.
    fn judged(&mut self) -> (Vec<Check>, Vec<Lamp>) {
        let (string, indicators) = (&self.string, &self.indicators);
        let case = &string.case;
        let alarms = self.watched.alarms(case, string, indicators);
        let limit_N_m = case.dynamics.top_drive.torque_limit_N_m();
        let limit_N_m = limit_N_m.or(case.model.rig.top_drive_torque_N_m);
        let lamps = lamps::lamps(&self.watched, indicators, &alarms, limit_N_m);
        (alarms, lamps)
    }

    /// Depth of the hole, m: that of the bit where it is on bottom.
    fn hole_depth_m(&self) -> f64 {
        let bit_m = self.live.simulation().frame().md_m.last().copied();
        let bit_m = bit_m.unwrap_or(self.string.operation.bit_depth_m);
        if self.string.operation.kind.on_bottom() {
            return bit_m;
        }
        let sections = self.string.case.model.well.hole.sections();
        sections.last().map_or(bit_m, |section| section.to_md_m.max(bit_m))
    }

    /// The reason why a running string is slower than its pace, in a sentence.
    fn slow(&self) -> Option<String> {
        let reached = self.pacer.reached();
        let is_measured = self.runs && reached > 0.0;
        let requested = match self.pacer.pace() {
            Pace::Times(times) => Some(times),
            Pace::Fastest(_) => None,
        };
        let is_slow = requested.is_none_or(|times| reached < SLOW * times);
        let speed = || format!("{} times real time", significant(reached, 2));
        let wait = || format!("1 s takes {} s", significant(1.0 / reached, 2));
        match self.live.is_on_rock() {
            true if is_measured && is_slow && reached < SLOW => Some(format!(
                "Solid rock under the bit: the string runs at {} ({}), because the rock under each \
                 cutter is solved at every step",
                speed(),
                wait()
            )),
            true if !is_measured => Some(
                "Solid rock under the bit: the string will run far below real time, because the \
                 rock under each cutter is solved at every step"
                    .to_owned(),
            ),
            false if is_measured && is_slow && requested.is_some() => Some(format!(
                "This machine reaches {} of the {} requested",
                speed(),
                significant(requested.unwrap_or_default(), 3)
            )),
            _ => None,
        }
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
