//! From model and mesh to the chain that the time loop moves.

use crate::{
    dynamics::{
        kernel::chain::{Chain, node},
        settings::{DynamicsSettings, HoistControl, schedule::HoistSetPoint},
    },
    ends::{BitEnd, Ends, TopEnd},
    model::Model,
    mud::Densities,
    operation::Operation,
    rod::{element::Stiffness, in_fluid, mesh::Mesh, stability::StepPlan},
    simd::number::Real,
};

/// Most mud that is carried along outside, as a multiple of the mud that the pipe displaces:
/// reached where a pipe fills 82 % of its hole. The formula of the concentric annulus grows without
/// bound where a tool fills its hole, for it has the mud go round it in a plane; round a stabiliser
/// or a bit, no longer than its hole is wide, most of it goes round the ends.
const MAX_ADDED_MUD: f64 = 5.0;

/// Lateral mass of each element, kg/m: steel, mud inside, and the mud that an accelerated cylinder
/// carries along in an annulus, `ρ π r² (R² + r²)/(R² − r²)`.
pub fn lateral_mass_kg_per_m(model: &Model, mesh: &Mesh, bit_md_m: f64) -> Vec<f64> {
    let in_fluid = in_fluid::along(model, mesh);
    mesh.elements
        .iter()
        .zip(&mesh.nodes)
        .zip(&in_fluid)
        .map(|((element, top), fluid)| {
            let section = &element.section;
            let md = bit_md_m - top.from_bit_m + 0.5 * element.length_m;
            let hole = 0.5 * model.well.hole.at(md).diameter_m;
            let r = 0.5 * section.od_m;
            let (r2, hole2) = (r * r, hole * hole);
            let confined = ((hole2 + r2) / (hole2 - r2).max(1e-12)).min(MAX_ADDED_MUD);
            let outside = std::f64::consts::PI * r2 * confined;
            let Densities { annulus_kg_per_m3, .. } = fluid.densities;
            let carried = annulus_kg_per_m3 * (section.bore_m2 + outside);
            section.steel_kg_per_m + carried + fluid.densities.excess_kg_per_m(section.bore_m2)
        })
        .collect()
}

/// The chain with its inertia, stiffness, weight and drag; nothing is placed yet.
pub fn chain(model: &Model, mesh: &Mesh, plan: &StepPlan) -> Chain {
    let mut chain = Chain::patterned(mesh.nodes.len(), mesh.nodes_per_joint());
    let mud = &model.mud;
    let in_fluid = in_fluid::along(model, mesh);
    let last = mesh.nodes.len() - 1;
    for (index, element) in mesh.elements.iter().enumerate() {
        let around_kg_per_m3 = in_fluid[index].densities.annulus_kg_per_m3;
        let section = &element.section;
        let inertia = &plan.inertia[index];
        chain.set_stiffness(index, &Stiffness::new(section, element.length_m));
        let half = 0.5 * element.length_m;
        let weight = half * in_fluid[index].weight_N_per_m;
        for end in [index, index + 1] {
            node!(chain, end, mass_axial += 0.5 * inertia.axial_kg);
            node!(chain, end, mass_lateral += 0.5 * inertia.lateral_kg);
            node!(chain, end, polar += 0.5 * inertia.polar_kg_m2);
            // Summed here, inverted below.
            node!(chain, end, inv_rotary += inertia.rotary_kg_m2);
            node!(chain, end, drag_linear += half * mud.linear_drag_Pa_s);
            node!(
                chain,
                end,
                drag_quadratic +=
                    half * 0.5 * around_kg_per_m3 * mud.drag_coefficient * section.od_m
            );
            let mut total = chain.weight(end);
            total.2 += weight;
            chain.set_weight(end, total);
        }
    }
    for index in 0..=last {
        let rotary = node!(chain, index, inv_rotary);
        node!(chain, index, gyroscopic = node!(chain, index, polar) / rotary);
        node!(chain, index, inv_rotary = 1.0 / rotary);
    }
    if let Some(subcycling) = &plan.subcycling {
        let below = subcycling.border_node + 1;
        node!(chain, below, mass_axial += subcycling.axial_kg);
        node!(chain, below, polar += subcycling.polar_kg_m2);
    }
    release(&mut chain, model.ends);
    chain
}

/// Frees the axial motion and the spin of all nodes, but for the spin of the top, which the top
/// drive prescribes. The top does not leave the axis, and clamped ends do not tilt.
pub fn release(chain: &mut Chain, ends: Ends) {
    for index in 0..chain.nodes() {
        node!(chain, index, inv_mass_axial = 1.0 / node!(chain, index, mass_axial));
        node!(chain, index, inv_mass_lateral = 1.0 / node!(chain, index, mass_lateral));
        node!(chain, index, inv_polar = 1.0 / node!(chain, index, polar));
    }
    node!(chain, 0, inv_mass_lateral = 0.0);
    node!(chain, 0, inv_polar = 0.0);
    let top = (ends.top == TopEnd::Clamped).then_some(0);
    let bit = (ends.bit == BitEnd::Clamped).then_some(chain.nodes() - 1);
    for clamped in top.into_iter().chain(bit) {
        node!(chain, clamped, inv_rotary = 0.0);
        node!(chain, clamped, gyroscopic = 0.0);
    }
}

/// Fixes the axial motion and the spin of all nodes, so that only lateral motion is left.
pub fn hold(chain: &mut Chain) {
    for block in &mut chain.node_blocks {
        block.inv_mass_axial.0.fill(0.0);
        block.inv_polar.0.fill(0.0);
    }
}

/// Weight of the node at the top of the chain along the hole, N: part of the hook load.
pub fn top_weight_N(chain: &Chain<impl Real>) -> f64 {
    chain.weight(0).dot(chain.tangent(0))
}

// State of the hoist at the beginning of a run.

/// Returns the hoist's motion at time zero and the resulting axial velocity of the string, m/s.
pub fn hoisting(operation: &Operation, settings: &DynamicsSettings) -> (HoistControl, f64) {
    let start = settings.schedule.at_time_zero(operation);
    let own = settings.bit.axial_velocity_m_per_s(
        operation,
        start.weight_on_bit_N,
        start.rotary_speed_rad_per_s,
    );
    let usual = if operation.kind.on_bottom() {
        HoistControl::Autodriller
    } else {
        HoistControl::BlockVelocity(own)
    };
    let control = match settings.schedule.hoist_at_time_zero() {
        Some(HoistSetPoint::BlockVelocity(velocity)) => HoistControl::BlockVelocity(velocity),
        Some(HoistSetPoint::WeightOnBit(_)) => HoistControl::Autodriller,
        None => settings.hoist_control.unwrap_or(usual),
    };
    match control {
        HoistControl::BlockVelocity(velocity) => (control, velocity),
        _ => (control, own),
    }
}
