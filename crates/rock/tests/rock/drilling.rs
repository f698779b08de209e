//! A bit that drills a block.

use nalgebra::{Matrix3, Vector3};
use wholestring_rock::{
    Alone, BitMotion, BitShape, Drilling, DrillingError, DrillingSpec, Driver, Edge, Inertia,
    Progress, Rock, Stepper,
    bit_face::{ContactLaw, Cutter, InsertBit, PdcBit, Pose},
};
use wholestring_verification::verify;

use crate::setup::{elastic, small_bit};

/// The step of a string, s.
const STEP_S: f64 = 0.64e-3;

/// Elements of the small bit's rock, m.
const SIZE_M: f64 = 6e-3;

/// 240 rev/min.
const ROTARY_RAD_PER_S: f64 = 8.0 * std::f64::consts::PI;

/// Mass that moves along the hole with the bit, kg.
const MASS_KG: f64 = 100.0;

fn rock() -> Rock {
    Rock::for_drilling(10e6)
}

/// A bit of 60 mm on elements of a tenth of that.
fn small(rock: Rock) -> DrillingSpec {
    small_bit(rock, SIZE_M)
}

fn weight(weight_N: f64) -> Driver {
    Driver::Weight { weight_N, mass_kg: MASS_KG, rotary_rad_per_s: ROTARY_RAD_PER_S }
}

/// Drills on for some revolutions.
fn drill(drilling: &mut Drilling, driver: &Driver, step_s: f64, revolutions: f64) -> Progress {
    let stepper = Stepper::default();
    let time_s = revolutions * std::f64::consts::TAU / ROTARY_RAD_PER_S;
    let mut progress = Progress::default();
    for _ in 0..(time_s / step_s).round() as usize {
        let advance = driver.drive(drilling, step_s, &stepper, &Alone);
        progress.add(drilling, &advance);
    }
    progress
}

/// Momentum of all nodes, kg·m/s.
fn momentum(drilling: &Drilling) -> Vector3<f64> {
    let block = drilling.block();
    let grid = block.grid();
    grid.each_node()
        .map(|node| grid.node(node))
        .map(|node| Vector3::from(block.velocity_m_per_s(node)) * block.mass_kg(node))
        .sum()
}

/// A bit hits a block that nothing holds: the momentum that it loses the block gains, along, across
/// and about.
#[test]
fn momentum_passes_from_the_bit_to_the_rock() {
    let mut spec = small(elastic());
    spec.contact.stiffness_Pa_per_m = elastic().youngs_modulus_Pa / SIZE_M;
    spec.block.edges = [Edge::Free; 6];
    let mut drilling = Drilling::new(&spec).unwrap();
    let inertia = Inertia {
        mass_kg: 200.0,
        lateral_mass_kg: 90.0,
        // The string leans in its hole.
        along: Vector3::new(0.36, -0.48, 0.8),
        about_axis_kg_m2: 0.3,
        across_axis_kg_m2: f64::INFINITY,
    };
    let stepper = Stepper::default();
    let mut motion = BitMotion {
        velocity_m_per_s: Vector3::new(0.3, -0.1, 0.5),
        angular_velocity_rad_per_s: Vector3::new(0.0, 0.0, 20.0),
        force_N: Vector3::zeros(),
        moment_N_m: Vector3::zeros(),
        inertia,
    };
    let mass = Matrix3::identity() * 90.0 + inertia.along * inertia.along.transpose() * 110.0;
    let before = mass * motion.velocity_m_per_s;
    let (mut off, mut passed) = (0.0_f64, 0.0_f64);
    for _ in 0..100 {
        let previous = motion;
        let advance = drilling.advance(0.1e-3, &motion, &stepper, &Alone);
        motion.velocity_m_per_s = advance.velocity_m_per_s;
        motion.angular_velocity_rad_per_s = advance.angular_velocity_rad_per_s;
        let gained = mass * (motion.velocity_m_per_s - previous.velocity_m_per_s);
        let spun = inertia.about_axis_kg_m2
            * (motion.angular_velocity_rad_per_s - previous.angular_velocity_rad_per_s).z;
        off = off
            .max((gained - advance.force_N * advance.time_s).norm() / before.norm())
            .max((spun - advance.moment_N_m.z * advance.time_s).abs() / 6.0);
        let rock = momentum(&drilling);
        passed = passed.max(rock.norm() / before.norm());
        let now = mass * motion.velocity_m_per_s + rock;
        off = off.max((now - before).norm() / before.norm());
    }
    assert!(passed > 0.1, "only {passed} has passed");
    verify(
        "rock",
        "momentum that a bit loses to a free block and that does not arrive as a part of all",
    )
    .absolute(1e-11, "rounding of 1e4 nodes and steps")
    .report(0.0, off);
}

