//! A mesh refined at its contacts, warm starts, and strings that have no equilibrium.

use wholestring::{
    operation::OperationKind,
    prelude::*,
    sizing::{Accuracy, ElementLength, SizeReason},
    statics::stiff::{self, StiffError, StiffSettings},
    string::{ComponentLength, ComponentSpec, ToolJoints},
    well::Interpolation,
};

use crate::{
    common::{self, report_worst, verify},
    settings, solve,
};

/// Pipe without joints that builds to 60 deg at 5 deg/30 m and drops from there: it lies on the
/// high side of the build and of the drop's upper end, and on the low side elsewhere.
fn build_and_drop(friction: f64, bit_depth_m: f64) -> (Model, Operation) {
    let stations = [[0.0, 0.0, 0.0], [300.0, 0.0, 0.0], [660.0, 60.0, 0.0], [900.0, 20.0, 0.0]];
    let path = common::path(&stations, Interpolation::MinimumCurvature);
    let pipe =
        ComponentSpec::uniform("pipe", 0.127, 0.1086, ComponentLength::ToSurface, common::steel());
    let hole = common::open_hole(0.2159, friction, 900.0);
    let model = common::model(path, hole, vec![pipe], common::mud(1200.0), bit_depth_m);
    (model, Operation::trip_out(bit_depth_m))
}

fn auto(accuracy: Accuracy) -> StiffSettings {
    StiffSettings { element_length: ElementLength::Auto(accuracy), ..settings(1.0) }
}

/// Hook load, contact and bending of the mesh that finds its contacts, against elements of 0.4 m,
/// ten times as many: those of 0.2 m change hook load and contact by 2e-7. The rest is the
/// weight that is lumped where the pipe is on the wall, in elements of 9.6 m and of half of that.
/// Elements of 3 m, as many, miss the bending where the hole turns from build to drop by three
/// times as much.
#[test]
fn a_mesh_finds_its_contacts() {
    let (model, operation) = build_and_drop(0.3, 900.0);
    let fine = solve(&model, &operation, &settings(0.4));
    let even = solve(&model, &operation, &settings(3.0));
    let found = solve(&model, &operation, &auto(Accuracy::Standard));
    let finer = solve(&model, &operation, &auto(Accuracy::Fine));
    let mut rows = Vec::new();
    for (name, tolerance, found) in [("standard", 5e-4, &found), ("fine", 1e-4, &finer)] {
        let row = |what: &str, expected: f64, found: f64| {
            verify("stiff mesh", format!("{what} of the {name} mesh that finds its contacts, N"))
                .relative(tolerance, "elements of 0.4 m, converged to 2e-7")
                .row(expected, found)
        };
        rows.push(row("hook load", fine.scalars.hook_load_N, found.scalars.hook_load_N));
        let [fine_N, found_N] = [&fine, found].map(|profile| profile.scalars.side_force_total_N);
        rows.push(row("contact", fine_N, found_N));
    }
    report_worst(rows);
    assert!(found.convergence.elements <= even.convergence.elements, "{:?}", found.convergence);
    assert!(found.element_size.contains(&SizeReason::Refined));
    let largest_off_N_m = |profile: &stiff::StiffProfile| {
        let off = |node: usize| {
            let there = crate::nearest(&fine, profile.md_m[node]);
            (profile.bending_moment_N_m[node] - fine.bending_moment_N_m[there]).abs()
        };
        (0..profile.md_m.len()).map(off).fold(0.0, f64::max)
    };
    let [found_N_m, even_N_m] = [&found, &even].map(largest_off_N_m);
    assert!(2.0 * found_N_m < even_N_m, "{found_N_m} {even_N_m}");
    // The change by the last halving is as large as the error of the result.
    let error = found.convergence.mesh_error.expect("an estimate");
    assert!(found_N_m < 2.0 * error.bending_moment_N_m, "{found_N_m} {error:?}");
    assert_eq!(fine.convergence.mesh_error, None);
}

