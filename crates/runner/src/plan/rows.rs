//! Results in the form of the tables: loads, hydraulics and limits at the surface, and the parts of
//! the case that a plan leaves out.

use std::collections::BTreeSet;

use wholestring::{
    operation::{Operation, OperationKind},
    outcome::{ModelKind, QuantityKind},
    well::HoleKind,
};
use wholestring_case::Case;
use wholestring_judge::{Check, Judge, LimitSettings, Unchecked, surface_limits};
use wholestring_plan::{
    Broomstick, BroomstickPoint, BucklingWeight, FrictionLevel, StringStation,
    hydraulics::{EquivalentDensity, HydraulicsError, HydraulicsRow, hydraulics},
};
use wholestring_results::{
    PlanBuckling, PlanCheck, PlanDensity, PlanFriction, PlanHydraulics, PlanOperation, PlanPoint,
    PlanStation, PlanSurfaceLimit,
};
use wholestring_units::{UnitSet, significant};

pub(super) fn points(found: &[BroomstickPoint]) -> Vec<PlanPoint> {
    let point = |point: &BroomstickPoint| {
        let answer = point.outcome.as_ref().ok();
        PlanPoint {
            model: point.model.kind(),
            friction: point.friction,
            operation: point.operation,
            bit_depth_m: point.bit_depth_m,
            scalars: answer.map(|answer| answer.scalars),
            buckling: answer.map(|answer| answer.buckling.name().to_owned()),
            worst: point.checks.most_severe().cloned(),
            message: match answer {
                Some(_) => None,
                None => point.checks.most_severe().map(|check| check.sentence.clone()),
            },
        }
    };
    found.iter().map(point).collect()
}

/// Checks at these points.
pub(super) fn checks(found: &[BroomstickPoint]) -> Vec<PlanCheck> {
    let rows = |point: &BroomstickPoint| {
        let row = |check: &Check| PlanCheck {
            model: point.model.kind(),
            friction: point.friction,
            operation: PlanOperation::Kind(point.operation),
            bit_depth_m: point.bit_depth_m,
            check: check.clone(),
        };
        point.checks.checks.iter().map(row).collect::<Vec<_>>()
    };
    found.iter().flat_map(rows).collect()
}

/// Checks that were not possible at these points.
pub(super) fn unchecked(found: &[BroomstickPoint]) -> BTreeSet<Unchecked> {
    found.iter().flat_map(|point| point.checks.unchecked.iter().cloned()).collect()
}

pub(super) fn buckling(found: &[BucklingWeight], judge: &Judge) -> Vec<PlanBuckling> {
    let row = |weight: &BucklingWeight| {
        let [sinusoidal, helical] = weight.weights_N.as_ref().map_or([None; 2], |weights| *weights);
        PlanBuckling {
            model: ModelKind::Soft,
            friction: weight.friction,
            operation: weight.operation,
            bit_depth_m: weight.bit_depth_m,
            sinusoidal_weight_N: sinusoidal,
            helical_weight_N: helical,
            message: weight.weights_N.as_ref().err().map(|why| judge.reason(why)),
        }
    };
    found.iter().map(row).collect()
}

/// Friction of each section at each level.
pub(super) fn frictions(broomstick: &Broomstick) -> Vec<PlanFriction> {
    let sections = |level: FrictionLevel| {
        let sections = broomstick.setup(level).well.hole.sections().iter();
        sections.map(move |section| PlanFriction {
            friction: level,
            kind: match section.kind {
                HoleKind::Casing => "casing".to_owned(),
                HoleKind::Open => "open".to_owned(),
            },
            from_md_m: section.from_md_m,
            to_md_m: section.to_md_m,
            // Removes digits left by rounding.
            along: significant(section.friction.kinetic, DIGITS),
            around: significant(section.friction.kinetic * section.friction.around, DIGITS),
        })
    };
    FrictionLevel::ALL.into_iter().flat_map(sections).collect()
}

/// Digits of a coefficient of friction.
const DIGITS: usize = 12;

// Hydraulics in a plan.

/// A row for each depth of the plan.
///
/// # Errors
/// The reason why there is none: no circulation, no flow rate, or a mud without a rheology.
pub(super) fn rows(case: &Case) -> Result<Vec<PlanHydraulics>, String> {
    let plan = &case.plan;
    let drills = plan.operations.iter().find(|operation| operation.kind == OperationKind::Drill);
    let circulates = || plan.operations.iter().find(|operation| operation.kind.circulates());
    let operation = drills.or_else(circulates).ok_or("no operation circulates, for hydraulics")?;
    if operation.flow_now_m3_per_s() == 0.0 {
        return Err("no flow_rate, for hydraulics".to_owned());
    }
    let found = hydraulics(&case.setup(), operation, &plan.bit_depths_m);
    let found = found.map_err(|error| match error {
        HydraulicsError::NoRheology => "no rheology of the mud, for hydraulics".to_owned(),
        HydraulicsError::Assembly(error) => error.to_string(),
    })?;
    Ok(found.iter().map(|hydraulics_row| row(operation, hydraulics_row)).collect())
}

