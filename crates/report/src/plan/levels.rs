//! Levels of friction of a plan, in words, and time histories of a string that is set in motion.

use wholestring::well::FrictionLevel;
use wholestring_results::{PlanFriction, PlanPeak, PlanPeakSample, PlanSummary};
use wholestring_units::without_trailing_zeros;

use crate::figure::Stroke;

/// Strokes of low, expected and high friction.
pub const STROKES: [Stroke; 3] = [Stroke::Dotted, Stroke::Solid, Stroke::Dashed];

/// A level of friction with its coefficients.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Level {
    /// The level.
    pub(super) friction: FrictionLevel,
    /// Label at the ends of its lines: `0.25`, or `0.2 / 0.3` for casing and rock.
    pub(super) label: String,
    /// Each kind of hole with its coefficients of axial and rotational friction, as shown to users.
    pub(super) sections: Vec<String>,
}

impl Level {
    /// The level of this friction in a plan.
    pub(super) fn new(summary: &PlanSummary, friction: FrictionLevel) -> Self {
        let section = |section: &PlanFriction| {
            let kind = if section.kind == "casing" { "casing" } else { "open hole" };
            let rotational = match section.around == section.along {
                true => String::new(),
                false => format!(", rotational {}", short(section.around)),
            };
            format!("{kind} {}{rotational}", short(section.along))
        };
        let mut sections: Vec<String> = sections(summary, friction).map(section).collect();
        sections.dedup();
        Self { friction, label: plan_friction_label(summary, friction), sections }
    }

    /// Its name: `low`, `expected` or `high`.
    pub(super) fn name(&self) -> &'static str {
        self.friction.name()
    }

    /// Its stroke on the pictures.
    pub(super) fn stroke(&self) -> Stroke {
        STROKES[self.friction as usize]
    }
}

/// Friction factors of a level: `0.3`, or `0.2 / 0.3` if sections differ.
pub fn plan_friction_label(summary: &PlanSummary, friction: FrictionLevel) -> String {
    let mut values: Vec<String> =
        sections(summary, friction).map(|section| short(section.along)).collect();
    values.dedup();
    values.join(" / ")
}

/// Sections of the hole with the friction of a level, from the surface down.
fn sections(summary: &PlanSummary, level: FrictionLevel) -> impl Iterator<Item = &PlanFriction> {
    summary.frictions.iter().filter(move |section| section.friction == level)
}

/// A coefficient in three decimals, without trailing zeros.
fn short(value: f64) -> String {
    without_trailing_zeros(&format!("{value:.3}")).to_owned()
}

// Time histories of a string that is set in motion.

/// Samples of an event.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct History {
    /// Time from its beginning, s.
    pub(super) time_s: Vec<f64>,
    /// Hook load without block, N.
    pub(super) hook_load_N: Vec<f64>,
    /// Surface torque, N·m.
    pub(super) surface_torque_N_m: Vec<f64>,
    /// Pressure of the pump, Pa; not a number without a rheology.
    pub(super) pump_pressure_Pa: Vec<f64>,
}

/// The history of each peak in the samples of all events.
pub(super) fn histories(peaks: &[PlanPeak], samples: &[PlanPeakSample]) -> Vec<History> {
    peaks.iter().map(|peak| history(peak, samples)).collect()
}

fn history(peak: &PlanPeak, samples: &[PlanPeakSample]) -> History {
    let is_its = |sample: &&PlanPeakSample| {
        sample.event == peak.event
            && sample.friction == peak.friction
            && sample.bit_depth_m == peak.bit_depth_m
    };
    let own: Vec<&PlanPeakSample> = samples.iter().filter(is_its).collect();
    let column =
        |value: fn(&PlanPeakSample) -> f64| own.iter().map(|sample| value(sample)).collect();
    History {
        time_s: column(|sample| sample.time_s),
        hook_load_N: column(|sample| sample.hook_load_N),
        surface_torque_N_m: column(|sample| sample.surface_torque_N_m),
        pump_pressure_Pa: column(|sample| sample.pump_pressure_Pa),
    }
}
