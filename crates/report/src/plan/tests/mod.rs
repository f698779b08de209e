//! The page and the pictures of a made-up plan.

mod comparisons;
mod events;
mod lines;
mod page;

use serde_json::json;
use wholestring::{
    operation::OperationKind,
    outcome::{Buckling, ModelKind, Scalars},
    well::FrictionLevel,
};
use wholestring_judge::{Check, CheckKind, Quantity, Rounding, Severity, Verdict, Wording};
use wholestring_results::{
    PLAN_VERSION, PlanBuckling, PlanCheck, PlanDensity, PlanFatigue, PlanFatigueHour, PlanFriction,
    PlanHydraulics, PlanOperation, PlanPoint, PlanStation, PlanSummary, PlanSurfaceLimit, PlanWear,
    Texts,
};
use wholestring_units::{Dimension, UnitSet};

use super::{Plan, plan_html, plan_plots};
use crate::figure::{Mark, Panel};

/// Depths of the bit, m.
const DEPTHS_M: [f64; 3] = [500.0, 1000.0, 2000.0];

/// A plan of four operations, whose string locks up at the deepest depth with high friction as it
/// is run in.
fn summary() -> PlanSummary {
    use OperationKind::{Drill, RotateOffBottom, Slide, TripIn, TripOut};
    let operations = [TripOut, TripIn, RotateOffBottom, Drill];
    let curves = operations.iter().flat_map(|kind| FrictionLevel::ALL.map(|level| (*kind, level)));
    let points =
        curves.flat_map(|(kind, level)| DEPTHS_M.map(|depth_m| point(kind, level, depth_m)));
    let weights =
        FrictionLevel::ALL.into_iter().flat_map(|level| [Drill, Slide].map(|kind| (kind, level)));
    let buckling = weights.flat_map(|(operation, friction)| {
        DEPTHS_M.map(|bit_depth_m| PlanBuckling {
            model: ModelKind::Soft,
            friction,
            operation,
            bit_depth_m,
            sinusoidal_weight_N: Some(4e4),
            helical_weight_N: Some(6e4),
            message: None,
        })
    });
    PlanSummary {
        schema_version: PLAN_VERSION,
        case: "<Well> & \"plan\"".into(),
        settings: json!({
            "units": "si",
            "well": {"hole": [{"diameter_m": 0.22}, {"diameter_m": 0.2}]},
            "mud": {"density_kg_per_m3": 1200.0},
            "rig": {"block_weight_N": 2e5, "pump_pressure_limit_Pa": 35e6},
            "operation": {"wob_N": 3e4},
        }),
        frictions: FrictionLevel::ALL.into_iter().flat_map(frictions).collect(),
        models: vec![ModelKind::Soft],
        operations: operations.into(),
        bit_depths_m: DEPTHS_M.into(),
        missing: 0,
        points: points.collect(),
        buckling: buckling.collect(),
        checks: vec![
            PlanCheck {
                operation: PlanOperation::Kind(Slide),
                check: Check { severity: Severity::Error, ..lock_up() },
                ..limit(CheckKind::LockUp, 1.0, Verdict::Exceeded)
            },
            limit(CheckKind::Tension, 1.05, Verdict::BelowRequired),
            limit(CheckKind::HelicalBuckling, 0.5, Verdict::Exceeded),
            limit(CheckKind::Hoist, 1.2, Verdict::Marginal),
        ],
        governing: vec![PlanCheck {
            operation: PlanOperation::Kind(Drill),
            ..limit(CheckKind::Tension, 1.3, Verdict::Ok)
        }],
        surface_limits: vec![
            surface_limit("hoist", false, 6e5),
            surface_limit("tension", false, 5.8e5),
            surface_limit("top_drive", true, 1.2e4),
            surface_limit("top_drive_peak", true, 1e6),
            surface_limit("make_up", true, 1.25e4),
        ],
        unchecked: vec!["no make-up torque of pipe".into()],
        counted: vec!["drill from 900 m to 2000 m in 55.0 h".into()],
        not_counted: vec!["trip in: no <speed>".into()],
        hydraulics: DEPTHS_M.map(hydraulics).into(),
        fatigue: vec![fatigue("drill <pipe>", 1.2), fatigue("collar", 1e-7)],
        wear: vec![wear()],
        uncertain: None,
        measured: Vec::new(),
        overlay: None,
        peaks: Vec::new(),
        texts: Texts::default(),
    }
}

