//! Bends and eccentric masses of a whole string.

use super::*;
use crate::{
    dynamics::{kernel::chain::element, output::record::Record},
    mud::Rheology,
    simd::vector::Vector,
    string::{BodyBend, Cavity, ComponentSpec, Eccentricity, StringSpec},
};

/// The string of [`model`] with a motor at its lower end that is bent 1.5° to the right, and an
/// eccentric collar.
fn bent_model() -> Model {
    let mut model = model(0.25);
    let tool = |name, od, id, length| tool(name, ComponentLength::Metres(length), od, id);
    let components = vec![
        tool("bit", 0.2159, 0.06, 0.3),
        ComponentSpec {
            bend: Some(BodyBend {
                angle_rad: 1.5f64.to_radians(),
                from_lower_end_m: 1.9,
                toolface_rad: 90f64.to_radians(),
            }),
            ..tool("motor", 0.172, 0.057, 8.0)
        },
        ComponentSpec {
            eccentricity: Some(Eccentricity {
                offset_m: 3e-3,
                phase_rad: 0.3,
                cavity: Cavity::Mud,
            }),
            ..tool("collar", 0.165, 0.0714, 27.0)
        },
        common::np13::tool("pipe", ComponentLength::ToSurface, 0.1397, 0.1186),
    ];
    model.string = StringSpec { components }.assemble(DEPTH_M).unwrap();
    model
}

fn start(kind: OperationKind, rpm: f64) -> Run<f64> {
    let operation = Operation {
        kind,
        rotary_speed_rad_per_s: rpm * std::f64::consts::TAU / 60.0,
        trip_speed_m_per_s: 0.0,
        ..REAM
    };
    let settings = DynamicsSettings {
        // The balance of energy goes by the step; longer elements leave 1.7e-3 where 1e-3 is held.
        mesh: MeshSettings::uniform(3.2),
        settle_s: 5.0,
        duration_s: 10.0,
        ..DynamicsSettings::default()
    };
    new_run(&bent_model(), &operation, &settings)
}

/// A string that hangs still with a bend and an eccentric collar loses nothing, neither to the
/// damping of its steel nor to friction nor to the mud, and its residual is that of rounding.
///
/// The increments of the spin from the bend and the collar in each step are cancelled by the twist
/// and the wall in the same step: booked as turning they were 0.01 to 0.5 W. The loss after 15 time
/// constants of a strong damping is below 1e-9 W.
#[test]
fn a_bent_string_at_rest_loses_nothing() {
    let rheology = Rheology::Newtonian { viscosity_Pa_s: 0.03 };
    for rheology in [None, Some(rheology)] {
        let mut model = bent_model();
        model.mud.rheology = rheology;
        let operation = Operation {
            kind: OperationKind::TripIn,
            rotary_speed_rad_per_s: 0.0,
            trip_speed_m_per_s: 0.0,
            ..REAM
        };
        let mut settings =
            DynamicsSettings { settle_s: 8.0, duration_s: 2.0, ..DynamicsSettings::default() };
        settings.damping.mass_per_s = 10.0;
        let mut simulation = new_run(&model, &operation, &settings);
        simulation.advance(10.0).unwrap();
        let numerics = simulation.outcome().numerics;
        let energy = numerics.energy.unwrap();
        for loss_J in [
            energy.damping_loss_J,
            energy.friction_loss_J,
            energy.mud_loss_J,
            energy.contact_loss_J,
        ] {
            assert!(loss_J.abs() < 2e-9, "{energy:?}");
        }
        assert!(numerics.energy_residual.abs() < 1e-6, "{numerics:?}");
    }
}

/// Direction of the bend: its part towards the high side and that to the right of it.
fn toolface_rad(simulation: &Run<f64>) -> f64 {
    let bend = &simulation.state.body.bends[0];
    let high = Vector::from(simulation.state.anchors[bend.index].high_side);
    let right = simulation.chain.tangent(bend.index).cross(high);
    bend.toward.dot(right).atan2(bend.toward.dot(high))
}

/// There is a node at the bend, and the eccentric masses add up to `m L e (1 − ρ_m/ρ_s)`.
#[test]
fn bends_and_eccentric_masses_find_their_nodes() {
    let simulation = start(OperationKind::RotateOffBottom, 60.0);
    let bend = &simulation.state.body.bends[0];
    assert!((simulation.mesh.nodes[bend.index].from_bit_m - 2.2).abs() < 1e-9);
    let imbalances = simulation.state.body.imbalances(&simulation.chain);
    let sum: f64 = imbalances.map(|(_, imbalance)| imbalance.moment_kg_m).sum();
    let collar = &simulation.model.string.components()[2];
    let expected = collar.mass_per_length_kg_per_m * 27.0 * 3e-3 * (1.0 - 1200.0 / 7860.0);
    assert!((sum / expected - 1.0).abs() < 1e-12, "{sum} {expected}");
}

/// Initialises the string straight in space, along the hole at the bend, and all below the bend
/// along `below`.
fn place_along(simulation: &mut Run<f64>, below: impl Fn(Vector<f64>, Vector<f64>) -> Vector<f64>) {
    let bend = simulation.state.body.bends[0].index;
    let axis = simulation.chain.tangent(bend);
    let toward = simulation.state.body.bends[0].toward;
    let toward = toward.minus(axis, toward.dot(axis));
    let toward = toward.scaled(1.0 / toward.dot(toward).sqrt());
    simulation.state.body.bends[0].toward = toward;
    let corner = simulation.state.anchors[bend].position_m;
    let from_bit_m = |i: usize| simulation.mesh.nodes[i].from_bit_m;
    for i in 0..simulation.chain.nodes() {
        let direction = if i > bend { below(axis, toward) } else { axis };
        let place = Vector::from(corner).plus(direction, from_bit_m(bend) - from_bit_m(i));
        let moved = place - Vector::from(simulation.state.anchors[i].position_m);
        simulation.chain.set_displacement(i, moved);
        simulation.chain.set_director(i, direction);
    }
    simulation.chain.close();
}

