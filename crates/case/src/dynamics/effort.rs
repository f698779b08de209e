//! Whether a run of the case can be finished.

use wholestring::{
    dynamics::{DynamicsSettings, Effort, SetupError},
    model::Model,
    operation::Operation,
    outcome::ModelKind,
};

use wholestring_units::{number_text, significant};

use wholestring_config::{diagnostic::Diagnostic, reader::Reader};

use crate::case::table::CaseTable;

/// Maximum number of elements, more than the longest of wells needs.
const MAX_ELEMENTS: usize = 110_000;
/// Maximum number of element-steps; more are weeks of computing.
const MAX_ELEMENT_STEPS: f64 = 1e14;
/// Shortest step, s: a twentieth of the step for elements of 0.2 m; a shorter one results from a
/// mistake.
const SHORTEST_STEP_S: f64 = 2e-6;

/// Whether the dynamic runs of the case can be finished.
pub(crate) fn check_effort(
    models: &[ModelKind],
    model: &Model,
    operations: &[Operation],
    dynamics: &DynamicsSettings,
    case: &CaseTable,
    reader: &mut Reader,
) -> Option<()> {
    if !ModelKind::any_in_time(models) {
        return Some(());
    }
    let efforts = operations.iter().map(|operation| Effort::of(model, operation, dynamics));
    let efforts: Vec<Effort> = match efforts.collect() {
        Ok(efforts) => efforts,
        Err(error) => {
            return refused(&error, case).refuse(reader);
        }
    };
    let elements = efforts.iter().map(|effort| effort.mesh.elements.len()).max()?;
    let shortest_s =
        efforts.iter().map(|effort| effort.plan.shortest_s()).fold(f64::INFINITY, f64::min);
    let element_steps: f64 = efforts.iter().map(Effort::element_steps).sum();
    let message = if elements > MAX_ELEMENTS {
        format!("the string would be cut into {elements} elements")
    } else if shortest_s < SHORTEST_STEP_S {
        format!("the time step would be {} s", number_text(significant(shortest_s, 2)))
    } else if element_steps > MAX_ELEMENT_STEPS {
        let ends_s = efforts.iter().map(|effort| effort.end_s);
        let time_s = ends_s.fold(0.0, f64::max);
        format!("{elements} elements over {time_s:.0} s would take weeks")
    } else {
        return Some(());
    };
    advice(Diagnostic::error(message), shortest_s, case).refuse(reader)
}

/// Reports a refusal by the engine, where the reader has found no mistake.
fn refused(error: &SetupError, case: &CaseTable) -> Diagnostic {
    let (SetupError::LightBit { direction, unit, bit, rock }, Some(table)) =
        (error, case.rock.given())
    else {
        return Diagnostic::error(format!("the dynamic model refuses: {error}"));
    };
    let [bit, rock] = [bit, rock].map(|inertia| number_text((inertia * 1e3).round() * 1e-3));
    Diagnostic::error(
        "the bit is too light for the elements that it touches, whose density is scaled",
    )
    .at(table.value.weighty_place().unwrap_or(table.place), format!("they have {rock} {unit}"))
    .help(format!("the lower end of the string has {bit} {unit} {direction}"))
    .help("lower density_factor or element_size under [rock], or raise element_length under [mesh]")
}

/// Adds advice to shorten the run, at the places of the case that make it long.
fn advice(mut diagnostic: Diagnostic, step_s: f64, case: &CaseTable) -> Diagnostic {
    if let Some(entry) = case.mesh.get().and_then(|mesh| mesh.element_length.given()) {
        diagnostic = diagnostic.at(entry.place, "raise the element length");
    }
    let Some(dynamics) = case.dynamics.get() else {
        return diagnostic;
    };
    let damping = dynamics.damping.get();
    if let Some(entry) = damping.and_then(|damping| damping.stiffness.given())
        && entry.value > 10.0 * step_s
    {
        diagnostic = diagnostic.at(entry.place, "it shortens the time step: lower it");
    }
    if step_s < SHORTEST_STEP_S {
        return diagnostic.help(format!(
            "the shortest element, the metal and the damping bound the step; expected {} s or more",
            number_text(SHORTEST_STEP_S)
        ));
    }
    match dynamics.duration.given() {
        Some(entry) => diagnostic.at(entry.place, "or shorten the window"),
        None => diagnostic,
    }
}