/// The page of that plan.
fn plan() -> Plan {
    plan_with(|_| {})
}

/// The page of that plan after a change of its summary.
fn plan_with(change: impl FnOnce(&mut PlanSummary)) -> Plan {
    let mut summary = summary();
    change(&mut summary);
    Plan::new(summary, vec![station()], &[], Some(UnitSet::Si))
}

/// Casing to 900 m and open hole below, of one friction.
fn frictions(friction: FrictionLevel) -> [PlanFriction; 2] {
    let coefficient = [0.1, 0.2, 0.3][friction as usize];
    [("casing", 0.0, 900.0), ("open", 900.0, 2000.0)].map(|(kind, from_md_m, to_md_m)| {
        let (along, around) = (coefficient, coefficient);
        PlanFriction { friction, kind: kind.into(), from_md_m, to_md_m, along, around }
    })
}

fn point(operation: OperationKind, friction: FrictionLevel, bit_depth_m: f64) -> PlanPoint {
    let level = f64::from(friction as u8);
    let drag = match operation {
        OperationKind::TripOut => 0.2 * level,
        OperationKind::TripIn => -0.2 * level,
        _ => 0.0,
    };
    let torque = if operation == OperationKind::Drill { 5.0 * bit_depth_m } else { 0.0 };
    let runs_in = operation == OperationKind::TripIn;
    let locks_up = runs_in && friction == FrictionLevel::High && bit_depth_m > 1500.0;
    PlanPoint {
        model: ModelKind::Soft,
        friction,
        operation,
        bit_depth_m,
        scalars: (!locks_up).then(|| scalars(200.0 * bit_depth_m * (1.0 + drag), torque)),
        buckling: (!locks_up).then(|| "none".into()),
        worst: runs_in.then(|| limit(CheckKind::HelicalBuckling, 0.5, Verdict::Exceeded).check),
        message: locks_up.then(|| "the string <locks> up".into()),
    }
}

fn scalars(hook_load_N: f64, surface_torque_N_m: f64) -> Scalars {
    Scalars {
        weight_on_bit_N: 0.0,
        bit_torque_N_m: 0.0,
        hook_load_N,
        surface_torque_N_m,
        friction_torque_N_m: 0.0,
        axial_friction_N: 0.0,
        side_force_total_N: 0.0,
        stretch_m: 0.0,
        twist_rad: 0.0,
        neutral_point_m: None,
        cutoff_depth_m: None,
    }
}

/// The string half-way down while drilling.
fn station() -> PlanStation {
    PlanStation {
        operation: OperationKind::Drill,
        md_m: 990.0,
        tvd_m: 900.0,
        inclination_rad: 0.5,
        dogleg_severity_rad_per_m: 1e-3,
        component: "drill <pipe>".into(),
        tension_N: -2e4,
        torque_N_m: 5e3,
        side_force_N_per_m: -150.0,
        von_mises_stress_Pa: 2e8,
        yield_use: Some(0.27),
        buckling: Buckling::Sinusoidal,
    }
}

