//! Dynamic part of a plan, in the form of the results.

use serde::{Deserialize, Serialize};
use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_case::Case;
use wholestring_judge::{Quantity, Rounding};
use wholestring_plan::{
    Broomstick, Share,
    dynamic::{EventAnswer, EventTask, NoDynamics, Peak, WearTask},
    hydraulics::GelBreak,
};
use wholestring_results::{PlanCheck, PlanGel, PlanHistory, PlanOperation, PlanPeak, PlanPeakOf};
use wholestring_units::Dimension;

/// Largest relative drift of a hook load at the end; beyond it the simulated time was too short.
const DRIFT: f64 = 0.01;

/// A task of the dynamic part.
#[derive(Debug, Clone, Copy)]
pub(super) enum Run {
    /// An event.
    Event(EventTask),
    /// An operation that contributes to casing wear.
    Wear(WearTask),
}

/// Outcome of such a task.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) enum Ran {
    /// An event with its samples and limits.
    Event(Box<PlanPeak>, PlanHistory, #[serde(with = "super::checks")] Vec<PlanCheck>),
    /// Casing wear by an operation.
    Wear { operation: OperationKind, bit_depth_m: f64, found: Result<Share, String> },
}

/// All dynamic runs that a plan requires.
pub(super) fn runs(case: &Case, broomstick: &Broomstick) -> Vec<Run> {
    let plan = &case.plan.dynamic;
    let events = plan.tasks().into_iter().map(Run::Event);
    let wear = broomstick.campaign().map_or_else(Vec::new, |campaign| plan.wear_tasks(campaign));
    events.chain(wear.into_iter().map(Run::Wear)).collect()
}

impl Run {
    /// Measured depth of the bit, m.
    pub(super) fn bit_depth_m(&self) -> f64 {
        match self {
            Self::Event(task) => task.bit_depth_m,
            Self::Wear(task) => task.operation.bit_depth_m,
        }
    }

    /// Runs the task; `None` if `goes_on` returned false before its end.
    pub(super) fn solve(
        &self,
        case: &Case,
        broomstick: &Broomstick,
        goes_on: &dyn Fn() -> bool,
    ) -> Option<Ran> {
        let (plan, dynamics) = (&case.plan.dynamic, &case.dynamics);
        match self {
            Self::Event(task) => match broomstick.solve_event(task, plan, dynamics, goes_on) {
                Ok(answer) => answer.map(|answer| event(task, answer)),
                Err(error) => Some(unanswered(task, &error)),
            },
            Self::Wear(task) => {
                let found = match broomstick.solve_wear(task, plan, dynamics, goes_on) {
                    Ok(None) => return None,
                    Ok(Some(share)) => Ok(share),
                    Err(error) => Err(error.to_string()),
                };
                let operation = task.operation.kind;
                Some(Ran::Wear { operation, bit_depth_m: task.operation.bit_depth_m, found })
            }
        }
    }
}

fn row(task: &EventTask) -> PlanPeak {
    PlanPeak {
        event: task.event.name().to_owned(),
        friction: task.friction,
        bit_depth_m: task.bit_depth_m,
        hook_load_N: None,
        surface_torque_N_m: None,
        pump_pressure_Pa: None,
        gel: None,
        message: None,
    }
}

fn unanswered(task: &EventTask, error: &NoDynamics) -> Ran {
    let peak = PlanPeak { message: Some(error.to_string()), ..row(task) };
    Ran::Event(Box::new(peak), PlanHistory::default(), Vec::new())
}

fn event(task: &EventTask, answer: EventAnswer) -> Ran {
    let peak_of = |peak: Peak| PlanPeakOf {
        at_rest: peak.at_rest,
        peak: peak.peak,
        time_s: peak.time_s,
        steady: peak.steady,
        drift: peak.drift,
        ratio: peak.ratio(),
        overshoot: peak.overshoot(),
    };
    let gel = |GelBreak { bore_Pa, annulus_Pa, lift_N }| PlanGel { bore_Pa, annulus_Pa, lift_N };
    let hook = answer.hook_load_N;
    let drifts = hook.drift.abs() > DRIFT * hook.steady.abs();
    let message = drifts.then(|| {
        format!(
            "the hook load still drifts by {:.1} % at the end of the simulated time",
            100.0 * (hook.drift / hook.steady).abs()
        )
    });
    let peak = PlanPeak {
        hook_load_N: Some(peak_of(hook)),
        surface_torque_N_m: answer.surface_torque_N_m.map(peak_of),
        pump_pressure_Pa: answer.pump_pressure_Pa.map(peak_of),
        gel: answer.gel.map(gel),
        message,
        ..row(task)
    };
    let series = answer.history;
    let pressures =
        series.pump_pressure_Pa.iter().map(|pump_pressure_Pa| pump_pressure_Pa.unwrap_or(f64::NAN));
    let history = PlanHistory {
        pump_pressure_Pa: pressures.collect(),
        time_s: series.time_s,
        hook_load_N: series.hook_load_N,
        surface_torque_N_m: series.surface_torque_N_m,
        block_velocity_m_per_s: series.block_velocity_m_per_s,
        rotary_speed_rad_per_s: series.rotary_speed_rad_per_s,
        flow_rate_m3_per_s: series.flow_rate_m3_per_s,
    };
    let limits = answer.limits.into_iter().map(|check| PlanCheck {
        model: ModelKind::Dynamic,
        friction: task.friction,
        operation: PlanOperation::Event(task.event),
        bit_depth_m: task.bit_depth_m,
        check,
    });
    Ran::Event(Box::new(peak), history, limits.collect())
}

/// Outcome of the dynamic part.
#[derive(Debug, Default)]
pub(super) struct Parts {
    pub(super) peaks: Vec<PlanPeak>,
    pub(super) histories: Vec<PlanHistory>,
    pub(super) limits: Vec<PlanCheck>,
    /// Wear by operation.
    pub(super) wear: Vec<(OperationKind, Share)>,
    /// Reasons why wear is unknown or incomplete, with depths marked as quantities.
    pub(super) lacking: Vec<String>,
    /// Number of requested runs without an outcome yet.
    pub(super) pending: usize,
}

impl Parts {
    /// Creates the outcome of `pending` requested runs.
    pub(super) fn of(pending: usize) -> Self {
        Self { pending, ..Self::default() }
    }

    /// Adds the outcome of a run.
    pub(super) fn add(&mut self, ran: Ran) {
        self.pending = self.pending.saturating_sub(1);
        match ran {
            Ran::Event(peak, history, limits) => {
                self.peaks.push(*peak);
                self.histories.push(history);
                self.limits.extend(limits);
            }
            Ran::Wear { operation, found: Ok(share), .. } => self.wear.push((operation, share)),
            Ran::Wear { operation, bit_depth_m, found: Err(why) } => self.lacking.push(format!(
                "no casing wear from the dynamics: {operation} at {}, {why}",
                Quantity::new(Dimension::Length, bit_depth_m, Rounding::Five)
            )),
        }
    }

    /// The wear, if it is complete.
    pub(super) fn whole_wear(&self) -> &[(OperationKind, Share)] {
        if self.pending == 0 && self.lacking.is_empty() { &self.wear } else { &[] }
    }
}
