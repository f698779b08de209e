//! Allowed hook load and torque at the surface: of the rig and of the topmost component.

use wholestring::model::Model;

use crate::{
    CheckKind, Checks, LimitSettings,
    strengths::{Strength, Strengths},
};

/// A limit of hook load or surface torque.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceLimit {
    /// The kind of limit.
    pub kind: CheckKind,
    /// The component; `None` for the rig.
    pub component: Option<String>,
    /// The capacity: N, for the hoist with the block, or N·m.
    pub capacity: f64,
    /// The required factor.
    pub required: f64,
    /// The allowed hook load without the block, or torque, by that factor.
    pub allowed: f64,
}

/// Limits of hook load, then of surface torque, as far as rig and topmost component define them.
/// The allowed loads are those by which a [`Judge`](crate::Judge) judges at the surface; components
/// below may be weaker.
pub fn surface_limits(model: &Model, settings: &LimitSettings) -> Vec<SurfaceLimit> {
    // Missing numbers are reported with the checks.
    let strengths = Strengths::of(model, &mut Checks::default());
    let top = strengths.count().checked_sub(1);
    let of_top = |value: fn(&Strength<'_>) -> Option<f64>| value(strengths.component(top?));
    let name = top.map(|top| model.string.components()[top].name.clone());
    let rig = &model.rig;
    let all = [
        (CheckKind::Hoist, None, rig.hoist_capacity_N),
        (CheckKind::Tension, name.clone(), of_top(|top| top.tensile_yield_N())),
        (CheckKind::TopDrive, None, rig.top_drive_torque_N_m),
        (CheckKind::TopDrivePeak, None, rig.top_drive_peak_torque_N_m),
        (CheckKind::MakeUp, name.clone(), of_top(|top| top.connection.make_up_torque_N_m)),
        (CheckKind::Torsion, name, of_top(|top| top.torsional_yield_N_m())),
    ];
    let limit = |(kind, component, capacity): (CheckKind, Option<String>, Option<f64>)| {
        let (capacity, required) = (capacity?, settings.factors.required(kind));
        let hangs_N = match kind {
            CheckKind::Hoist => rig.block_weight_N.unwrap_or(0.0),
            _ => 0.0,
        };
        let allowed = capacity / required - hangs_N;
        Some(SurfaceLimit { kind, component, capacity, required, allowed })
    };
    all.into_iter().filter_map(limit).collect()
}
