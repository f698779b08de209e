//! Changes of the set points by the driller during a run, against time.

use serde::{Deserialize, Serialize};

use crate::damage::{Damaged, ensure};
use crate::operation::Operation;

/// Set point of the hoist, which moves the top of the string along the hole.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum HoistSetPoint {
    /// The block moves at a speed, m/s, positive downwards.
    BlockVelocity(f64),
    /// The autodriller holds a weight on bit, N.
    WeightOnBit(f64),
}

/// One line of the plan: from a time on, its set points go to their new values and stay there.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ScheduleStep {
    /// When it begins, s from time zero of the run.
    pub at_s: f64,
    /// Time in which the set points go to their new values, in proportion to it, s; zero is at
    /// once.
    pub ramp_s: f64,
    /// Rotary speed at surface, rad/s.
    pub rotary_speed_rad_per_s: Option<f64>,
    /// Set point of the hoist.
    pub hoist: Option<HoistSetPoint>,
    /// Flow rate of the pumps, m³/s.
    pub flow_rate_m3_per_s: Option<f64>,
    /// Label in the table against time.
    pub note: Option<String>,
}

impl ScheduleStep {
    fn end_s(&self) -> f64 {
        self.at_s + self.ramp_s
    }

    /// Whether it changes a set point.
    fn moves(&self) -> bool {
        self.rotary_speed_rad_per_s.is_some()
            || self.hoist.is_some()
            || self.flow_rate_m3_per_s.is_some()
    }
}

/// A plan: lines in the order of their times. Empty, the operation's own set points hold
/// throughout.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Schedule {
    /// Its lines.
    pub steps: Vec<ScheduleStep>,
}

/// Why a plan cannot be followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum ScheduleFault {
    /// A time or a set point that is not finite, or a time that is negative.
    #[error("a time or a set point is out of range")]
    Range,
    /// A line begins before the one above it.
    #[error("it begins before the line above it")]
    Order,
    /// A line names a set point that another line is still ramping, or sets at the same time.
    #[error("it begins while `{0}` is still on its way to the last set point")]
    Ramping(&'static str),
}

impl Schedule {
    /// Whether there is nothing to follow.
    pub fn is_empty(&self) -> bool {
        self.steps.is_empty()
    }

    /// Whether any line moves the hoist.
    pub fn moves_the_hoist(&self) -> bool {
        self.steps.iter().any(|step| step.hoist.is_some())
    }

    /// Whether any line puts the autodriller in control.
    pub fn holds_a_weight(&self) -> bool {
        let holds = |step: &ScheduleStep| matches!(step.hoist, Some(HoistSetPoint::WeightOnBit(_)));
        self.steps.iter().any(holds)
    }

    /// The first line that cannot be followed, and why.
    pub fn fault(&self) -> Option<(usize, ScheduleFault)> {
        let (mut speed_s, mut hoist_s, mut flow_s) = (None, None, None);
        let mut above_s = 0.0;
        for (index, step) in self.steps.iter().enumerate() {
            let hoist = step.hoist.map(|set| match set {
                HoistSetPoint::BlockVelocity(value) | HoistSetPoint::WeightOnBit(value) => value,
            });
            let values = [step.rotary_speed_rad_per_s, hoist, step.flow_rate_m3_per_s];
            let times = [step.at_s, step.ramp_s];
            let timely = times.iter().all(|time| time.is_finite() && *time >= 0.0);
            if !timely || values.iter().flatten().any(|value| !value.is_finite()) {
                return Some((index, ScheduleFault::Range));
            }
            if step.at_s < above_s {
                return Some((index, ScheduleFault::Order));
            }
            above_s = step.at_s;
            let channels = [
                ("rpm", values[0], &mut speed_s),
                ("the hoist", values[1], &mut hoist_s),
                ("flow_rate", values[2], &mut flow_s),
            ];
            for (name, value, busy) in channels {
                if value.is_none() {
                    continue;
                }
                let cut = busy.is_some_and(|(from, to): (f64, f64)| {
                    step.at_s < to - 1e-9 * to || step.at_s == from
                });
                if cut {
                    return Some((index, ScheduleFault::Ramping(name)));
                }
                *busy = Some((step.at_s, step.end_s()));
            }
        }
        None
    }