fn row(operation: &Operation, row: &HydraulicsRow) -> PlanHydraulics {
    let density = |density: EquivalentDensity| PlanDensity {
        shoe_kg_per_m3: density.shoe_kg_per_m3,
        bit_kg_per_m3: density.bit_kg_per_m3,
    };
    let [[surge_closed, surge_open], [swab_closed, swab_open]] =
        [row.surge, row.swab].map(|ends| ends.map(density));
    PlanHydraulics {
        operation: operation.kind,
        bit_depth_m: row.bit_depth_m,
        standpipe_pressure_Pa: row.standpipe_Pa,
        bore_loss_Pa: row.bore_loss_Pa,
        bit_loss_Pa: row.bit_loss_Pa,
        annulus_loss_Pa: row.annulus_loss_Pa,
        circulating: density(row.circulating),
        surge_closed,
        surge_open,
        swab_closed,
        swab_open,
    }
}

// Limits of hook load and torque at the surface.

/// Limits of the rig and of the topmost component; empty if the string fits no depth.
pub(super) fn limits(broomstick: &Broomstick, settings: &LimitSettings) -> Vec<PlanSurfaceLimit> {
    let setup = broomstick.setup(FrictionLevel::Expected);
    let deepest_m = broomstick.depths_m().last().copied().unwrap_or_default();
    // The reason is given with each of its points.
    let Ok(model) = setup.at(deepest_m) else { return Vec::new() };
    let limits =
        surface_limits(&model, settings).into_iter().map(|surface_limit| PlanSurfaceLimit {
            kind: surface_limit.kind.name().to_owned(),
            component: surface_limit.component,
            is_torque: surface_limit.kind.quantity() == QuantityKind::Torque,
            capacity: surface_limit.capacity,
            required: surface_limit.required,
            allowed: surface_limit.allowed,
        });
    limits.collect()
}

// The string along the hole.

/// Spacing of the standard table, m: the length that dogleg severities refer to.
const fn spacing_m(units: UnitSet) -> f64 {
    match units {
        UnitSet::Field => 100.0 * 0.3048,
        UnitSet::Si | UnitSet::Metric => 30.0,
    }
}

/// The stations of every operation with the bit at the deepest depth; none of an operation without
/// an answer, whose reason is at its point.
pub(super) fn along(case: &Case, broomstick: &Broomstick) -> Vec<PlanStation> {
    let bit_depth_m = broomstick.depths_m().last().copied().unwrap_or_default();
    let station = |station: StringStation| PlanStation {
        operation: station.operation,
        md_m: station.md_m,
        tvd_m: station.tvd_m,
        inclination_rad: station.inclination_rad,
        dogleg_severity_rad_per_m: station.dogleg_severity_rad_per_m,
        component: station.component,
        tension_N: station.tension_N,
        torque_N_m: station.torque_N_m,
        side_force_N_per_m: station.side_force_N_per_m,
        von_mises_stress_Pa: station.von_mises_stress_Pa,
        yield_use: station.yield_use,
        buckling: station.buckling,
    };
    let operations = case.plan.operations.iter();
    let found = operations.filter_map(|operation| {
        let operation = Operation { bit_depth_m, ..*operation };
        broomstick.along(&operation, spacing_m(case.units)).ok()
    });
    found.flatten().map(station).collect()
}

// Parts of the case that a plan leaves out or takes otherwise, in phrases.

/// Models and operations of the case that the plan does not compute, and an assumed rotary speed.
pub(super) fn left_out(case: &Case) -> Vec<String> {
    let plan = &case.plan;
    let computed = |model: &ModelKind| plan.models.iter().any(|own| own.name() == model.name());
    let models = case.models.iter().filter(|model| !model.in_time() && !computed(model));
    let models = models.map(|model| {
        let long_name = model.method().long_name;
        format!("torque and drag by the {long_name} (`plan.models` does not list it)")
    });
    let planned = |kind| plan.operations.iter().any(|operation| operation.kind == kind);
    let operations = case.operations.iter().filter(|own| !planned(own.kind));
    let operations = operations.map(|own| {
        let (words, name) = (own.kind.words(), own.kind.name());
        format!("{words} (`plan.operations` does not list `{name}`)")
    });
    let turned = case.operations.iter().any(|own| own.rotary_speed_rad_per_s > 0.0);
    let assumed = plan.operations.iter().filter(|operation| operation.kind.rotates() && !turned);
    let assumed = assumed.map(|operation| {
        let rpm = operation.rotary_speed_rad_per_s * 30.0 / std::f64::consts::PI;
        let words = operation.kind.words();
        format!("rotary speed of {words} (the case has no `rpm`: {rpm:.0} rpm is used)")
    });
    models.chain(operations).chain(assumed).collect()
}