/// A warm start leads to the same equilibrium as a start from the middle of the hole, which is the
/// only one below the critical loads, in fewer steps: to the residual of the iterations, 1e-10.
#[test]
fn a_warm_start_ends_where_a_cold_one_does() {
    let (model, operation) = build_and_drop(0.3, 900.0);
    let (rougher, _) = build_and_drop(0.33, 900.0);
    let settings = settings(3.2);
    let near = stiff::equilibrium(&model, &operation, &settings).expect("an equilibrium");
    for operation in [operation, Operation::trip_in(900.0)] {
        let cold = solve(&rougher, &operation, &settings);
        let warm = stiff::equilibrium_near(&rougher, &operation, &settings, &near);
        let warm = warm.expect("an equilibrium");
        let iterations = warm.convergence().iterations;
        assert!(iterations < cold.convergence.iterations, "{iterations}");
        let warm = warm.profile(&rougher, &operation);
        let worst_N = warm.contact_force_N.iter().zip(&cold.contact_force_N);
        let worst_N = worst_N.map(|(warm_N, cold_N)| (warm_N - cold_N).abs()).fold(0.0, f64::max);
        let hook_N = (warm.scalars.hook_load_N - cold.scalars.hook_load_N).abs();
        assert!(hook_N < 1e-10 * cold.scalars.hook_load_N, "{hook_N}");
        assert!(worst_N < 1e-10 * cold.scalars.side_force_total_N, "{worst_N}");
    }
    // Deeper by a joint, the state moves down with the string.
    let (shorter, shallower) = build_and_drop(0.3, 890.4);
    let near = stiff::equilibrium(&shorter, &shallower, &settings).expect("an equilibrium");
    let warm = stiff::equilibrium_near(&model, &operation, &settings, &near).expect("one");
    let cold = solve(&model, &operation, &settings);
    let warm = warm.profile(&model, &operation);
    let hook_N = (warm.scalars.hook_load_N - cold.scalars.hook_load_N).abs();
    assert!(hook_N < 1e-10 * cold.scalars.hook_load_N, "{hook_N}");
}

/// 2000 m of level hole beyond the helix: the string locks up, and the error reports it. A smaller
/// push with less friction reaches the bit.
#[test]
fn a_string_that_locks_up_is_reported_as_such() {
    let solve = |friction: f64, weight_on_bit_N: f64| {
        let stations = [[0.0, 90.0, 0.0], [2000.0, 90.0, 0.0]];
        let path = common::path(&stations, Interpolation::MinimumCurvature);
        let pipe = ComponentSpec::uniform(
            "pipe",
            0.127,
            0.1086,
            ComponentLength::ToSurface,
            common::steel(),
        );
        let hole = common::open_hole(0.2159, friction, 2000.0);
        let model = common::model(path, hole, vec![pipe], common::mud(1200.0), 2000.0);
        let slide = Operation { weight_on_bit_N, ..Operation::slide(2000.0) };
        let settings = StiffSettings {
            element_length: ElementLength::Uniform(5.0),
            ..StiffSettings::default()
        };
        stiff::solve(&model, &slide, &settings)
    };
    let locked = solve(0.5, 300e3).expect_err("no equilibrium");
    let StiffError::LocksUp { md_m } = locked else { panic!("{locked}") };
    assert!((0.0..2000.0).contains(&md_m), "{md_m}");
    assert!(locked.to_string().contains("locks up at MD"), "{locked}");
    solve(0.3, 50e3).expect("an equilibrium");
}

/// 500 m of level hole under four times the sinusoidal load of the pipe: while it rotates, its
/// helix rolls around the hole, and the error reports it. While it slides, or rotates without
/// friction, it has an equilibrium.
#[test]
fn a_buckled_string_that_turns_rolls() {
    let solve = |friction: f64, operation: Operation| {
        let length_m = 500.0;
        let path = common::arcs(&[[0.0, 90.0, 0.0], [length_m, 90.0, 0.0]]);
        let pipe = ComponentSpec::uniform(
            "pipe",
            0.127,
            0.1086,
            ComponentLength::ToSurface,
            common::steel(),
        );
        let hole = common::open_hole(0.2159, friction, length_m);
        let model = common::model(path, hole, vec![pipe], common::mud(1200.0), length_m);
        let operation = Operation { weight_on_bit_N: 400e3, ..operation };
        stiff::solve(&model, &operation, &settings(4.0))
    };
    let drill = common::operation(OperationKind::Drill, 500.0);
    let rolls = solve(0.2, drill).expect_err("no equilibrium");
    let StiffError::Rolls { md_m, .. } = rolls else { panic!("{rolls}") };
    assert!((0.0..500.0).contains(&md_m), "{md_m}");
    for (friction, operation) in [(0.0, drill), (0.2, Operation::slide(500.0))] {
        let found = solve(friction, operation).expect("an equilibrium");
        assert!(found.convergence.stable, "{:?}", found.convergence);
    }
}

