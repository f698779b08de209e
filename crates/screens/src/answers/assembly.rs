//! Static analysis of the bottom-hole assembly, for its views from the side and from above.

use serde::Serialize;
use utoipa::ToSchema;
use wholestring::{operation::OperationKind, statics::assembly::AssemblyNode};
use wholestring_case::Case;
use wholestring_results::BhaSummary;
use wholestring_runner::{CancellationToken, Error, bha};

use super::column::Column;

/// A static BHA analysis. Each pair has the component towards the high side and the one to the
/// right of it, looking down the hole; distances are from the bit.
#[derive(Debug, Serialize, ToSchema)]
pub struct AssemblyView {
    /// The operation: `drill`, `slide`, ...
    operation: &'static str,
    /// Measured depth of the bit, m.
    bit_depth_m: f64,
    /// Weight on bit, N.
    weight_on_bit_N: f64,
    /// Inclination of the hole at the bit, rad.
    inclination_rad: f64,
    /// Tool face of the lowest bend, rad; null without one.
    toolface_rad: Option<f64>,
    /// Side force of the bit on the rock, N; towards the high side it builds.
    #[schema(min_items = 2, max_items = 2)]
    side_force_N: [f64; 2],
    /// Tilt of the bit relative to the hole's axis, rad.
    #[schema(min_items = 2, max_items = 2)]
    tilt_rad: [f64; 2],
    /// Upper end of the assembly, m, where ordinary pipe begins.
    length_m: f64,
    /// Contacts with the wall, from the bit up.
    contacts: Vec<Touch>,
    /// Positions of the survey sensors, m.
    sensors_m: Vec<f64>,
    /// Components, from the bit up.
    parts: Vec<Part>,
    /// The axis of the string.
    axis: Axis,
    /// Wall-clock time of the solving, s.
    took_s: f64,
}

/// A contact with the wall.
#[derive(Debug, Serialize, ToSchema)]
pub struct Touch {
    /// The contacting part: `bit`, `blades`, `joint`, `body`.
    touching: &'static str,
    /// The component.
    name: String,
    /// Lower and upper end, m.
    #[schema(min_items = 2, max_items = 2)]
    from_bit_m: [f64; 2],
    /// Force on the wall, N.
    #[schema(min_items = 2, max_items = 2)]
    force_N: [f64; 2],
}

/// A component.
#[derive(Debug, Serialize, ToSchema)]
pub struct Part {
    /// Its name.
    name: String,
    /// Its lower end, m.
    from_bit_m: f64,
    /// Its upper end, m.
    to_bit_m: f64,
    /// Outside diameter of the body, m.
    od_m: f64,
    /// Diameter over its blades, m, and their length, m.
    #[schema(min_items = 2, max_items = 2)]
    blades_m: Option<[f64; 2]>,
    /// Diameter of its tool joints, m.
    joint_od_m: Option<f64>,
    /// Position of its bend, m.
    bend_m: Option<f64>,
}

/// The string's axis at its nodes, from the bit up.
#[derive(Debug, Serialize, ToSchema)]
pub struct Axis {
    /// Positions, m.
    #[schema(value_type = Vec<f32>)]
    from_bit_m: Column,
    /// Radius of the hole, m.
    #[schema(value_type = Vec<f32>)]
    hole_radius_m: Column,
    /// Offset from the hole's axis towards the high side, m.
    #[schema(value_type = Vec<f32>)]
    offset_high_m: Column,
    /// The same to the right, m.
    #[schema(value_type = Vec<f32>)]
    offset_right_m: Column,
    /// Bending moment, N·m.
    #[schema(value_type = Vec<f32>)]
    bending_moment_N_m: Column,
}

