//! What hook load and torque may come to at the surface: of the rig and of the topmost component.

use wholestring::model::Model;

use super::{
    LimitKind, LimitSettings,
    limit::Limits,
    strengths::{Strength, Strengths},
};

/// A limit that hook load or surface torque is held against.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceLimit {
    /// What it is of.
    pub kind: LimitKind,
    /// The component, counted from the bit; none of the rig.
    pub component: Option<usize>,
    /// What is borne: N, of the hoist with the block, or N·m.
    pub capacity: f64,
    /// The least factor that is to be kept.
    pub required: f64,
    /// What hook load without the block, or torque, may come to with that factor.
    pub allowed: f64,
}

/// Limits of hook load, then of surface torque, as far as rig and topmost component have them. What
/// is allowed is what [`limits`](super::limits()) judges by at the surface; components below may
/// bear less.
pub fn surface_limits(model: &Model, settings: &LimitSettings) -> Vec<SurfaceLimit> {
    // What is missing is told with the limits.
    let strengths = Strengths::of(model, &mut Limits::default());
    let top = strengths.count().checked_sub(1);
    let of_top = |value: fn(&Strength<'_>) -> Option<f64>| value(strengths.component(top?));
    let rig = &model.rig;
    let all = [
        (LimitKind::Hoist, None, rig.hoist_capacity_N),
        (LimitKind::Tension, top, of_top(|of| of.tensile_yield_N())),
        (LimitKind::TopDrive, None, rig.top_drive_torque_N_m),
        (LimitKind::TopDrivePeak, None, rig.top_drive_peak_torque_N_m),
        (LimitKind::MakeUp, top, of_top(|of| of.connection.make_up_torque_N_m)),
        (LimitKind::Torsion, top, of_top(|of| of.torsional_yield_N_m())),
    ];
    let limit = |(kind, component, capacity): (LimitKind, Option<usize>, Option<f64>)| {
        let (capacity, required) = (capacity?, settings.factors.of(kind));
        let hangs_N = match kind {
            LimitKind::Hoist => rig.block_weight_N.unwrap_or(0.0),
            _ => 0.0,
        };
        let allowed = capacity / required - hangs_N;
        Some(SurfaceLimit { kind, component, capacity, required, allowed })
    };
    all.into_iter().filter_map(limit).collect()
}