/// 500 m of level hole in elements of 12.2 m, which 82.8 kN buckle between their nodes
/// (`π² EI/h²`), pushed with 100 kN: the error names the element, the compression, which friction
/// brings to `100 kN + μ w L` at the top, and the length. With half of that length it is found.
#[test]
fn elements_of_a_length_that_buckles_between_its_nodes_are_named() {
    let path = common::arcs(&[[0.0, 90.0, 0.0], [500.0, 90.0, 0.0]]);
    let pipe =
        ComponentSpec::uniform("pipe", 0.127, 0.1086, ComponentLength::ToSurface, common::steel());
    let hole = common::open_hole(0.2159, 0.2, 500.0);
    let model = common::model(path, hole, vec![pipe], common::mud(1200.0), 500.0);
    let slide = Operation { weight_on_bit_N: 100e3, ..Operation::slide(500.0) };
    let solve = |length_m: f64| stiff::solve(&model, &slide, &settings(length_m));
    let buckles = solve(12.0).expect_err("no equilibrium");
    let StiffError::ElementBuckles { md_m, compression_N, length_m } = buckles else {
        panic!("{buckles}")
    };
    // Steel of 7850 kg/m3 in mud of 1200.
    let area_m2 = std::f64::consts::FRAC_PI_4 * (0.127_f64.powi(2) - 0.1086_f64.powi(2));
    let weight_N = (7850.0 - 1200.0) * area_m2 * wholestring::GRAVITY_M_PER_S2 * 500.0;
    let expected_N = 100e3 + 0.2 * weight_N;
    assert!((length_m - 500.0 / 41.0).abs() < 1e-9, "{length_m}");
    assert!(md_m < length_m, "{md_m}");
    assert!((compression_N / expected_N - 1.0).abs() < 0.02, "{compression_N} {expected_N}");
    assert!(buckles.to_string().contains("shorter elements are needed"), "{buckles}");
    assert!(solve(6.0).expect("an equilibrium").convergence.stable);
}

/// The cut-off does not jump with the mesh: where the string crosses from the high to the low side
/// of a shallow horizontal well it hangs free over some 40 m. Elements of 2 m to 9 m and those that
/// are found agree within 1.5 m; by the mean of their contacts alone they were 14 m apart.
#[test]
fn the_cutoff_does_not_jump_with_the_mesh() {
    let path = common::path(
        &[[0.0, 0.0, 0.0], [150.0, 0.0, 0.0], [600.0, 90.0, 0.0], [1100.0, 90.0, 0.0]],
        Interpolation::MinimumCurvature,
    );
    let pipe = ComponentSpec {
        joints: Some(ToolJoints { od_m: 0.168, spacing_m: 9.6 }),
        ..ComponentSpec::uniform("pipe", 0.127, 0.1086, ComponentLength::ToSurface, common::steel())
    };
    let hole = common::open_hole(0.2244, 0.25, 1100.0);
    let model = common::model(path, hole, vec![pipe], common::mud(1100.0), 1100.0);
    let operation = Operation::trip_out(1100.0);
    let cutoff_m = |settings: &StiffSettings| {
        let found = stiff::solve(&model, &operation, settings).expect("an equilibrium");
        found.scalars.cutoff_depth_m.expect("a cut-off")
    };
    let fine_m = cutoff_m(&settings(2.0));
    for length_m in [3.0, 4.0, 6.0, 9.0] {
        let found_m = cutoff_m(&settings(length_m));
        assert!((found_m - fine_m).abs() < 1.5, "{length_m}: {found_m} for {fine_m}");
    }
    let found_m = cutoff_m(&auto(Accuracy::Standard));
    assert!((found_m - fine_m).abs() < 1.5, "{found_m} for {fine_m}");
}

/// The same string under 72 kN in addition to friction: beyond `π² EI/h²`, 82.8 kN, but below the
/// `12 EI/h²` at which the chain of elements collapses. The equilibrium is reported with the
/// element that exceeds its own load most; elements of half that length do not buckle.
#[test]
fn an_equilibrium_with_an_element_beyond_its_own_load_is_reported() {
    let path = common::arcs(&[[0.0, 90.0, 0.0], [500.0, 90.0, 0.0]]);
    let pipe =
        ComponentSpec::uniform("pipe", 0.127, 0.1086, ComponentLength::ToSurface, common::steel());
    let hole = common::open_hole(0.2159, 0.2, 500.0);
    let model = common::model(path, hole, vec![pipe], common::mud(1200.0), 500.0);
    let slide = Operation { weight_on_bit_N: 72e3, ..Operation::slide(500.0) };
    let solve = |length_m| stiff::solve(&model, &slide, &settings(length_m)).expect("at rest");
    let found = solve(12.0);
    let element = found.convergence.buckled_element.expect("an element that buckles");
    assert!((element.own_load_N / 82.8e3 - 1.0).abs() < 1e-3, "{element:?}");
    assert!(element.compression_N > element.own_load_N, "{element:?}");
    assert_eq!(solve(6.0).convergence.buckled_element, None);
}
