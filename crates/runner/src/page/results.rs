//! The five key numbers for an engineer, with their limits.

use serde_json::Value as Json;
use wholestring::outcome::{Column, PROFILE, Quantity, Scalar};
use wholestring_report::{Cell, Fact, KeyResult};
use wholestring_results::{OperationSummary, Table};

use super::rows::rows;
use crate::column::numbers;

const HOOK_LOAD: &Scalar = Scalar::declared("hook_load_N");
const SURFACE_TORQUE: &Scalar = Scalar::declared("surface_torque_N_m");
const AXIAL_FRICTION: &Scalar = Scalar::declared("axial_friction_N");
const STRESS: &Quantity = Column::declared(PROFILE, "von_mises_stress_max_Pa");
const NEUTRAL_POINT: &Scalar = Scalar::declared("neutral_point_m");

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
    let block_N = rig("block_weight_N").filter(|weight| *weight > 0.0);
    let with_block = |load_N: f64| Cell::quantity(load_N + block_N.unwrap_or(0.0), "force");
    let more = block_N
        .map(|_| Fact { label: "with block".into(), value: with_block(scalars.hook_load_N) });
    let whose = match block_N {
        Some(_) => "hoist's capacity, for the load with block",
        None => "hoist's capacity",
    };
    let hook = KeyResult {
        label: HOOK_LOAD.label.into(),
        value: Cell::quantity(scalars.hook_load_N, "force"),
        largest: largest(HOOK_LOAD),
        // The hoist also lifts the block.
        compared: block_N
            .map(|block_N| largest(HOOK_LOAD).unwrap_or(scalars.hook_load_N) + block_N),
        more: more.into_iter().collect(),
        check_kinds: words(&["goes_down", "hoist", "lock_up"]),
        ..limited(rig("hoist_capacity_N"), whose)
    };
    let torque = KeyResult {
        label: SURFACE_TORQUE.label.into(),
        value: Cell::quantity(scalars.surface_torque_N_m, "torque"),
        largest: largest(SURFACE_TORQUE),
        check_kinds: words(&["top_drive"]),
        ..limited(rig("top_drive_torque_N_m"), "top drive's rated torque")
    };
    let side = side_force(solved, nodes);
    if solved.model.in_time() {
        let sticking = stick_slip(solved).unwrap_or_else(|| drag(solved));
        return vec![hook, torque, stress(solved, nodes), sticking, side];
    }
    let neutral_point = KeyResult {
        label: NEUTRAL_POINT.label.into(),
        value: scalars.neutral_point_m.map_or_else(
            || Cell::Text("none: all in tension".into()),
            |md| Cell::quantity(md, "length"),
        ),
        ..unlimited("measured depth")
    };
    vec![hook, torque, drag(solved), neutral_point, side]
}

fn words(list: &[&str]) -> Vec<String> {
    list.iter().map(|word| (*word).to_owned()).collect()
}

/// A number with this limit; the caller sets label and value.
fn limited(limit: Option<f64>, whose: &str) -> KeyResult {
    KeyResult {
        label: String::new(),
        value: Cell::Nothing,
        largest: None,
        compared: None,
        limit,
        limit_label: match limit {
            Some(_) => whose.into(),
            None => format!("{whose} not given"),
        },
        more: Vec::new(),
        check_kinds: Vec::new(),
    }
}

fn unlimited(note: &str) -> KeyResult {
    KeyResult { limit_label: note.into(), ..limited(None, "") }
}

fn drag(solved: &OperationSummary) -> KeyResult {
    KeyResult {
        label: AXIAL_FRICTION.label.into(),
        check_kinds: words(&["lock_up"]),
        value: Cell::quantity(solved.scalars.axial_friction_N, "force"),
        ..unlimited("positive adds to hook load")
    }
}

/// Severity of stick-slip, if the string rotates: at one the bit just stops.
fn stick_slip(solved: &OperationSummary) -> Option<KeyResult> {
    let severity = solved.indicators?.stick_slip?.severity?;
    Some(KeyResult {
        label: "Stick-slip severity".into(),
        check_kinds: words(&["stick_slip", "top_drive_stalled"]),
        value: Cell::quantity(severity, "ratio"),
        ..limited(Some(1.0), "at 1 the bit just stops")
    })
}

/// Utilisation of the yield strength if it is known, otherwise the stress itself.
fn stress(solved: &OperationSummary, nodes: &Table) -> KeyResult {
    let largest = |name: &str| largest_of(solved, nodes, name, |value| value);
    match largest("yield_use") {
        Some(part) => KeyResult {
            label: "Use of yield strength".into(),
            check_kinds: words(&["von_mises"]),
            value: Cell::quantity(part, "percent"),
            ..limited(Some(1.0), "minimum yield strength, pipe body")
        },
        None => KeyResult {
            label: STRESS.label(),
            check_kinds: words(&["von_mises"]),
            value: largest(STRESS.name)
                .or_else(|| largest("von_mises_stress_Pa"))
                .map_or(Cell::Nothing, |stress| Cell::quantity(stress, "stress")),
            ..limited(None, "yield strength")
        },
    }
}

/// The largest mean side force: of a joint if the string has joints and the model includes them,
/// otherwise per length.
fn side_force(solved: &OperationSummary, nodes: &Table) -> KeyResult {
    match largest_of(solved, nodes, "side_force_per_joint_N", f64::abs) {
        Some(force) => KeyResult {
            label: "Largest side force".into(),
            value: Cell::quantity(force, "force"),
            ..unlimited("of a tool joint, mean; no limit in the case")
        },
        None => KeyResult {
            label: "Largest side force".into(),
            value: largest_of(solved, nodes, "side_force_N_per_m", f64::abs)
                .map_or(Cell::Nothing, |force| Cell::quantity(force, "force per length")),
            ..unlimited("no limit in the case")
        },
    }
}

/// The largest value of a column of the profile.
fn largest_of(
    solved: &OperationSummary,
    nodes: &Table,
    name: &str,
    convert: fn(f64) -> f64,
) -> Option<f64> {
    let values = numbers(nodes, name);
    rows(nodes, Some(solved.model), solved.operation)
        .into_iter()
        .filter_map(|row| values.get(row).copied().flatten().map(convert))
        .max_by(f64::total_cmp)
}