/// A blunt insert on a column that may swell: `F = −A E (ln λ)/λ` of the mean stretch
/// `λ = 1 − u/L`.
#[test]
fn a_blunt_insert_meets_the_stiffness_of_a_column() {
    use Edge::{Free, Guided};
    let insert = InsertBit::for_diameter(15.0);
    let rock = elastic();
    let mut spec = DrillingSpec::new(rock, BitShape::Insert(insert), 1e-3).unwrap();
    spec.block.cells = [4, 4, 8];
    spec.block.edges = [Free, Free, Free, Free, Free, Guided];
    spec.wall_m = 5e-3;
    spec.seated = false;
    spec.block.numerics.density_factor = 1.0;
    spec.contact = ContactLaw {
        stiffness_Pa_per_m: 1e4 * rock.youngs_modulus_Pa / 1e-3,
        damping_ratio: 1.0,
        friction: 0.0,
    };
    let mut drilling = Drilling::new(&spec).unwrap();
    // The lowest of the inserts is on the middle of the column.
    let lowest = |cutter: &Cutter| {
        let radius_m = 0.5 * insert.insert_diameter_m;
        cutter.tip_m + (Vector3::z() - cutter.normal) * radius_m
    };
    let cutters = drilling.bit().face().cutters();
    let tip = cutters.iter().map(lowest).max_by(|a, b| a.z.total_cmp(&b.z)).unwrap();
    let pose = Pose { position_m: Vector3::new(2e-3, 2e-3, 0.0) - tip, ..*drilling.pose() };
    drilling.place(pose);
    let driver = Driver::Rate { rate_m_per_s: 0.1, rotary_rad_per_s: 0.0 };
    let stepper = Stepper::default();
    let press = |drilling: &mut Drilling, steps: usize| {
        let mut force_N = 0.0;
        for _ in 0..steps {
            let advance = driver.drive(drilling, 1e-5, &stepper, &Alone);
            force_N = -advance.force_N.z;
        }
        // The mean load on the nodes of the top, weighted by the area that carries it.
        let grid = *drilling.block().grid();
        let down = |i: usize, j: usize| {
            drilling.block().displacement_m(grid.node([i, j, 0]))[2]
                * if i.is_multiple_of(4) { 0.5 } else { 1.0 }
                * if j.is_multiple_of(4) { 0.5 } else { 1.0 }
                / 16.0
        };
        let mean_m: f64 = (0..25).map(|n| down(n % 5, n / 5)).sum();
        (force_N, mean_m, drilling.pose().position_m.z - pose.position_m.z)
    };
    let (first_N, first_m, first_way_m) = press(&mut drilling, 150);
    let (second_N, second_m, second_way_m) = press(&mut drilling, 100);
    assert!(first_N > 1e3, "{first_N} N");
    let force_N = |u: f64| {
        let stretch = 1.0 - u / 8e-3;
        -16e-6 * rock.youngs_modulus_Pa * stretch.ln() / stretch
    };
    for (quantity, expected, computed) in [
        ("force of a blunt insert on a column, N", force_N(second_m), second_N),
        (
            "stiffness of a column under a blunt insert, N/m",
            (force_N(second_m) - force_N(first_m)) / (second_m - first_m),
            (second_N - first_N) / (second_way_m - first_way_m),
        ),
    ] {
        verify("rock", quantity)
            .relative(0.01, "the tip is round, it sinks into the contact, the column rings")
            .report(expected, computed);
    }
}

