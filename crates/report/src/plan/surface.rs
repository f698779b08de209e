//! Limits of hook load and torque at the surface.

use wholestring_judge::CheckKind;
use wholestring_results::PlanSurfaceLimit;

/// A limit beyond the curves by more than this factor is written, not drawn, because it would
/// flatten them.
pub(super) const FAR: f64 = 1.35;

/// Title of the line of a limit: `hoist`, `pipe, torsion`, ...
pub fn surface_limit_title(limit: &PlanSurfaceLimit) -> &str {
    match CheckKind::named(&limit.kind) {
        Some(CheckKind::Hoist) => "hoist",
        Some(CheckKind::Tension) => "pipe, tension",
        Some(CheckKind::Torsion) => "pipe, torsion",
        Some(CheckKind::MakeUp) => "make-up",
        Some(CheckKind::TopDrive) => "top drive",
        Some(CheckKind::TopDrivePeak) => "top drive, peak",
        _ => &limit.kind,
    }
}

/// Whether a limit is drawn with curves up to this value, N or N·m.
pub fn surface_limit_is_near(limit: &PlanSurfaceLimit, largest: f64) -> bool {
    limit.allowed <= FAR * largest
}
