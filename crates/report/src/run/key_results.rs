//! The five key numbers for an engineer, with their limits.

use serde::{Deserialize, Serialize};
use serde_json::Value as Json;
use wholestring::outcome::{Column, PROFILE, Quantity, Scalar};
use wholestring_results::{OperationSummary, Table};

use crate::{Cell, Fact};

const HOOK_LOAD: &Scalar = Scalar::declared("hook_load_N");
const SURFACE_TORQUE: &Scalar = Scalar::declared("surface_torque_N_m");
const AXIAL_FRICTION: &Scalar = Scalar::declared("axial_friction_N");
const STRESS: &Quantity = Column::declared(PROFILE, "von_mises_stress_max_Pa");
const NEUTRAL_POINT: &Scalar = Scalar::declared("neutral_point_m");

/// A number with its limit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct KeyResult {
    /// Its label.
    pub label: String,
    /// The number; for a dynamic run a mean, where `largest` is given.
    pub value: Cell,
    /// The largest of the window, where the value is a mean.
    pub largest: Option<f64>,
    /// Value that is compared with the limit, where that is neither the largest nor the value
    /// itself.
    #[serde(default)]
    pub compared: Option<f64>,
    /// The limit.
    pub limit: Option<f64>,
    /// Source of the limit, or that none is given.
    pub limit_label: String,
    /// Additional facts, such as the same number for another part of the rig.
    #[serde(default)]
    pub more: Vec<Fact>,
    /// Kinds of the checks that concern this number.
    #[serde(default)]
    pub check_kinds: Vec<String>,
}

impl KeyResult {
    /// A number without a limit, about which checks of these kinds are.
    fn unlimited(label: &str, value: Cell, note: &str, check_kinds: &[&str]) -> Self {
        Self {
            label: label.into(),
            value,
            largest: None,
            compared: None,
            limit: None,
            limit_label: note.into(),
            more: Vec::new(),
            check_kinds: check_kinds.iter().map(|kind| (*kind).to_owned()).collect(),
        }
    }

    /// The same with this limit, or with the note that it is not given.
    fn limited(self, limit: Option<f64>) -> Self {
        let limit_label = match limit {
            Some(_) => self.limit_label,
            None => format!("{} not given", self.limit_label),
        };
        Self { limit, limit_label, ..self }
    }
}

/// Five key numbers. In a dynamic model, varying ones are means, and their largest value in the
/// window is compared with the limit.
pub(super) fn key_results(
    solved: &OperationSummary,
    settings: &Json,
    nodes: &Table,
) -> Vec<KeyResult> {
    let rig = |key: &str| settings["rig"][key].as_f64();
    let largest = |scalar: &Scalar| {
        let statistics = solved.statistics.as_ref()?;
        Some(statistics.get(scalar.quantity.name)?.max)
    };
    let scalars = &solved.scalars;
    let load_N = scalars.hook_load_N;
    let block_N = rig("block_weight_N").filter(|weight| *weight > 0.0);
    let whose = match block_N {
        Some(_) => "hoist's capacity, for the load with block",
        None => "hoist's capacity",
    };
    let load = Cell::quantity(load_N, "force");
    let of_load = ["goes_down", "hoist", "lock_up"];
    let hook = KeyResult {
        largest: largest(HOOK_LOAD),
        // The hoist also lifts the block.
        compared: block_N.map(|block_N| largest(HOOK_LOAD).unwrap_or(load_N) + block_N),
        more: Vec::from_iter(
            block_N
                .map(|block_N| Fact::new("with block", Cell::quantity(load_N + block_N, "force"))),
        ),
        ..KeyResult::unlimited(HOOK_LOAD.label, load, whose, &of_load)
    };
    let torque_N_m = Cell::quantity(scalars.surface_torque_N_m, "torque");
    let rated = "top drive's rated torque";
    let torque = KeyResult {
        largest: largest(SURFACE_TORQUE),
        ..KeyResult::unlimited(SURFACE_TORQUE.label, torque_N_m, rated, &["top_drive"])
    };
    let drag = || {
        let drag_N = Cell::quantity(scalars.axial_friction_N, "force");
        let note = "positive adds to hook load";
        KeyResult::unlimited(AXIAL_FRICTION.label, drag_N, note, &["lock_up"])
    };
    let [third, fourth] = if solved.model.in_time() {
        [stress(nodes), stick_slip(solved).unwrap_or_else(drag)]
    } else {
        let neutral_point = match scalars.neutral_point_m {
            Some(md_m) => Cell::quantity(md_m, "length"),
            None => Cell::Text("none: all in tension".into()),
        };
        let label = NEUTRAL_POINT.label;
        [drag(), KeyResult::unlimited(label, neutral_point, "measured depth", &[])]
    };
    vec![
        hook.limited(rig("hoist_capacity_N")),
        torque.limited(rig("top_drive_torque_N_m")),
        third,
        fourth,
        side_force(nodes),
    ]
}

/// Severity of stick-slip, if the string rotates: at one the bit just stops.
fn stick_slip(solved: &OperationSummary) -> Option<KeyResult> {
    let severity = Cell::quantity(solved.indicators?.stick_slip?.severity?, "ratio");
    let kinds = ["stick_slip", "top_drive_stalled"];
    let note = "at 1 the bit just stops";
    Some(KeyResult::unlimited("Stick-slip severity", severity, note, &kinds).limited(Some(1.0)))
}

/// Utilisation of the yield strength if it is known, otherwise the stress itself.
fn stress(nodes: &Table) -> KeyResult {
    let largest = |name: &str| largest_of(nodes, name, |value| value);
    match largest("yield_use") {
        Some(part) => {
            let (part, note) =
                (Cell::quantity(part, "percent"), "minimum yield strength, pipe body");
            KeyResult::unlimited("Use of yield strength", part, note, &["von_mises"])
                .limited(Some(1.0))
        }
        None => {
            let stress_Pa = largest(STRESS.name).or_else(|| largest("von_mises_stress_Pa"));
            let stress = Cell::quantity(stress_Pa.unwrap_or(f64::NAN), "stress");
            KeyResult::unlimited(&STRESS.label(), stress, "yield strength", &["von_mises"])
                .limited(None)
        }
    }
}

/// The largest mean side force: of a joint if the string has joints and the model includes them,
/// otherwise per length.
fn side_force(nodes: &Table) -> KeyResult {
    let (force, note) = match largest_of(nodes, "side_force_per_joint_N", f64::abs) {
        Some(force_N) => {
            (Cell::quantity(force_N, "force"), "of a tool joint, mean; no limit in the case")
        }
        None => {
            let force = largest_of(nodes, "side_force_N_per_m", f64::abs).unwrap_or(f64::NAN);
            (Cell::quantity(force, "force per length"), "no limit in the case")
        }
    };
    KeyResult::unlimited("Largest side force", force, note, &[])
}

/// The largest value of a column of the profile.
fn largest_of(nodes: &Table, name: &str, convert: fn(f64) -> f64) -> Option<f64> {
    let numbers = nodes.numbers(name).unwrap_or_default();
    numbers.iter().copied().flatten().map(convert).max_by(f64::total_cmp)
}
