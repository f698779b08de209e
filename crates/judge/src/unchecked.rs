//! Limits that could not be checked, and the missing number.

use serde::{Deserialize, Serialize};
use wholestring::model::Model;

use crate::{Check, CheckKind, Severity};

/// A number that a check would have needed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Missing {
    /// Yield strength of the component.
    YieldStrength,
    /// Make-up torque of the component's connections.
    MakeUpTorque,
    /// Limit of the side force per joint.
    SideForceLimit,
    /// Capacity of the hoist.
    HoistCapacity,
    /// Weight of the block, which the load of the hoist leaves out.
    BlockWeight,
    /// Rated torque of the top drive.
    TopDriveTorque,
    /// Peak torque of the top drive.
    TopDrivePeakTorque,
    /// Pressure limit of the pump.
    PumpPressureLimit,
    /// Rheology of the mud, without which the pump pressure is not known.
    Rheology,
}

impl Missing {
    /// The missing number in words.
    pub const fn words(self) -> &'static str {
        match self {
            Self::YieldStrength => "no yield strength",
            Self::MakeUpTorque => "no make-up torque",
            Self::SideForceLimit => "no limit of the side force per joint",
            Self::HoistCapacity => "no hoist capacity",
            Self::BlockWeight => "no block weight: the hook load alone",
            Self::TopDriveTorque => "no rated torque of the top drive",
            Self::TopDrivePeakTorque => "no peak torque of the top drive",
            Self::PumpPressureLimit => "no pressure limit of the pump",
            Self::Rheology => "no rheology of the mud",
        }
    }
}

/// A limit that could not be checked.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Unchecked {
    /// The kind of limit.
    pub kind: CheckKind,
    /// The component; `None` for the rig.
    pub component: Option<String>,
    /// The missing number.
    pub missing: Missing,
}

impl Unchecked {
    /// Returns one phrase for each missing number: `Burst, Collapse of jar, motor (no yield
    /// strength)`. The components follow the limits, because those of other components were
    /// checked.
    pub fn phrases<'a>(unchecked: impl IntoIterator<Item = &'a Unchecked>) -> Vec<String> {
        let mut all: Vec<&Unchecked> = unchecked.into_iter().collect();
        all.sort_by(|a, b| a.missing.cmp(&b.missing).then(a.kind.cmp(&b.kind)));
        let mut sentences = Vec::new();
        for group in all.chunk_by(|a, b| a.missing == b.missing) {
            let mut labels: Vec<&str> = group.iter().map(|one| one.kind.label()).collect();
            labels.dedup();
            let mut components: Vec<&str> = Vec::new();
            for name in group.iter().filter_map(|one| one.component.as_deref()) {
                if !components.contains(&name) {
                    components.push(name);
                }
            }
            let place = match components.is_empty() {
                true => String::new(),
                false => format!(" of {}", components.join(", ")),
            };
            let labels = labels.join(", ");
            sentences.push(format!("{labels}{place} ({})", group[0].missing.words()));
        }
        sentences
    }
}

// Forces across the string that a model leaves out.

/// Reports the lateral forces that the soft string leaves out, because it has no stiffness that
/// could carry them.
pub fn lateral_force_left_out(model: &Model) -> Option<Check> {
    let components = model.string.components().iter();
    let forces = components.filter_map(|component| component.lateral_force);
    let sum_N: f64 = forces.map(|lateral| lateral.force_N.abs()).sum();
    let check = || Check::reported(CheckKind::LateralForceLeftOut, Severity::Note).value(sum_N);
    (sum_N > 0.0).then(check)
}