    /// Set point of the hoist at time zero, if a line sets it there at once.
    pub fn hoist_at_time_zero(&self) -> Option<HoistSetPoint> {
        let first = self.steps.iter().filter(|step| step.end_s() <= 0.0);
        first.filter_map(|step| step.hoist).next_back()
    }

    /// Time at which its last line is done, s; zero where it is empty.
    pub fn end_s(&self) -> f64 {
        let ends = self.steps.iter().map(ScheduleStep::end_s);
        ends.fold(0.0, f64::max)
    }

    /// Time of the first change of a set point after time zero, s; none without one.
    pub fn first_change_s(&self) -> Option<f64> {
        self.steps.iter().find(|step| step.end_s() > 0.0 && step.moves()).map(|step| step.at_s)
    }

    /// The operation's set points as they are at time zero: values that the first lines set there
    /// at once apply from the beginning. Where they move the block, a bit on bottom has no weight
    /// yet: it touches the rock.
    pub fn at_time_zero(&self, operation: &Operation) -> Operation {
        let mut start = *operation;
        for step in self.steps.iter().filter(|step| step.end_s() <= 0.0) {
            if let Some(speed) = step.rotary_speed_rad_per_s {
                start.rotary_speed_rad_per_s = speed;
            }
            if let Some(flow) = step.flow_rate_m3_per_s {
                start.bit_pressure_drop_Pa = operation.bit_loss_Pa(flow);
                start.flow_rate_m3_per_s = flow;
            }
        }
        match self.hoist_at_time_zero() {
            Some(HoistSetPoint::WeightOnBit(weight)) => start.weight_on_bit_N = weight,
            Some(HoistSetPoint::BlockVelocity(_)) => start.weight_on_bit_N = 0.0,
            None => {}
        }
        // The bit's torque goes with its weight, and a bit that does not turn has none yet.
        if operation.kind.rotates() && start.rotary_speed_rad_per_s == 0.0 {
            start.bit_torque_N_m = 0.0;
        } else if operation.weight_on_bit_N > 0.0 {
            start.bit_torque_N_m *= start.weight_on_bit_N / operation.weight_on_bit_N;
        }
        start
    }
}

/// A set point on its way from one value to the next.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(in crate::dynamics) struct Ramp {
    from: f64,
    to: f64,
    at_s: f64,
    end_s: f64,
}

impl Ramp {
    /// One that is there.
    pub(in crate::dynamics) fn resting(value: f64) -> Self {
        Self { from: value, to: value, at_s: 0.0, end_s: 0.0 }
    }

    /// From one value to another from a time on, s, within so many seconds.
    pub(in crate::dynamics) fn new([from, to]: [f64; 2], at_s: f64, ramp_s: f64) -> Self {
        Self { from, to, at_s, end_s: at_s + ramp_s }
    }

    fn begin(from: f64, to: f64, step: &ScheduleStep) -> Self {
        Self::new([from, to], step.at_s, step.ramp_s)
    }

    /// End of the ramp.
    pub(in crate::dynamics) fn end(&self) -> f64 {
        self.to
    }

    pub(in crate::dynamics) fn at(&self, time_s: f64) -> f64 {
        if time_s >= self.end_s {
            return self.to;
        }
        let part = (time_s - self.at_s) / (self.end_s - self.at_s);
        libm::fma(self.to - self.from, part.max(0.0), self.from)
    }
}

/// Starting point of a ramp of the hoist where the set point before it was of the other kind.
#[derive(Debug, Clone, Copy)]
pub struct HoistNow {
    /// Speed of the block, m/s, positive downwards.
    pub block_velocity_m_per_s: f64,
    /// Weight on bit as the autodriller sees it, N.
    pub weight_on_bit_N: f64,
}

/// Follows a plan: the set points of a run, moment by moment.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct SetPoints {
    steps: Vec<ScheduleStep>,
    next: usize,
    speed: Ramp,
    /// None until a line moves the hoist; then its kind and its value.
    hoist: Option<(HoistSetPoint, Ramp)>,
    /// None until a line sets the pumps.
    flow: Option<Ramp>,
    first_flow_m3_per_s: f64,
}

impl SetPoints {
    /// Whether stored set points are those of this schedule, with the lines that were added.
    pub(in crate::dynamics) fn check(&self, schedule: &Schedule) -> Result<(), Damaged> {
        let mut stored = self.steps.iter();
        let holds_all = schedule.steps.iter().all(|line| stored.any(|stored| stored == line));
        ensure(holds_all && self.next <= self.steps.len(), "the schedule")
    }

