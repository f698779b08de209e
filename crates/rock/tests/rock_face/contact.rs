//! The face against nodes of rock.

use nalgebra::{Rotation3, Vector3};
use wholestring_rock::bit_face::{BitFace, BitLoad, Contact, ContactLaw, Pose, RockNode};

use super::{faces, opposed, pdc};

/// Nodes, component by component.
#[derive(Debug, Clone, Default)]
struct Nodes {
    position: [Vec<f64>; 3],
    velocity: [Vec<f64>; 3],
    force: [Vec<f64>; 3],
    mass: Vec<f64>,
    area: Vec<f64>,
}

fn at(columns: &[Vec<f64>; 3], i: usize) -> Vector3<f64> {
    Vector3::new(columns[0][i], columns[1][i], columns[2][i])
}

impl Nodes {
    fn push(&mut self, position: Vector3<f64>, velocity: Vector3<f64>, force: Vector3<f64>) {
        for axis in 0..3 {
            self.position[axis].push(position[axis]);
            self.velocity[axis].push(velocity[axis]);
            self.force[axis].push(force[axis]);
        }
        // 4 mm of rock of 2600 kg/m³.
        self.mass.push(2600.0 * 0.004f64.powi(3));
        self.area.push(0.004 * 0.004);
    }

    fn touch(&mut self, face: &BitFace, pose: &Pose, law: &ContactLaw, dt: f64) -> BitLoad {
        let mut contact = Contact::new(face, pose, law, dt);
        for i in 0..self.mass.len() {
            let node = RockNode {
                position_m: at(&self.position, i),
                velocity_m_per_s: at(&self.velocity, i),
                force_N: at(&self.force, i),
                mass_kg: self.mass[i],
            };
            if !contact.reaches(node.position_m) {
                continue;
            }
            if let Some(force) = contact.touch(&node, || self.area[i]) {
                (0..3).for_each(|axis| self.force[axis][i] += force[axis]);
            }
        }
        contact.load()
    }

    /// One step of the leapfrog.
    fn go(&mut self, dt: f64) {
        for axis in 0..3 {
            for i in 0..self.mass.len() {
                self.velocity[axis][i] += dt * self.force[axis][i] / self.mass[i];
                self.position[axis][i] += dt * self.velocity[axis][i];
            }
        }
    }

    fn kinetic(&self) -> f64 {
        let half = |i: usize| 0.5 * self.mass[i] * at(&self.velocity, i).norm_squared();
        (0..self.mass.len()).map(half).sum()
    }
}

/// Numbers between -0.5 and 0.5, the same ones every time.
fn random(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    }
}

fn law() -> ContactLaw {
    ContactLaw { stiffness_Pa_per_m: 20e9 / 0.004, damping_ratio: 1.0, friction: 0.3 }
}

const DT: f64 = 2e-7;

/// Nodes all over a face, most of them inside, moving and pulled about.
fn cloud(face: &BitFace, count: usize) -> Nodes {
    let mut random = random(5);
    let mut nodes = Nodes::default();
    let mut vector = |scale: f64| Vector3::from_fn(|_, _| scale * random());
    for i in 0..count {
        let tip = &face.cutters()[i % face.cutters().len()];
        let position = tip.tip_m + vector(4e-3) - tip.normal * 1e-3;
        nodes.push(position, vector(2.0), vector(200.0));
    }
    nodes
}

fn turning() -> Pose {
    Pose::new(
        Vector3::new(3.0, -2.0, 1500.0),
        Vector3::new(0.2, -0.1, 1.0),
        Vector3::new(-1.0, 0.3, 0.5),
        0.7,
    )
    .moving(Vector3::new(0.05, 0.02, 0.4), Vector3::new(0.3, -1.0, 12.0))
}

/// The nodes of the bit's frame where a pose puts them.
fn placed(mut nodes: Nodes, pose: &Pose) -> Nodes {
    for i in 0..nodes.mass.len() {
        let position = pose.to_rock(at(&nodes.position, i));
        let [velocity, force] =
            [&nodes.velocity, &nodes.force].map(|columns| pose.rotation * at(columns, i));
        for axis in 0..3 {
            nodes.position[axis][i] = position[axis];
            nodes.velocity[axis][i] = velocity[axis];
            nodes.force[axis][i] = force[axis];
        }
    }
    nodes
}

