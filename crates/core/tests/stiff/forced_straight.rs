//! A bend that its hole forces straight, against a planar beam between rigid walls.

use wholestring::{
    prelude::*,
    sizing::{Accuracy, ElementLength},
    statics::stiff::{self, StiffError, StiffProfile, StiffSettings},
    string::{BodyBend, ComponentLength, ComponentSpec},
};

use crate::{
    common::{self, report_worst, verify},
    nearest, pressed, settings, solve,
};

const HOLE_M: f64 = 0.2159;
const LENGTH_M: f64 = 120.0;
const INCLINATION_DEG: f64 = 42.0;
/// Distance of the bend from the bit, and its angle.
const BEND_M: f64 = 3.3;
const ANGLE_RAD: f64 = 10.0 * std::f64::consts::PI / 180.0;
/// Outside and inside diameter and upper end from the bit, m: of the motor, and of the pipe.
const MOTOR: [f64; 3] = [0.17145, 0.0762, 6.3];
const PIPE: [f64; 2] = [0.127, 0.1016];
const MUD_KG_PER_M3: f64 = 1100.0;

/// A shear modulus so large that shear is negligible, Pa.
const SHEAR_PA: f64 = 1e15;

/// Stiffness of a wall that 1 MN penetrates by a tenth of a millimetre, N/m.
const WALL_N_PER_M: f64 = 1e10;

/// A motor of 6.75 in with a bend of 10 deg half-way, below pipe of 5 in, in a straight hole of
/// 8.5 in.
fn string(friction: f64) -> Model {
    let path = common::arcs(&[[0.0, INCLINATION_DEG, 0.0], [LENGTH_M, INCLINATION_DEG, 0.0]]);
    let bend = BodyBend { from_lower_end_m: BEND_M, angle_rad: ANGLE_RAD, toolface_rad: 0.0 };
    let metres = ComponentLength::Metres;
    let tube = |[od_m, id_m]: [f64; 2], length| {
        let steel = Material { shear_modulus_Pa: SHEAR_PA, ..common::steel() };
        ComponentSpec::uniform("tube", od_m, id_m, length, steel)
    };
    let [od_m, id_m, top_m] = MOTOR;
    let parts = vec![
        ComponentSpec { bend: Some(bend), ..tube([od_m, id_m], metres(top_m)) },
        tube(PIPE, ComponentLength::ToSurface),
    ];
    let hole = common::open_hole(HOLE_M, friction, LENGTH_M);
    common::model(path, hole, parts, common::mud(MUD_KG_PER_M3), LENGTH_M)
}

/// Contact force of the bend, N.
fn bend_N(found: &StiffProfile) -> f64 {
    found.contact_force_N[nearest(found, LENGTH_M - BEND_M)]
}

/// Length of the planar beam, m.
const TOP_M: f64 = 60.0;

/// Steps in which its bend grows, and iterations of its contacts in each, at most.
const STEPS: u32 = 40;
const ITERATIONS: usize = 200;

/// A planar beam between rigid walls, in cubic elements of small slopes. The slope jumps by the
/// bend at its node, the bit is on the axis, the upper end is on the low side, and walls act at
/// nodes.
struct Planar {
    element_m: f64,
    /// Offset towards the high side, m, and slope above each node, from the bit up.
    unknowns: Vec<f64>,
}

/// Outside and inside diameter of the body at a distance from the bit, m.
fn body(from_bit_m: f64) -> [f64; 2] {
    if from_bit_m < MOTOR[2] { [MOTOR[0], MOTOR[1]] } else { PIPE }
}

fn stiffness_N_m2([od_m, id_m]: [f64; 2]) -> f64 {
    common::steel().youngs_modulus_Pa * std::f64::consts::PI / 64.0 * (od_m.powi(4) - id_m.powi(4))
}

/// Buoyed weight, N/m.
fn weight_N_per_m([od_m, id_m]: [f64; 2]) -> f64 {
    let area_m2 = std::f64::consts::FRAC_PI_4 * (od_m * od_m - id_m * id_m);
    (common::steel().density_kg_per_m3 - MUD_KG_PER_M3) * area_m2 * wholestring::GRAVITY_M_PER_S2
}

impl Planar {
    fn solve(element_m: f64) -> Self {
        let elements = (TOP_M / element_m).round() as usize;
        let mut beam = Self { element_m, unknowns: vec![0.0; 2 * (elements + 1)] };
        for step in 1..=STEPS {
            let angle_rad = ANGLE_RAD * f64::from(step) / f64::from(STEPS);
            for _ in 0..ITERATIONS {
                let before = beam.touches();
                beam.unknowns = beam.next(angle_rad, &before);
                if beam.touches() == before {
                    break;
                }
            }
        }
        beam
    }

