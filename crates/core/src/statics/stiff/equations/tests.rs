//! The tangent of a chain of elements.

use super::*;
use crate::{
    common::{along, mud},
    operation::Operation,
    random::Random,
    rod::mesh::Mesh,
    statics::{soft::soft_string, stiff::StiffSettings},
    string::{BodyBend, ComponentLength, ComponentSpec},
};

/// A string of eleven elements with a bend, off its axis and turned by a few degrees.
fn bent_string() -> (StringInHole, State) {
    let pipe = |length| ComponentSpec { bend: None, ..crate::common::pipe(300.0, 0.06, length) };
    let motor = ComponentSpec {
        bend: Some(BodyBend { from_lower_end_m: 3.0, angle_rad: 0.04, toolface_rad: 0.7 }),
        ..pipe(ComponentLength::Metres(9.0))
    };
    let stations = [[0.0, 10.0, 20.0], [30.0, 16.0, 31.0]];
    let parts = vec![motor, pipe(ComponentLength::ToSurface)];
    let model = along(&stations, 0.2, parts, mud(0.0));
    let operation = Operation::trip_out(30.0);
    let soft = soft_string(&model, &operation).expect("a soft string");
    let mesh = Mesh::uniform(&model.string, 3.0);
    let mut string = StringInHole::new(&model, &operation, &StiffSettings::default(), &mesh, &soft);
    string.hang(|_| false);
    let mut state = State::centred(&string);
    let mut random = Random::new(5);
    let step: Vec<Entry> = (0..string.nodes.len())
        .map(|_| Entry::from_fn(|row, _| random.signed() * if row < 3 { 2e-3 } else { 0.05 }))
        .collect();
    state.advance(&step, 1.0);
    (string, state)
}

/// Sets the tensions to those of the shape.
fn fit(string: &StringInHole, state: &mut State) {
    for (index, element) in string.elements.iter().enumerate() {
        let directors = [element.seen(&state.heading[index]), state.heading[index + 1].along];
        let ends = Ends { chord_m: state.chord_m(string, index), directors };
        let longer_m = ends.longer_m(&element.stiffness) - element.slack_m;
        state.tension_N[index] = element.stiffness.axial * longer_m;
    }
}

/// The matrix is the derivative of the forces, by central differences: as their step is halved, the
/// remaining error falls by four down to rounding at 2e-7 of the largest entry of a row. With a
/// torque the change of `1/(1 + c12)` is left out, 1e-4 of it.
#[test]
fn the_tangent_is_exact() {
    let (string, mut state) = bent_string();
    fit(&string, &mut state);
    let nodes = string.nodes.len();
    for (torque, tolerance) in [(None, 1e-6), (Some(vec![2e4; nodes - 1]), 1e-4)] {
        let forces = |state: &State| {
            let mut equations = Equations::new(nodes);
            equations.assemble(&string, state, torque.as_deref());
            equations
        };
        let matrix = forces(&state).matrix;
        let bent =
            string.elements.iter().position(|element| element.bend.is_some()).expect("a bend");
        let mut changes = Tridiagonal::zeros(nodes);
        for (node, unknown) in (1..nodes).flat_map(|node| (0..5).map(move |k| (node, k))) {
            let size = if unknown < 3 { 1e-6 } else { 1e-5 };
            let moved = |by: f64| {
                let mut step = vec![Entry::zeros(); nodes];
                step[node][unknown] = by;
                let mut there = state.clone();
                there.advance(&step, 1.0);
                fit(&string, &mut there);
                forces(&there).force
            };
            let (ahead, behind) = (moved(size), moved(-size));
            let change = |row: usize| (behind[row] - ahead[row]) / (2.0 * size);
            changes.upper[node - 1].set_column(unknown, &change(node - 1));
            changes.diagonal[node].set_column(unknown, &change(node));
            if node + 1 < nodes {
                changes.lower[node].set_column(unknown, &change(node + 1));
            }
        }
        // A director that is rotated about two axes one after the other is also rotated about
        // itself. The effect of this with a bend's moment is no part of a symmetric matrix.
        let own = changes.diagonal[bent].fixed_view::<2, 2>(3, 3).into_owned();
        let symmetric = (own + own.transpose()) * 0.5;
        changes.diagonal[bent].fixed_view_mut::<2, 2>(3, 3).copy_from(&symmetric);
        let mut worst = 0.0_f64;
        let mut compare = |row: usize, found: &Block, change: &Block| {
            for k in 0..5 {
                let scale = matrix.diagonal[row].row(k).amax();
                worst = worst.max((found.row(k) - change.row(k)).amax() / scale);
            }
        };
        for row in 1..nodes {
            compare(row, &matrix.diagonal[row], &changes.diagonal[row]);
            if row + 1 < nodes {
                compare(row, &matrix.upper[row], &changes.upper[row]);
                compare(row + 1, &matrix.lower[row], &changes.lower[row]);
            }
        }
        println!("{worst:.1e}");
        assert!(worst < tolerance, "{worst:e}");
    }
}
