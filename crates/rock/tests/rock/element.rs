//! One element: elasticity, cycles, rotation.

use nalgebra::{Matrix3, Rotation3, Vector3};
use wholestring_rock::{Block, Edge, Stepper};
use wholestring_verification::verify;

use crate::setup::{ductile, elastic, one_element, press, step, stretches, tell_layer_down};

/// One element whose eight nodes go as prescribed.
fn led(rock: wholestring_rock::Rock) -> Block {
    one_element(rock, [Edge::Held; 6], 0.0)
}

/// Leads the nodes to `F X` in a step.
fn lead(block: &mut Block, stepper: &Stepper, gradient: Matrix3<f64>) {
    let (grid, dt) = (*block.grid(), block.dt_s());
    for node in grid.each_node() {
        let index = grid.node(node);
        let rest = Vector3::from([0, 1, 2].map(|a| node[a] as f64 * grid.size_m[a]));
        let goal = gradient * rest - rest;
        let velocity = (goal - Vector3::from(block.displacement_m(index))) / dt;
        block.tell(index, velocity.into());
    }
    step(block, stepper);
}

fn matrix([xx, yy, zz, xy, yz, zx]: [f64; 6]) -> Matrix3<f64> {
    Matrix3::new(xx, xy, zx, xy, yy, yz, zx, yz, zz)
}

#[test]
fn a_element_has_the_rocks_elastic_constants() {
    let (rock, stepper) = (elastic(), Stepper::default());
    let mut block = press(rock, 0.0);
    // Slowly, over some hundred periods of the element, to a strain of 1e-5.
    let (steps, strain) = (10_000, 1e-5);
    let speed = -strain * 1e-3 / (f64::from(steps) * block.dt_s());
    tell_layer_down(&mut block, 1, speed);
    for _ in 0..steps {
        step(&mut block, &stepper);
    }
    let [across, _, along] = stretches(&block).map(|stretch| stretch - 1.0);
    let stress = block.stress_Pa([0, 0, 0]);
    // The strain is the logarithm of the stretch: half of it off.
    verify("rock", "Young's modulus of an element, Pa")
        .relative(1e-4, "strains of 1e-5, and the oscillation after the start")
        .report(rock.youngs_modulus_Pa, stress[2] / along);
    verify("rock", "Poisson's ratio of an element")
        .relative(1e-3, "the oscillation after the start")
        .report(rock.poisson_ratio, -across / along);
    let mut block = led(rock);
    let sheared = Matrix3::identity() + 1e-5 * matrix([0.0, 0.0, 0.0, 0.5, 0.0, 0.0]);
    lead(&mut block, &stepper, sheared);
    verify("rock", "shear modulus of an element, Pa")
        .relative(1e-5, "the strain itself")
        .report(rock.shear_modulus_Pa(), block.stress_Pa([0, 0, 0])[3] / 1e-5);
}

#[test]
fn an_elastic_cycle_leaves_no_stress() {
    let (rock, stepper) = (elastic(), Stepper::default());
    let mut block = led(rock);
    let path = matrix([1.0, -0.4, 0.3, 0.8, -0.5, 0.6]);
    let mut peak: f64 = 0.0;
    let (cycles, steps) = (200, 100);
    for n in 1..=cycles * steps {
        let phase = f64::from(n) / f64::from(steps) * std::f64::consts::TAU;
        lead(&mut block, &stepper, Matrix3::identity() + 1e-3 * phase.sin() * path);
        peak = peak.max(block.stress_Pa([0, 0, 0])[0].abs());
    }
    let left = block.stress_Pa([0, 0, 0]).iter().fold(0.0_f64, |a, s| a.max(s.abs()));
    verify("rock", "stress after 200 elastic cycles as a part of the peak")
        .absolute(
            1e-6,
            "the strain increment's series is cut after its square: 4e-9 per step of 6e-5, of \
             both signs",
        )
        .report(0.0, left / peak);
}