/// Bit and nodes give each other the same force and the same moment, to rounding, about a point 1.5
/// km away; and the works add up to the gain of the nodes, the loss of the bit and the dissipation
/// of the contact.
#[test]
fn momentum_and_energy_pass_exactly() {
    let pose = turning();
    for (name, face) in faces() {
        let mut nodes = placed(cloud(&face, 400), &pose);
        let before = nodes.clone();
        let load = nodes.touch(&face, &pose, &law(), DT);
        assert!(load.touching > 100, "{name}: {}", load.touching);
        let (mut force, mut moment) = (load.force_N, load.moment_N_m);
        let (mut sum, mut other_work) = (0.0, 0.0);
        moment += pose.position_m.cross(&load.force_N);
        for i in 0..nodes.mass.len() {
            let added = at(&nodes.force, i) - at(&before.force, i);
            force += added;
            moment += at(&nodes.position, i).cross(&added);
            sum += added.norm();
            let gained = at(&nodes.force, i) * (0.5 * DT / nodes.mass[i]);
            other_work += DT * at(&before.force, i).dot(&(at(&nodes.velocity, i) + gained));
        }
        assert!(force.norm() < 1e-12 * sum, "{name}: {force}");
        assert!(moment.norm() < 1e-12 * sum * 1500.0, "{name}: {moment}");

        let kinetic = nodes.kinetic();
        nodes.go(DT);
        let gained = nodes.kinetic() - kinetic;
        let scale = kinetic + nodes.kinetic();
        let residual = gained - other_work - load.work_on_nodes_J;
        assert!(residual.abs() < 1e-12 * scale, "{name}: {residual}");
        let twist = load.moment_N_m.dot(&pose.angular_velocity_rad_per_s);
        let on_bit = DT * (load.force_N.dot(&pose.velocity_m_per_s) + twist);
        assert!((load.work_on_bit_J - on_bit).abs() < 1e-11 * scale);
        let works = load.work_on_nodes_J + load.work_on_bit_J;
        let books = works + load.friction_loss_J + load.contact_loss_J;
        assert!(books.abs() < 1e-12 * scale, "{name}: {books}");
    }
}

/// Points inside a face are within its reach; points out of reach need not be tested.
#[test]
fn what_is_held_is_in_reach() {
    let (pose, law) = (turning(), law());
    for (name, face) in faces() {
        let contact = Contact::new(&face, &pose, &law, DT);
        let nodes = placed(cloud(&face, 2000), &pose);
        let (mut held, mut random) = (0, random(3));
        for i in 0..nodes.mass.len() {
            // Of the cloud, and of all around it.
            let near = at(&nodes.position, i);
            for position in [near, near + Vector3::from_fn(|_, _| 0.1 * random())] {
                if face.holds(pose.to_bit(position)).is_some() {
                    held += 1;
                    assert!(contact.reaches(position), "{name}: {position}");
                }
            }
        }
        assert!(held > 500, "{name}: {held}");
        let far = pose.position_m - pose.axis() * face.profile().radius_m() * 9.0;
        assert!(!contact.reaches(far), "{name}");
    }
}

/// The result does not depend on the frame of reference.
#[test]
fn a_turned_world_is_the_same() {
    let face = pdc().face().unwrap();
    let straight = Pose::new(Vector3::zeros(), Vector3::z(), Vector3::x(), 0.0)
        .moving(Vector3::new(0.1, 0.0, 0.3), Vector3::new(0.0, 0.5, 15.0));
    let turn = Rotation3::new(Vector3::new(0.9, -1.7, 0.4));
    let place = Vector3::new(0.5, -0.25, 2.0);
    let turned = Pose {
        position_m: place,
        rotation: turn.matrix() * straight.rotation,
        velocity_m_per_s: turn * straight.velocity_m_per_s,
        angular_velocity_rad_per_s: turn * straight.angular_velocity_rad_per_s,
    };
    let here = cloud(&face, 300);
    let mut there = here.clone();
    for i in 0..here.mass.len() {
        for (to, from, by) in [
            (&mut there.position, &here.position, place),
            (&mut there.velocity, &here.velocity, Vector3::zeros()),
            (&mut there.force, &here.force, Vector3::zeros()),
        ] {
            let vector = turn * at(from, i) + by;
            (0..3).for_each(|axis| to[axis][i] = vector[axis]);
        }
    }
    let mut here = here;
    let a = here.touch(&face, &straight, &law(), DT);
    let b = there.touch(&face, &turned, &law(), DT);
    assert_eq!(a.touching, b.touching);
    // A position of 2 m is known to 4e-16; α that much off is 4e-13 of 1 mm, and the largest forces
    // set the scale.
    let scale = (0..here.mass.len()).map(|i| at(&here.force, i).norm());
    let scale = scale.fold(0.0, f64::max);
    for i in 0..here.mass.len() {
        let off = turn * at(&here.force, i) - at(&there.force, i);
        assert!(off.norm() < 1e-10 * scale, "{i}: {off}");
    }
    assert!((turn * a.force_N - b.force_N).norm() < 1e-9 * scale);
    assert!((turn * a.moment_N_m - b.moment_N_m).norm() < 1e-9 * scale);
}