/// A limit of a force, of the drill pipe while tripping out, with this factor.
fn limit(kind: CheckKind, factor: f64, verdict: Verdict) -> PlanCheck {
    let severity = match verdict {
        Verdict::BelowRequired | Verdict::Exceeded => Severity::Warning,
        _ => Severity::Note,
    };
    let check = Check {
        kind,
        severity,
        verdict,
        component: Some("drill <pipe>".into()),
        md_m: (kind == CheckKind::Tension).then_some(0.0),
        to_md_m: None,
        value: Some(1e6),
        limit: Some(1e6 * factor),
        factor: Some(factor),
        required: Some(1.0 / 0.9),
        unit: "N".into(),
        sentence: kind.label().to_owned(),
        wording: Wording::default(),
        stress: None,
    };
    PlanCheck {
        model: ModelKind::Soft,
        friction: FrictionLevel::High,
        operation: PlanOperation::Kind(OperationKind::TripOut),
        bit_depth_m: 2000.0,
        check,
    }
}

/// Lock-up with a torque in its sentence, and without a factor.
fn lock_up() -> Check {
    let torque = Quantity::new(Dimension::Torque, 3e3, Rounding::Four);
    let wording = Wording::from(format!("Lock-up <at> {torque}"));
    Check {
        value: None,
        limit: None,
        factor: None,
        required: None,
        sentence: wording.in_units(UnitSet::Si),
        wording,
        ..limit(CheckKind::LockUp, 1.0, Verdict::Exceeded).check
    }
}

fn surface_limit(kind: &str, is_torque: bool, allowed: f64) -> PlanSurfaceLimit {
    let kind = kind.to_owned();
    PlanSurfaceLimit { kind, component: None, is_torque, capacity: allowed, required: 1.0, allowed }
}

fn hydraulics(bit_depth_m: f64) -> PlanHydraulics {
    let density = |shoe_kg_per_m3: f64, bit_kg_per_m3: f64| PlanDensity {
        shoe_kg_per_m3: Some(shoe_kg_per_m3),
        bit_kg_per_m3,
    };
    PlanHydraulics {
        operation: OperationKind::Drill,
        bit_depth_m,
        standpipe_pressure_Pa: 1e4 * bit_depth_m,
        bore_loss_Pa: 0.0,
        bit_loss_Pa: 0.0,
        annulus_loss_Pa: 0.0,
        circulating: density(1230.0, 1240.0),
        surge_closed: density(1250.0, 1260.0),
        surge_open: density(1220.0, 1230.0),
        swab_closed: density(1150.0, 1140.0),
        swab_open: density(1180.0, 1170.0),
    }
}

fn fatigue(component: &str, damage: f64) -> PlanFatigue {
    let hour = PlanFatigueHour {
        md_m: 700.4,
        damage_per_hour: 0.01,
        bending_Pa: 1.2e8,
        dogleg_rad_per_m: 0.0017,
        permissible_dogleg_rad_per_m: None,
    };
    let hour = (damage > 1.0).then_some(hour);
    PlanFatigue {
        model: ModelKind::Soft,
        component: component.into(),
        damage,
        from_lower_end_m: 0.0,
        hour,
    }
}

fn wear() -> PlanWear {
    PlanWear {
        model: ModelKind::Soft,
        section: 1,
        md_m: 802.5,
        groove_m: Some(0.0062),
        wall_m: Some(0.012),
        wall_left_m: Some(0.0058),
        worn: Some(0.517),
        burst_Pa: Some([5e7, 2.4e7]),
        collapse_Pa: None,
    }
}

/// Lines down the page and their names.
fn rules(panel: &Panel) -> Vec<(f64, String)> {
    let rule = |mark: &Mark| match mark {
        Mark::OwnRule { at, label } => Some((*at, label.clone())),
        _ => None,
    };
    panel.marks.iter().filter_map(rule).collect()
}

/// Names at the ends of lines.
fn names(panel: &Panel) -> Vec<((f64, f64), &str)> {
    let name = |mark: &'_ Mark| match mark {
        Mark::Foot { at, text } => Some((*at, text.clone())),
        _ => None,
    };
    let all = panel.marks.iter().filter_map(name);
    all.map(|(at, text)| (at, Box::leak(text.into_boxed_str()) as &str)).collect()
}