    fn elements(&self) -> usize {
        self.unknowns.len() / 2 - 1
    }

    fn bend_node(&self) -> usize {
        (BEND_M / self.element_m).round() as usize
    }

    fn middle_m(&self, element: usize) -> f64 {
        (element as f64 + 0.5) * self.element_m
    }

    fn clearance_m(&self, node: usize) -> f64 {
        0.5 * (HOLE_M - body(node as f64 * self.element_m)[0])
    }

    /// Penetration of a node into the wall, m.
    fn beyond_m(&self, node: usize) -> f64 {
        self.unknowns[2 * node].abs() - self.clearance_m(node)
    }

    fn touches(&self) -> Vec<bool> {
        let last = self.elements();
        (0..=last).map(|node| node > 0 && node < last && self.beyond_m(node) > 0.0).collect()
    }

    /// The beam with walls at the nodes that touch. Rows hold the diagonal and three to either
    /// side.
    fn next(&self, angle_rad: f64, touches: &[bool]) -> Vec<f64> {
        let (sine, cosine) = INCLINATION_DEG.to_radians().sin_cos();
        let (h, size) = (self.element_m, self.unknowns.len());
        let (mut rows, mut right) = (vec![[0.0; 7]; size], vec![0.0; size]);
        let mut below_N = 0.0;
        for element in 0..self.elements() {
            let section = body(self.middle_m(element));
            let (ei, w) = (stiffness_N_m2(section), weight_N_per_m(section));
            let tension_N = below_N + 0.5 * w * cosine * h;
            below_N += w * cosine * h;
            let matrix = element_matrix(ei / (h * h * h), tension_N / (30.0 * h), h);
            let q = -w * sine;
            let load = [0.5 * q * h, q * h * h / 12.0, 0.5 * q * h, -q * h * h / 12.0];
            // The element below the bend has a slope there that is larger by the angle.
            let jump = if element + 1 == self.bend_node() { angle_rad } else { 0.0 };
            for (a, entries) in matrix.iter().enumerate() {
                let row = 2 * element + a;
                right[row] += load[a] - entries[3] * jump;
                for (b, value) in entries.iter().enumerate() {
                    rows[row][3 + b - a] += value;
                }
            }
        }
        rows[0][3] += WALL_N_PER_M;
        for node in (0..touches.len()).filter(|node| touches[*node]) {
            let wall_m = self.clearance_m(node).copysign(self.unknowns[2 * node]);
            rows[2 * node][3] += WALL_N_PER_M;
            right[2 * node] += WALL_N_PER_M * wall_m;
        }
        for (row, value) in [(size - 2, -self.clearance_m(self.elements())), (size - 1, 0.0)] {
            rows[row] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
            right[row] = value;
        }
        banded(&mut rows, &mut right)
    }

    /// Contact force of the bend, N.
    fn bend_N(&self) -> f64 {
        WALL_N_PER_M * self.beyond_m(self.bend_node())
    }

    /// The largest bending moment, N·m.
    fn largest_N_m(&self) -> f64 {
        let h = self.element_m;
        let moments = (0..self.elements()).flat_map(|element| {
            let jump = if element + 1 == self.bend_node() { ANGLE_RAD } else { 0.0 };
            let [y1, s1, y2, s2] = [0, 1, 2, 3].map(|k| self.unknowns[2 * element + k]);
            let (rise, s2) = (6.0 * (y2 - y1), s2 + jump);
            let ei = stiffness_N_m2(body(self.middle_m(element))) / (h * h);
            [rise - h * (4.0 * s1 + 2.0 * s2), h * (2.0 * s1 + 4.0 * s2) - rise]
                .map(|part| (ei * part).abs())
        });
        moments.fold(0.0, f64::max)
    }
}

/// Stiffness of a cubic element of length `h`: `EI/h³` times that of bending, and `T/30h` times
/// that of tension.
fn element_matrix(bending: f64, tension: f64, h: f64) -> [[f64; 4]; 4] {
    let of_bending = [
        [12.0, 6.0 * h, -12.0, 6.0 * h],
        [6.0 * h, 4.0 * h * h, -6.0 * h, 2.0 * h * h],
        [-12.0, -6.0 * h, 12.0, -6.0 * h],
        [6.0 * h, 2.0 * h * h, -6.0 * h, 4.0 * h * h],
    ];
    let of_tension = [
        [36.0, 3.0 * h, -36.0, 3.0 * h],
        [3.0 * h, 4.0 * h * h, -3.0 * h, -h * h],
        [-36.0, -3.0 * h, 36.0, -3.0 * h],
        [3.0 * h, -h * h, -3.0 * h, 4.0 * h * h],
    ];
    std::array::from_fn(|a| {
        std::array::from_fn(|b| bending * of_bending[a][b] + tension * of_tension[a][b])
    })
}

