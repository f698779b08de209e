//! Natural frequencies of the string of a case, as eigenvalues of the mesh and the masses that its
//! run would use: `natural_frequencies CASE.toml [KEY=VALUE...]` prints them as JSON. The string is
//! held axially only by the hoist and in rotation only by the top drive; laterally, a span of three
//! joints of pipe is pinned at its ends, without tension.

use std::{env, f64::consts::TAU, path::Path, process::ExitCode};

use serde_json::json;
use wholestring::{
    dynamics::Effort,
    rod::{element::Stiffness, stability::Subcycling},
};
use wholestring_case::Override;

/// Number of frequencies of each motion.
const COUNT: usize = 3;

/// Stiffness of a rigid support, over the largest stiffness of the chain.
const HELD: f64 = 1e9;

/// Distance of the span from the bit, m: ordinary pipe in every case.
const SPAN_FROM_BIT_M: f64 = 500.0;

/// Length of the span in joints, and the length of a joint, m, of pipe without joints.
const JOINTS: f64 = 3.0;
const PLAIN_JOINT_M: f64 = 9.6;

/// A symmetric banded stiffness matrix of a chain, its diagonal and up to three off-diagonals, and
/// masses.
struct Chain {
    rows: Vec<[f64; 4]>,
    masses: Vec<f64>,
}

impl Chain {
    fn new(unknowns: usize) -> Self {
        Self { rows: vec![[0.0; 4]; unknowns], masses: vec![0.0; unknowns] }
    }

    /// Adds a stiffness between two unknowns, each way.
    fn add(&mut self, i: usize, j: usize, stiffness: f64) {
        self.rows[i.min(j)][i.abs_diff(j)] += stiffness;
    }

    fn hold(&mut self, unknown: usize) {
        let largest = self.rows.iter().map(|row| row[0]).fold(0.0, f64::max);
        self.add(unknown, unknown, HELD * largest);
    }

    /// Number of eigenvalues below this one, 1/s²: the number of negative pivots (Sylvester's law).
    fn below(&self, eigenvalue: f64) -> usize {
        let mut rows = self.rows.clone();
        for (row, mass) in rows.iter_mut().zip(&self.masses) {
            row[0] -= eigenvalue * mass;
        }
        let mut negative = 0;
        for i in 0..rows.len() {
            let [pivot, beside @ ..] = rows[i];
            negative += usize::from(pivot < 0.0);
            for (a, first) in beside.iter().enumerate().take(rows.len() - 1 - i) {
                for (b, second) in beside.iter().enumerate().skip(a) {
                    rows[i + 1 + a][b - a] -= first * second / pivot;
                }
            }
        }
        negative
    }

    /// The lowest frequencies, Hz.
    fn lowest_Hz(&self) -> Vec<f64> {
        let modes = 0..COUNT.min(self.rows.len());
        modes
            .map(|mode| {
                let (mut low, mut high) = (0.0, 1.0);
                while self.below(high) <= mode {
                    high *= 4.0;
                }
                for _ in 0..80 {
                    let middle = 0.5 * (low + high);
                    if self.below(middle) <= mode {
                        low = middle;
                    } else {
                        high = middle;
                    }
                }
                (0.5 * (low + high)).sqrt() / TAU
            })
            .collect()
    }
}

/// Axial and torsional motion: held at the top, free at the bit.
fn along_and_about(effort: &Effort) -> [Chain; 2] {
    let nodes = effort.mesh.nodes.len();
    let mut chains = [Chain::new(nodes), Chain::new(nodes)];
    let elements = effort.mesh.elements.iter().zip(&effort.plan.inertia);
    for (i, (element, inertia)) in elements.enumerate() {
        let stiffnesses = Stiffness::new(&element.section, element.length_m);
        let each =
            [(stiffnesses.axial, inertia.axial_kg), (stiffnesses.twist, inertia.polar_kg_m2)];
        for (chain, (stiffness, mass)) in chains.iter_mut().zip(each) {
            chain.add(i, i, stiffness);
            chain.add(i + 1, i + 1, stiffness);
            chain.add(i, i + 1, -stiffness);
            chain.masses[i] += 0.5 * mass;
            chain.masses[i + 1] += 0.5 * mass;
        }
    }
    if let Some(Subcycling { border_node, axial_kg, polar_kg_m2, .. }) = effort.plan.subcycling {
        chains[0].masses[border_node + 1] += axial_kg;
        chains[1].masses[border_node + 1] += polar_kg_m2;
    }
    for chain in &mut chains {
        chain.hold(0);
    }
    chains
}

