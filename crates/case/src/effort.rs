//! Whether a run of the case can be finished.

use wholestring::{dynamics::DynamicsSettings, string::DrillString};

use crate::{
    case::{CaseTable, ModelKind},
    diagnostic::Diagnostic,
    reader::Reader,
};

/// More elements than this make no sense in the longest of wells.
const MOST_ELEMENTS: f64 = 1e5;
/// More element-steps than this are weeks of computing.
const MOST_ELEMENT_STEPS: f64 = 1e14;

/// Whether a dynamic run of the case can be finished.
pub(crate) fn check_effort(
    models: &[ModelKind],
    string: &DrillString,
    dynamics: &DynamicsSettings,
    case: &CaseTable,
    reader: &mut Reader,
) -> Option<()> {
    let mut elements = 0.0;
    let mut fastest_m_per_s = 0.0_f64;
    for component in string.components() {
        let spacing_m = component
            .joints
            .map_or(f64::INFINITY, |joints| joints.spacing_m);
        let element_m = dynamics.element_length_m.min(spacing_m);
        elements += (component.length_m / element_m).ceil();
        let material = component.material;
        let wave = (material.youngs_modulus_Pa / material.density_kg_per_m3).sqrt();
        fastest_m_per_s = fastest_m_per_s.max(wave);
    }
    let time_s = dynamics.settle_s + dynamics.duration_s;
    let steps = time_s * fastest_m_per_s / dynamics.element_length_m;
    let dynamic = models.contains(&ModelKind::Dynamic);
    let message = if elements > MOST_ELEMENTS {
        format!("the string would be cut into {elements:.0} elements")
    } else if dynamic && elements * steps > MOST_ELEMENT_STEPS {
        format!("{elements:.0} elements over {time_s:.0} s would take weeks")
    } else {
        return Some(());
    };
    let mut diagnostic = Diagnostic::error(message);
    if let Some(given) = case.mesh.get().and_then(|mesh| mesh.element_length.given()) {
        diagnostic = diagnostic.at(given.place, "raise the element length");
    }
    if let Some(given) = case
        .dynamics
        .get()
        .and_then(|dynamics| dynamics.duration.given())
    {
        diagnostic = diagnostic.at(given.place, "or shorten the window");
    }
    reader.report(diagnostic);
    None
}