/// The assembly of a case in an operation, by default the first that drills, or else the first.
///
/// # Errors
/// An operation that the case lacks, an assembly without an equilibrium, or a cancellation.
pub fn assembly(
    case: &Case,
    operation: Option<OperationKind>,
    cancellation: &CancellationToken,
) -> Result<AssemblyView, Error> {
    let nothing = bha::Sweeps {
        toolfaces_rad: case.model.string.toolface_rad().map(|_| Vec::new()),
        weights_N: None,
        inclinations_rad: Some(Vec::new()),
        build_rate_rad_per_m: 0.0,
    };
    let on_bottom = match operation {
        Some(kind) => kind.on_bottom(),
        None => case.operations.iter().any(|one| one.kind.on_bottom()),
    };
    let sweeps = bha::Sweeps { weights_N: on_bottom.then(Vec::new), ..nothing };
    let request = bha::Request { operation, sweeps, ..bha::Request::new(case) };
    Ok(AssemblyView::of(bha::at_rest(&request, cancellation)?))
}

impl AssemblyView {
    fn of(bha::AtRest { summary, nodes, alone_s }: bha::AtRest) -> Self {
        let axis = Axis::of(&nodes);
        let BhaSummary { state, parts, .. } = summary;
        let contacts = state.contacts.into_iter().map(|contact| Touch {
            touching: contact.touching.name(),
            name: contact.name,
            from_bit_m: contact.from_bit_m,
            force_N: contact.force_N,
        });
        let parts = parts.into_iter().map(|part| Part {
            name: part.name,
            from_bit_m: part.from_bit_m,
            to_bit_m: part.to_bit_m,
            od_m: part.od_m,
            blades_m: part.blades_m,
            joint_od_m: part.joint_od_m,
            bend_m: part.bend_m,
        });
        Self {
            operation: summary.operation.name(),
            bit_depth_m: summary.bit_depth_m,
            weight_on_bit_N: summary.weight_on_bit_N,
            inclination_rad: summary.inclination_rad,
            toolface_rad: summary.toolface_rad,
            side_force_N: state.side_force_N,
            tilt_rad: state.tilt_rad,
            length_m: state.length_m,
            contacts: contacts.collect(),
            sensors_m: state.sag.iter().map(|sag| sag.from_bit_m).collect(),
            parts: parts.collect(),
            axis,
            took_s: alone_s,
        }
    }
}

impl Axis {
    fn of(nodes: &[AssemblyNode]) -> Self {
        let column = |node: fn(&AssemblyNode) -> f64| nodes.iter().map(node).collect();
        Self {
            from_bit_m: column(|node| node.from_bit_m),
            hole_radius_m: column(|node| node.hole_radius_m),
            offset_high_m: column(|node| node.offset_m[0]),
            offset_right_m: column(|node| node.offset_m[1]),
            bending_moment_N_m: column(AssemblyNode::bending_moment_N_m),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use wholestring::statics::assembly::{AssemblySettings, solve};
    use wholestring_case::load;

    use super::*;

    /// The numbers equal the engine's, and the contacts have the side forces of the bit as well.
    #[test]
    fn an_assembly_is_what_the_engine_finds() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/bent-motor.toml");
        let case = load(&file, &[]).expect("a valid case");
        let found = assembly(&case, None, &CancellationToken::new()).expect("an assembly");
        let drills = case.operations.iter().find(|one| one.kind.on_bottom());
        let operation = drills.expect("an operation that drills");
        let stiff = case.dynamics.stiff_string();
        let settings = AssemblySettings { stiff, ..AssemblySettings::default() };
        let own = solve(&case.model, operation, &settings).expect("an equilibrium");
        assert_eq!(found.side_force_N, own.bit_side_force_N);
        assert_eq!(found.tilt_rad, own.bit_tilt_rad);
        assert_eq!(found.axis.from_bit_m.len(), own.nodes.len());
        assert_eq!(found.contacts.len(), own.contacts.len());
        assert_eq!(found.contacts[0].touching, "bit");
        assert!(found.parts.iter().any(|part| part.bend_m.is_some()));
        let weight_N = operation.weight_on_bit_now_N();
        assert_eq!(found.weight_on_bit_N, weight_N);
    }

    #[test]
    fn an_operation_that_the_case_lacks_is_told() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/np13-x1042.toml");
        let case = load(&file, &[]).expect("a valid case");
        let token = CancellationToken::new();
        let refused = assembly(&case, Some(OperationKind::Slide), &token);
        let Err(Error::BadInput(message)) = refused else { panic!("{refused:?}") };
        assert!(message.contains("it has drill"), "{message}");
    }
}