/// Lateral motion of a span of pipe between two nodes, pinned at both; deflection and angle of each
/// node.
fn across(effort: &Effort, upper: usize, lower: usize) -> Chain {
    let mut chain = Chain::new(2 * (lower - upper + 1));
    for i in upper..lower {
        let (element, inertia) = (&effort.mesh.elements[i], &effort.plan.inertia[i]);
        let stiffnesses = Stiffness::new(&element.section, element.length_m);
        let (near, far) = (stiffnesses.bending_near(), stiffnesses.bending_far);
        // Angles relative to the chord from deflections and angles.
        let chord = 1.0 / element.length_m;
        let [first, second] = [[chord, 1.0, -chord, 0.0], [chord, 0.0, -chord, 1.0]];
        let start = 2 * (i - upper);
        for a in 0..4 {
            for b in a..4 {
                let alike = first[a] * first[b] + second[a] * second[b];
                let crossed = first[a] * second[b] + second[a] * first[b];
                chain.add(start + a, start + b, near * alike + far * crossed);
            }
            let rotary = inertia.rotary_kg_m2;
            chain.masses[start + a] += if a % 2 == 0 { 0.5 * inertia.lateral_kg } else { rotary };
        }
    }
    chain.hold(0);
    chain.hold(2 * (lower - upper));
    chain
}

fn main() -> ExitCode {
    match frequencies() {
        Ok(text) => {
            println!("{text}");
            ExitCode::SUCCESS
        }
        Err(reason) => {
            eprintln!("{reason}");
            ExitCode::FAILURE
        }
    }
}

fn frequencies() -> Result<String, String> {
    let mut arguments = env::args().skip(1);
    let path = arguments.next().ok_or("usage: natural_frequencies CASE.toml [KEY=VALUE...]")?;
    let overrides: Result<Vec<Override>, _> = arguments.map(|one| one.parse()).collect();
    let overrides = overrides.map_err(|error| error.to_string())?;
    let case = wholestring_case::load(Path::new(&path), &overrides)
        .map_err(|report| report.render(false))?;
    let operation = case.operations.first().ok_or("the case has no operation")?;
    let effort =
        Effort::of(&case.model, operation, &case.dynamics).map_err(|error| error.to_string())?;
    let nodes = &effort.mesh.nodes;
    let nearest = |from_bit_m: f64| {
        let apart = |i: &usize| (nodes[*i].from_bit_m - from_bit_m).abs();
        (0..nodes.len()).min_by(|a, b| apart(a).total_cmp(&apart(b))).unwrap_or(0)
    };
    // Between joints, which are nodes of every mesh.
    let from_bit_m = SPAN_FROM_BIT_M.min(0.5 * operation.bit_depth_m);
    let span = case.model.string.spans().find(|span| span.to_bit_m > from_bit_m);
    let span = span.ok_or("the string is too short")?;
    let spacing_m = span.component.joints.map_or(PLAIN_JOINT_M, |joints| joints.spacing_m);
    let first = ((from_bit_m - span.from_bit_m) / spacing_m).ceil();
    let lower_m = span.from_bit_m + first * spacing_m;
    let (lower, upper) = (nearest(lower_m), nearest(lower_m + JOINTS * spacing_m));
    let [along, about] = along_and_about(&effort);
    let answer = json!({
        "elements": effort.mesh.elements.len(),
        "axial_Hz": along.lowest_Hz(),
        "torsional_Hz": about.lowest_Hz(),
        "lateral_Hz": across(&effort, upper, lower).lowest_Hz(),
        "span_m": nodes[upper].from_bit_m - nodes[lower].from_bit_m,
    });
    Ok(answer.to_string())
}