/// Solves a system of three diagonals to either side of the main one.
fn banded(rows: &mut [[f64; 7]], right: &mut [f64]) -> Vec<f64> {
    let size = right.len();
    for pivot in 0..size {
        let last = (pivot + 4).min(size);
        for below in pivot + 1..last {
            let part = rows[below][3 + pivot - below] / rows[pivot][3];
            for column in pivot..last {
                rows[below][3 + column - below] -= part * rows[pivot][3 + column - pivot];
            }
            right[below] -= part * right[pivot];
        }
    }
    let mut found = vec![0.0; size];
    for row in (0..size).rev() {
        let above = row + 1..(row + 4).min(size);
        let sum: f64 = above.map(|column| rows[row][3 + column - row] * found[column]).sum();
        found[row] = (right[row] - sum) / rows[row][3];
    }
    found
}

/// Contact force of the bend and the largest moment against the planar beam, of which elements of
/// 0.05 and 0.025 m differ by less than 2e-4: 1232 kN and 966 kN·m. Slopes of 5 deg, which the
/// planar beam takes for small, are worth 0.5 % and 0.7 %: this difference remains with elements of
/// 0.05 m. Lengths of 3.2, 1.6, 0.8, 0.4, 0.2 and 0.1 m give 307, 1074, 1076, 1233, 1222 and 1226
/// kN: the body touches 1.4 m below the bend and 1.6 m above it, between the nodes of the longer
/// ones. The default mesh cuts the elements whose body bulges through the wall.
#[test]
fn a_bend_that_its_hole_forces_straight() {
    let [coarser, beam] = [0.05, 0.025].map(Planar::solve);
    assert!((coarser.bend_N() / beam.bend_N() - 1.0).abs() < 5e-4, "{}", coarser.bend_N());
    let (model, operation) = (string(0.0), pressed(LENGTH_M, 0.0));
    let auto =
        |accuracy| StiffSettings { element_length: ElementLength::Auto(accuracy), ..settings(1.0) };
    let mut rows = Vec::new();
    for (name, settings) in [
        ("of 0.4 m", settings(0.4)),
        ("of 0.2 m", settings(0.2)),
        ("of 0.1 m", settings(0.1)),
        ("of the default mesh", auto(Accuracy::Standard)),
        ("of the fine mesh", auto(Accuracy::Fine)),
    ] {
        let found = solve(&model, &operation, &settings);
        let largest_N_m = found.bending_moment_N_m.iter().copied().fold(0.0, f64::max);
        let reason = "slopes of 5 deg are not small: 0.7 %";
        let row = |quantity: &str, expected: f64, found: f64| {
            verify("a bend forced straight", format!("{quantity} with elements {name}"))
                .relative(1.5e-2, reason)
                .row(expected, found)
        };
        rows.push(row("contact force of the bend in N", beam.bend_N(), bend_N(&found)));
        rows.push(row("largest moment in N·m", beam.largest_N_m(), largest_N_m));
    }
    report_worst(rows);
}

/// The same string with friction and 50 kN on the bit. Rotated, it has the contact force of the
/// bend without friction but for the weight on bit, which is 4 % of that force: next to no friction
/// holds back the push, so that it does not lock up. One that slides does, because the friction of
/// the bend, 0.3 of 1.2 MN, exceeds its weight of 20 kN.
#[test]
fn a_bend_that_its_hole_forces_straight_does_not_lock_up_a_string_that_rotates() {
    let (model, friction_less) = (string(0.3), string(0.0));
    for element_m in [0.4, 0.2, 0.1] {
        let settings = settings(element_m);
        let still = solve(&friction_less, &pressed(LENGTH_M, 0.0), &settings);
        let drill = common::pressing(OperationKind::Drill, LENGTH_M, 50e3);
        let turning = solve(&model, &drill, &settings);
        let ratio = bend_N(&turning) / bend_N(&still);
        assert!((ratio - 1.0).abs() < 0.05, "{element_m} m: {ratio}");
        let slides = stiff::solve(&model, &pressed(LENGTH_M, 50e3), &settings);
        let locks_up =
            matches!(slides, Err(StiffError::LocksUp { .. } | StiffError::RunsAway { .. }));
        assert!(locks_up, "{element_m} m: {:?}", slides.map(|found| found.convergence));
    }
}