/// A bit whose cutters face each other, turning on a flat bottom, is pushed straight up and held
/// back, and nothing else.
#[test]
fn a_symmetric_bit_on_a_flat_bottom() {
    let face = opposed().face().unwrap();
    let pose = Pose::new(Vector3::new(0.0, 0.0, 2e-3), Vector3::z(), Vector3::x(), 0.3)
        .moving(Vector3::new(0.0, 0.0, 1e-2), Vector3::new(0.0, 0.0, 10.0));
    let mut nodes = Nodes::default();
    let mut random = random(11);
    for _ in 0..20_000 {
        let (x, y) = (0.22 * random(), 0.22 * random());
        for side in [1.0, -1.0] {
            nodes.push(Vector3::new(side * x, side * y, 0.0), Vector3::zeros(), Vector3::zeros());
        }
    }
    let load = nodes.touch(&face, &pose, &law(), DT);
    let (up, torque) = (-load.force_N.z, -load.moment_N_m.z);
    assert!(load.touching > 100 && up > 100.0 && torque > 1.0, "{load:?}");
    assert!(load.force_N.xy().norm() < 1e-10 * up, "{load:?}");
    assert!(load.moment_N_m.xy().norm() < 1e-10 * up * 0.1, "{load:?}");
}

/// In front of the middle of a cutter's face, `depth` behind its surface, with the face's
/// directions: out and across.
fn on_a_face(face: &BitFace, depth: f64) -> [Vector3<f64>; 3] {
    let cutter = &face.cutters()[20];
    let up = (cutter.axis * cutter.axis.dot(&cutter.normal) - cutter.normal).normalize();
    let point = cutter.tip_m + up * (0.5 * pdc().cutter_diameter_m);
    let point = point - cutter.axis * ((point - cutter.tip_m).dot(&cutter.axis) + depth);
    // A chamfer of 0.4 mm puts the face that much before the tip.
    [point + cutter.axis * pdc().chamfer_m, cutter.axis, up]
}

/// A node pressed on a cutter by `P` and pulled along it by `T`: below `μ P` it stays where it is,
/// for ever; above, it goes at `(T − μ P)/m`.
#[test]
fn a_pressed_node_sticks_or_slides() {
    let face = pdc().face().unwrap();
    let pose = Pose::new(Vector3::zeros(), Vector3::z(), Vector3::x(), 0.0);
    let law = law();
    let press = 50.0;
    for share in [0.2, 0.99, 1.01, 2.0] {
        let [point, out, along] = on_a_face(&face, 0.0);
        let mut nodes = Nodes::default();
        nodes.push(point, Vector3::zeros(), Vector3::zeros());
        let mass = nodes.mass[0];
        let (settle, steps) = (4000, 1000);
        let mut start = (point, Vector3::zeros());
        for step in 0..settle + steps {
            let pull = if step < settle { 0.0 } else { share * law.friction * press };
            let force = along * pull - out * press;
            (0..3).for_each(|axis| nodes.force[axis][0] = force[axis]);
            if step == settle {
                start = (at(&nodes.position, 0), at(&nodes.velocity, 0));
                // It rests where the stiffness supports it.
                let depth = press / (law.stiffness_Pa_per_m * nodes.area[0]);
                let sunk = (point - start.0).dot(&out);
                assert!((sunk / depth - 1.0).abs() < 1e-6, "{sunk} {depth}");
            }
            let load = nodes.touch(&face, &pose, &law, DT);
            // Rounding, of losses of some 1e-9 J.
            assert!(load.friction_loss_J >= -1e-20);
            nodes.go(DT);
        }
        let speed = at(&nodes.velocity, 0).dot(&along);
        if share < 1.0 {
            assert!(speed.abs() < 1e-15, "{speed}");
            // Rounding of 1e-17 m a step.
            let moved = (at(&nodes.position, 0) - start.0).dot(&along);
            assert!(moved.abs() < 1e-13, "{moved}");
        } else {
            let expected = (share - 1.0) * law.friction * press / mass * DT * f64::from(steps);
            assert!((speed / expected - 1.0).abs() < 1e-6, "{speed} {expected}");
        }
    }
}