/// Rate of penetration, weight and torque of twice two revolutions after one, with the books of
/// energy.
fn drilled(weight_N: f64, step_s: f64) -> [Progress; 2] {
    let mut drilling = Drilling::new(&small(rock())).unwrap();
    let driver = weight(weight_N);
    drill(&mut drilling, &driver, step_s, 1.0);
    let came_m_per_s = drilling.pose().velocity_m_per_s.z;
    let turns = [(); 2].map(|()| drill(&mut drilling, &driver, step_s, 2.0));
    let gained_N_s = MASS_KG * (drilling.pose().velocity_m_per_s.z - came_m_per_s);
    let [first, second] = turns;
    let borne_N_s = first.weight_N() * first.time_s + second.weight_N() * second.time_s;
    verify("rock", "weight carried by the rock and accelerating the bit over the weight given")
        .absolute(1e-10, "rounding")
        .report(1.0, (borne_N_s + gained_N_s) / (weight_N * (first.time_s + second.time_s)));
    for turn in &turns {
        println!(
            "{weight_N} N, {:.2} ms: {:.2} mm/rev, {:.0} ± {:.0} N, {:.1} ± {:.1} N·m, {:.2} MPa",
            1e3 * step_s,
            1e3 * turn.depth_of_cut_m(),
            turn.weight_N(),
            turn.weight_deviation_N(),
            turn.torque_N_m(),
            turn.torque_deviation_N_m(),
            1e-6 * turn.specific_energy_Pa()
        );
    }
    let (rock, bit) = (drilling.block().energies(), drilling.energies());
    verify("rock", "energy that is unaccounted for after a bit has drilled as a part of its work")
        .absolute(0.01, "required")
        .report(0.0, rock.residual_J() / rock.pushed_J);
    verify("rock", "energy lost between bit and rock as a part of the bit's work")
        .absolute(1e-10, "rounding")
        .report(
            0.0,
            (bit.residual_J().abs() + (bit.on_rock_J - rock.pushed_J).abs()) / bit.on_bit_J.abs(),
        );
    verify("rock", "kinetic energy under a drilling bit as a part of the work of deformation")
        .absolute(0.05, "condition on density scaling")
        .report(0.0, rock.kinetic_fraction());
    // The block follows: the bit is soon deeper than the block.
    let block = drilling.block();
    let below_m =
        block.top_m() + block.grid().cells[2] as f64 * SIZE_M - drilling.pose().position_m.z;
    assert!(below_m > 3.0 * SIZE_M, "{below_m} m of rock below the bit");
    turns
}

#[test]
fn a_bit_drills_steadily_faster_with_more_weight_whatever_the_step() {
    let rate = |turns: &[Progress; 2]| 0.5 * (turns[0].rate_m_per_s() + turns[1].rate_m_per_s());
    let torque = |turns: &[Progress; 2]| 0.5 * (turns[0].torque_N_m() + turns[1].torque_N_m());
    let light = drilled(1000.0, STEP_S);
    let heavy = drilled(3000.0, STEP_S);
    let fine = drilled(3000.0, 0.5 * STEP_S);
    for [first, second] in [heavy, fine] {
        verify("rock", "rate of a drilling bit over two revolutions over that of the two before")
            .absolute(0.3, "three times the spread: that of a revolution is 9 %")
            .report(1.0, second.rate_m_per_s() / first.rate_m_per_s());
    }
    assert!(rate(&heavy) > 1.3 * rate(&light));
    assert!(torque(&heavy) > 1.3 * torque(&light));
    let radius_m = 0.03;
    for (quantity, expected, computed, reason) in [
        (
            "torque of a drilling bit over weight and radius",
            1.0 / 1.2,
            torque(&heavy) / (3000.0 * radius_m),
            "1/2ζ of sharp cutters at ζ = 0.6 (E07)",
        ),
        (
            "specific energy of a drilling bit over the rock's strength",
            1.0,
            0.5 * (heavy[0].specific_energy_Pa() + heavy[1].specific_energy_Pa()) / 10e6,
            "published for sharp cutters without pressure; `specific_energy` holds it",
        ),
    ] {
        verify("rock", quantity).any(reason).report(expected, computed);
    }
    for (quantity, of_fine, of_heavy) in [
        ("rate of a drilling bit with half the caller's step, m/s", rate(&fine), rate(&heavy)),
        (
            "torque of a drilling bit with half the caller's step, N·m",
            torque(&fine),
            torque(&heavy),
        ),
    ] {
        verify("rock", quantity)
            .relative(
                0.2,
                "three times the spread: that of a revolution is 9 %, there are four of each",
            )
            .report(of_heavy, of_fine);
    }
}