/// A body in its own bent shape carries its tension only, at the bend as elsewhere, where it weighs
/// nothing; held straight, its moment at the bend is that of two elements whose ends are turned
/// against each other by the bend's angle `θ`: the part of `K sin θ`, `K = EI/L (4 + φ)/(1 + φ)`
/// with Timoshenko's `φ`, that remains when the node between has turned. Exact but for rounding.
#[test]
fn a_bend_bears_no_stress_of_its_own() {
    const TENSION_N: f64 = 1e5;
    let mut simulation = start(OperationKind::RotateOffBottom, 60.0);
    let mut model = bent_model();
    model.mud.density_kg_per_m3 = model.string.components()[1].material.density_kg_per_m3;
    let layout = simulation.chain.layout();
    simulation.state.record = Record::new(&model, &simulation.mesh, layout, 1);
    let (bend, angle) = (simulation.state.body.bends[0].index, 1.5f64.to_radians());
    // A bit that may not tilt, for one that may has the moment of the bend carried on from its end.
    let bit = simulation.chain.elements();
    node!(simulation.chain, bit, inv_rotary = 0.0);
    for i in 0..simulation.chain.elements() {
        element!(simulation.chain, i, torque = 0.0);
        element!(simulation.chain, i, tension = TENSION_N);
    }
    place_along(&mut simulation, |axis, toward| axis.scaled(angle.cos()).plus(toward, angle.sin()));
    let state = &mut simulation.state;
    state.record.look_at_shapes(&simulation.chain, &state.body);
    let free = simulation.frame();
    let area = std::f64::consts::FRAC_PI_4 * (0.172f64.powi(2) - 0.057f64.powi(2));
    for (i, moment) in free.bending_moment_N_m.iter().enumerate() {
        assert!(*moment < 1e-4, "{moment} at node {i}");
    }
    let stress = free.von_mises_stress_Pa[bend];
    assert!((stress * area / TENSION_N - 1.0).abs() < 1e-9, "{stress}");

    for i in 0..simulation.chain.elements() {
        element!(simulation.chain, i, tension = 0.0);
    }
    place_along(&mut simulation, |axis, _| axis);
    let [above, below] = [bend - 1, bend].map(|index| {
        let element = &simulation.mesh.elements[index];
        let section = &element.section;
        let per_turn = section.bending_stiffness_N_m2 / element.length_m;
        let phi = 12.0 * per_turn / (section.shear_stiffness_N * element.length_m);
        per_turn * (4.0 + phi) / (1.0 + phi)
    });
    let expected = above * below / (above + below) * angle.sin();
    // The sums of the record use the same values as the frame.
    simulation.state.since_sample.steps = 1;
    simulation.sample();
    let held = simulation.frame().bending_moment_N_m[bend];
    let mean = simulation.outcome().nodes.bending_moment_N_m[bend];
    for found in [held, mean] {
        assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
    }
}

/// A string that does not turn keeps its tool face within 0.3° for 10 s of tripping: the string
/// untwists by 0.1° while it settles.
#[test]
fn a_tool_face_holds_while_the_string_does_not_turn() {
    let mut simulation = start(OperationKind::TripIn, 0.0);
    let before = toolface_rad(&simulation).to_degrees();
    simulation.advance(10.0).unwrap();
    let after = toolface_rad(&simulation).to_degrees();
    assert!((before - 90.0).abs() < 0.3, "{before}");
    assert!((after - before).abs() < 0.3, "{after}");
}

/// Turned at 60 rev/min for 15 s a bend turns 15 times with its node, whose turns its spin sums up,
/// the string starts without a blow (no node beyond 3 m/s), and the energies balance within 1e-3
/// (2e-4 with the bend and 2e-6 without were found).
#[test]
fn a_bent_string_turns() {
    let mut simulation = start(OperationKind::RotateOffBottom, 60.0);
    let index = simulation.state.body.bends[0].index;
    let (mut spun, mut shown, mut fastest) = (0.0, 0.0, 0.0f64);
    let mut last = toolface_rad(&simulation);
    let dt = simulation.plan.dt_s;
    for step in 0..(15.0 / dt) as usize {
        simulation.step();
        if step % 16 == 0 {
            simulation.damp(16);
            let (chain, anchors) = (&mut simulation.chain, &mut simulation.state.anchors);
            simulation.borehole.follow(chain, anchors, &mut simulation.state.high);
        }
        if (step as u64).is_multiple_of(simulation.steps_per_sample) {
            simulation.sample();
            simulation.chain.clear_sums();
        }
        spun += node!(simulation.chain, index, spin) * dt;
        let now = toolface_rad(&simulation);
        shown += (now - last + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU)
            - std::f64::consts::PI;
        last = now;
        for i in 0..simulation.chain.nodes() {
            let v = simulation.chain.velocity(i);
            fastest = fastest.max(v.dot(v).sqrt());
        }
    }
    let residual = simulation.outcome().numerics.energy_residual;
    assert!((shown - spun).abs() < 0.05, "{shown} {spun}");
    assert!((spun / std::f64::consts::TAU - 15.0).abs() < 1.0);
    assert!(fastest < 3.0, "{fastest}");
    assert!(residual.abs() < 1e-3, "{residual}");
}