#[test]
fn plastic_cycles_close() {
    let (rock, stepper) = (ductile(wholestring_rock::Rock::of_strength(50e6)), Stepper::default());
    let mut block = led(rock);
    // Shear at constant volume under a mean pressure: the loop is that of an ideally plastic rock.
    let squeezed = Matrix3::identity() * (1.0 - 1e-3);
    let (cycles, steps) = (50, 400);
    // The largest shear stress of a cycle.
    let peak = |block: &mut Block| {
        let mut peak: f64 = 0.0;
        for n in 1..=steps {
            let phase = f64::from(n) / f64::from(steps) * std::f64::consts::TAU;
            let shear = matrix([0.0, 0.0, 0.0, 4e-3 * phase.sin(), 0.0, 0.0]);
            lead(block, &stepper, squeezed + shear);
            peak = peak.max(block.stress_Pa([0, 0, 0])[3]);
        }
        peak
    };
    let peaks: Vec<f64> = (0..cycles).map(|_| peak(&mut block)).skip(1).collect();
    // Dilation makes the pressure grow from loop to loop where it is kept in; without it, loops
    // repeat.
    let grows = peaks.windows(2).all(|pair| pair[1] >= pair[0] * (1.0 - 1e-9));
    assert!(grows, "{peaks:?}");
    let rock = wholestring_rock::Rock { dilation_angle_rad: 0.0, ..rock };
    let mut block = led(rock);
    let peaks: Vec<f64> = (0..cycles).map(|_| peak(&mut block)).collect();
    verify("rock", "peak shear stress of the 50th plastic cycle as a part of the 2nd's")
        .relative(
            1e-3,
            "the volume of the sheared element changes by 1.6e-5, the square of the shear",
        )
        .report(1.0, peaks[49] / peaks[1]);
}

#[test]
fn a_turned_element_feels_nothing() {
    let (rock, stepper) = (elastic(), Stepper::default());
    let mut block = led(rock);
    let axis = Vector3::new(1.0, 2.0, -1.5).normalize();
    let angle = |n: u32| f64::from(n) * 1e-3;
    for n in 1..=6283 {
        let rotation = Rotation3::new(axis * angle(n));
        lead(&mut block, &stepper, rotation.into_inner());
    }
    let stress = block.stress_Pa([0, 0, 0]).iter().fold(0.0_f64, |a, s| a.max(s.abs()));
    verify("rock", "stress after a whole turn as a part of Young's modulus")
        .absolute(
            1e-8,
            "steps of 1e-3 rad leave a strain of an eighth of their fourth power each, 8e-10 \
             in all",
        )
        .report(0.0, stress / rock.youngs_modulus_Pa);

    // A strained element takes its stress along.
    let mut block = led(rock);
    let strained = Matrix3::identity() + matrix([1e-4, -3e-4, 2e-4, 1e-4, 0.0, -1e-4]);
    lead(&mut block, &stepper, strained);
    let before = matrix(block.stress_Pa([0, 0, 0]));
    let mut rotation = Rotation3::identity();
    for n in 1..=2000 {
        rotation = Rotation3::new(axis * angle(n));
        lead(&mut block, &stepper, rotation * strained);
    }
    let expected = rotation * before * rotation.inverse();
    let error = (matrix(block.stress_Pa([0, 0, 0])) - expected).norm() / before.norm();
    verify("rock", "error of the stress of a strained element after a turn of 2 rad")
        .absolute(
            1e-5,
            "steps of 1e-3 rad: a sixth of their third power each is 3e-7 in all, and the \
             spurious strain's 2e-10 over strains of 3e-4",
        )
        .report(0.0, error);
}

/// A node that is held across a face continues as prescribed when it is pushed, and the energy
/// balance includes the support: it absorbs the work of the push. Along the face the node is free.
#[test]
fn what_holds_a_node_bears_a_push() {
    let (mut block, stepper) = (press(elastic(), 0.0), Stepper::default());
    let velocity = [0.02, 0.0, 0.0];
    let index = block.grid().node([0, 1, 1]);
    block.tell(index, velocity);
    step(&mut block, &stepper);
    let before = block.energies();
    let work = block.push(index, [1e3, 1e3, 0.0]);
    let node = block.exposed().find(|node| node.index == index);
    let [x, y, _] = node.expect("a node of the surface").velocity_m_per_s;
    assert_eq!(x, velocity[0]);
    assert!(y > 1e-3, "{y} m/s along the face");
    let after = block.energies();
    let work_J = after.edges_J - before.edges_J;
    let dt = 1e3 * block.dt_s();
    assert!((work_J + dt * velocity[0]).abs() < 1e-12 * dt, "{work_J} J by the holder");
    assert!((after.pushed_J - before.pushed_J - work).abs() < 1e-12 * work.abs());
}