#[test]
fn a_bit_goes_on_from_a_checkpoint_with_the_same_bits() {
    let stepper = Stepper::default();
    let driver = weight(2000.0);
    let mut drilling = Drilling::new(&small(rock())).unwrap();
    for _ in 0..60 {
        driver.drive(&mut drilling, STEP_S, &stepper, &Alone);
    }
    let bits = |drilling: &Drilling| postcard::to_allocvec(drilling).expect("plain data");
    let mut other: Drilling = postcard::from_bytes(&bits(&drilling)).expect("the same data");
    for _ in 0..60 {
        driver.drive(&mut drilling, STEP_S, &stepper, &Alone);
        driver.drive(&mut other, STEP_S, &stepper, &Alone);
    }
    assert!(drilling.block().removed().0 > 0);
    assert!(bits(&drilling) == bits(&other));
}

/// A bit begins in its own hole: nothing touches, a little lower something does, and the books are
/// right.
#[test]
fn a_bit_begins_in_its_own_bottom() {
    let mut spec = small(rock());
    spec.block.pressure_Pa = 3e6;
    spec.block.confinement_Pa = 5e6;
    let drilling = Drilling::new(&spec).unwrap();
    assert_eq!(drilling.dropped(), drilling.block().removed().0);
    let energies = drilling.block().energies();
    assert!(energies.residual_J().abs() < 1e-9 * energies.entered_J);
    let held = |drilling: &Drilling, down_m: f64| {
        let mut pose = *drilling.pose();
        pose.position_m.z += down_m;
        let face = drilling.bit().face();
        let mut nodes = drilling.block().exposed();
        nodes.any(|node| face.holds(pose.to_bit(node.position_m.into())).is_some())
    };
    assert!(!held(&drilling, 0.0));
    assert!(held(&drilling, SIZE_M / 50.0));
    // No element reaches into the hole that the profile sweeps.
    let pose = *drilling.pose();
    let profile = drilling.bit().face().profile();
    let mut under = 0;
    for node in drilling.block().exposed() {
        let at = Vector3::from(node.position_m) - pose.position_m;
        let radius_m = at.xy().norm();
        if radius_m < profile.radius_m() - 1e-9 {
            under += 1;
            // Lowered until it touched, by less than an element.
            assert!(at.z > profile.z_m(radius_m) - SIZE_M, "{at:?}");
        }
    }
    assert!(under > 50, "{under} nodes under the bit");
    // It cuts at once.
    let mut drilling = Drilling::new(&small(rock())).unwrap();
    let bored = drill(&mut drilling, &weight(3000.0), STEP_S, 0.5);
    verify(
        "rock",
        "weight carried in the first half revolution of a bit in its bottom over the weight",
    )
    .absolute(0.2, "the bit of 100 kg begins at rest")
    .report(1.0, bored.weight_N() / 3000.0);
    assert!(bored.depth_m > 0.5 * SIZE_M, "{} m", bored.depth_m);
}

/// An invalid specification is rejected with the same reason before anything is built and on
/// building.
#[test]
fn what_cannot_be_drilled_is_refused_before_it_is_built() {
    let valid = small(rock());
    let altered = |alter: &dyn Fn(&mut DrillingSpec)| {
        let mut spec = valid.clone();
        alter(&mut spec);
        let reason = spec.check().unwrap_err();
        assert_eq!(Drilling::new(&spec).unwrap_err(), reason);
        reason
    };
    let shallow = altered(&|spec| spec.wall_m = spec.block.cells[2] as f64 * SIZE_M);
    assert!(matches!(shallow, DrillingError::Shallow { .. }), "{shallow}");
    let empty = altered(&|spec| spec.block.cells[1] = 0);
    assert!(matches!(empty, DrillingError::Rock(_)), "{empty}");
    let light = altered(&|spec| spec.block.rock.density_kg_per_m3 = 0.0);
    assert!(matches!(light, DrillingError::Rock(_)), "{light}");
    let faceless = altered(&|spec| spec.bit = BitShape::Pdc(PdcBit::for_diameter(-1.0)));
    assert!(matches!(faceless, DrillingError::Face(_)), "{faceless}");
    // More than any memory holds.
    let mut vast = valid.clone();
    vast.block.cells = [1500; 3];
    assert_eq!(vast.check(), Ok(()));
}