    /// Adds a line, in the order of its time. It replaces a line that is still ramping the same set
    /// point; a time in the past counts as now.
    ///
    /// # Errors
    /// A time or a set point that is not finite, or a time that is negative.
    pub fn add(&mut self, line: ScheduleStep) -> Result<(), ScheduleFault> {
        if let Some((_, fault)) = (Schedule { steps: vec![line.clone()] }).fault() {
            return Err(fault);
        }
        let later = self.steps[self.next..].iter().position(|step| step.at_s > line.at_s);
        let place = later.map_or(self.steps.len(), |later| self.next + later);
        self.steps.insert(place, line);
        Ok(())
    }

    /// Drops those of the first `count` lines that are not lines of this schedule, and returns how
    /// many they were.
    pub(in crate::dynamics) fn drop_added(&mut self, count: usize, schedule: &Schedule) -> usize {
        let mut planned = schedule.steps.iter().peekable();
        let begun = count.min(self.next);
        let before = self.steps.len();
        let mut place = 0;
        self.steps.retain(|line| {
            let is_planned = planned.next_if(|planned| *planned == line).is_some();
            place += 1;
            is_planned || place > begun
        });
        let dropped = before - self.steps.len();
        self.next -= dropped;
        dropped
    }

    /// The set points of `operation` until `schedule` changes them.
    pub fn new(operation: &Operation, schedule: &Schedule) -> Self {
        Self {
            steps: schedule.steps.clone(),
            next: 0,
            speed: Ramp::resting(operation.rotation_rad_per_s()),
            hoist: None,
            flow: None,
            first_flow_m3_per_s: operation.flow_now_m3_per_s(),
        }
    }

    /// Begins the lines that are due.
    pub fn reach(&mut self, time_s: f64, now: impl Fn() -> HoistNow) {
        while let Some(step) = self.steps.get(self.next)
            && step.at_s <= time_s
        {
            let step = step.clone();
            self.next += 1;
            if let Some(speed) = step.rotary_speed_rad_per_s {
                self.speed = Ramp::begin(self.speed.at(step.at_s), speed, &step);
            }
            if let Some(flow) = step.flow_rate_m3_per_s {
                let last = self.flow_rate_m3_per_s(step.at_s);
                let from = last.unwrap_or(self.first_flow_m3_per_s);
                self.flow = Some(Ramp::begin(from, flow, &step));
            }
            if let Some(set) = step.hoist {
                let last = self.hoist_at(step.at_s);
                let ramp = match (set, last) {
                    (
                        HoistSetPoint::BlockVelocity(to),
                        Some(HoistSetPoint::BlockVelocity(from)),
                    )
                    | (HoistSetPoint::WeightOnBit(to), Some(HoistSetPoint::WeightOnBit(from))) => {
                        Ramp::begin(from, to, &step)
                    }
                    (HoistSetPoint::BlockVelocity(to), _) => {
                        Ramp::begin(now().block_velocity_m_per_s, to, &step)
                    }
                    (HoistSetPoint::WeightOnBit(to), _) => {
                        Ramp::begin(now().weight_on_bit_N, to, &step)
                    }
                };
                self.hoist = Some((set, ramp));
            }
        }
    }

    /// Rotary speed at surface, rad/s.
    pub fn rotary_speed_rad_per_s(&self, time_s: f64) -> f64 {
        self.speed.at(time_s)
    }

    /// Flow rate of the pumps, m³/s; none while it is unchanged since before the run.
    pub fn flow_rate_m3_per_s(&self, time_s: f64) -> Option<f64> {
        self.flow.map(|ramp| ramp.at(time_s))
    }

    /// Set point of the hoist; none while it is unchanged since before the run.
    pub fn hoist_at(&self, time_s: f64) -> Option<HoistSetPoint> {
        self.hoist.map(|(kind, ramp)| match kind {
            HoistSetPoint::BlockVelocity(_) => HoistSetPoint::BlockVelocity(ramp.at(time_s)),
            HoistSetPoint::WeightOnBit(_) => HoistSetPoint::WeightOnBit(ramp.at(time_s)),
        })
    }

    /// All lines, those that were added too.
    pub fn lines(&self) -> &[ScheduleStep] {
        &self.steps
    }

    /// The line of the plan that began last, counted from one; zero before the first.
    pub fn line(&self) -> usize {
        self.next
    }
}