/// A node at rest inside is pushed out, and its energy with the contact's does not grow in any
/// step, however stiff or soft the contact and whether it damps.
#[test]
fn a_node_inside_is_pushed_out_without_gaining() {
    let face = pdc().face().unwrap();
    let pose = Pose::new(Vector3::zeros(), Vector3::z(), Vector3::x(), 0.0);
    for stiffness in [1e11, 5e12, 1e15, 1e18] {
        for damping_ratio in [0.0, 0.3, 1.0, 3.0] {
            let law = ContactLaw { stiffness_Pa_per_m: stiffness, damping_ratio, friction: 0.3 };
            let depth = 3e-4;
            let [point, out, _] = on_a_face(&face, depth);
            let mut nodes = Nodes::default();
            nodes.push(point, Vector3::zeros(), Vector3::zeros());
            let k = stiffness * nodes.area[0];
            let energy = |nodes: &Nodes| {
                let left = face.holds(at(&nodes.position, 0)).map_or(0.0, |t| t.depth_m);
                nodes.kinetic() + 0.5 * k * left * left
            };
            let first = energy(&nodes);
            assert!((first / (0.5 * k * depth * depth) - 1.0).abs() < 1e-9);
            let mut before = first;
            for _ in 0..3000 {
                nodes.touch(&face, &pose, &law, DT);
                nodes.go(DT);
                nodes.force = [vec![0.0], vec![0.0], vec![0.0]];
                let now = energy(&nodes);
                assert!(now <= before * (1.0 + 1e-9) + 1e-15 * first, "{stiffness} {before} {now}");
                before = now;
            }
            let sunk = depth - (at(&nodes.position, 0) - point).dot(&out);
            // An overdamped one creeps out by its slow root, √(k/m) (ζ − √(ζ² − 1)).
            assert!(sunk < 0.02 * depth, "{stiffness} {damping_ratio}: {sunk}");
        }
    }
}

/// A node that comes is stopped, not thrown back, in the step in which it arrives, by any
/// stiffness; a bit that comes takes the node along.
#[test]
fn arriving_is_not_bouncing() {
    let face = pdc().face().unwrap();
    let pose = Pose::new(Vector3::zeros(), Vector3::z(), Vector3::x(), 0.0);
    for stiffness in [1e11, 5e12, 1e15, 1e18, 1e22] {
        let law = ContactLaw { stiffness_Pa_per_m: stiffness, ..law() };
        for approach in [1e-3, 0.1, 10.0] {
            let [point, out, _] = on_a_face(&face, -0.4 * approach * DT);
            let mut nodes = Nodes::default();
            nodes.push(point, -out * approach, Vector3::zeros());
            assert_eq!(nodes.touch(&face, &pose, &law, DT).touching, 1);
            nodes.go(DT);
            let left = -at(&nodes.velocity, 0).dot(&out);
            assert!((-1e-12..=approach).contains(&left), "{stiffness} {approach}: {left}");

            let mut carried = Nodes::default();
            carried.push(point, Vector3::zeros(), Vector3::zeros());
            let coming = pose.moving(out * approach, Vector3::zeros());
            let load = carried.touch(&face, &coming, &law, DT);
            carried.go(DT);
            assert!((at(&carried.velocity, 0).dot(&out) + left - approach).abs() < 1e-9 * approach);
            assert!(load.work_on_bit_J < 0.0);
        }
    }
}

/// The pose's frame: `x` at the high side, `y` to its right, turning clockwise looking down; and
/// motion that turns a full circle comes back.
#[test]
fn poses() {
    // Straight ahead north, the high side is up and east is to the right.
    let pose = Pose::new(Vector3::zeros(), Vector3::x(), -Vector3::z(), 0.0);
    assert!((pose.to_rock(Vector3::x()) + Vector3::z()).norm() < 1e-15);
    assert!((pose.to_rock(Vector3::y()) - Vector3::y()).norm() < 1e-15);
    // A quarter turn clockwise takes the high side's mark to the right.
    let quarter =
        Pose::new(Vector3::zeros(), Vector3::x(), -Vector3::z(), std::f64::consts::FRAC_PI_2);
    assert!((quarter.to_rock(Vector3::x()) - Vector3::y()).norm() < 1e-15);
    let turning = pose.moving(Vector3::new(1.0, 0.0, 0.0), Vector3::x());
    let dt = std::f64::consts::FRAC_PI_2 / 1000.0;
    let end = (0..1000).fold(turning, |pose, _| pose.after(dt));
    assert!((end.rotation - quarter.rotation).norm() < 1e-12);
    assert!((end.position_m.x - 1000.0 * dt).abs() < 1e-12);
    let point = Vector3::new(0.1, -0.2, 0.05);
    assert!((end.to_bit(end.to_rock(point)) - point).norm() < 1e-15);
    // Down a vertical hole there is no high side.
    let down = Pose::new(Vector3::zeros(), Vector3::z(), -Vector3::z(), 0.0);
    assert!((down.rotation.determinant() - 1.0).abs() < 1e-15);
}
