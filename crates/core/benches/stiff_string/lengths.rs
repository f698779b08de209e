//! Time of a solution by the length of the string.

use std::time::Instant;

use wholestring::{
    operation::OperationKind,
    sizing::{Accuracy, ElementLength},
    statics::stiff::{self, StiffSettings},
    string::{ComponentLength, ComponentSpec, ToolJoints},
    well::Interpolation,
};

use crate::{
    HOLE_M,
    common::{model, mud, open_hole, operation, path, steel},
};

/// Lengths of the string, km.
const LENGTHS_KM: [f64; 5] = [1.0, 2.0, 4.0, 8.0, 15.0];

/// Number of solutions of each; the fastest counts.
const TIMES: usize = 5;

/// A build to 60 deg over a fifth of the length and a tangent, drill pipe with joints from end to
/// end, elements from joint to joint: pulled out, and turning off bottom.
pub fn lengths() {
    println!("length, km | elements | pulled: iterations, ms | turning: iterations, ms");
    for length_km in LENGTHS_KM {
        let length_m = 1e3 * length_km;
        let stations = [[0.0, 0.0, 0.0], [0.2 * length_m, 60.0, 0.0], [length_m, 60.0, 0.0]];
        let path = path(&stations, Interpolation::MinimumCurvature);
        let pipe = ComponentSpec::uniform(
            "drill pipe",
            0.127,
            0.1086,
            ComponentLength::ToSurface,
            steel(),
        );
        let joints = Some(ToolJoints { od_m: 0.165, spacing_m: 9.6 });
        let parts = vec![ComponentSpec { joints, ..pipe }];
        let model = model(path, open_hole(HOLE_M, 0.25, length_m), parts, mud(1200.0), length_m);
        let settings = StiffSettings {
            element_length: ElementLength::Auto(Accuracy::Coarse),
            ..StiffSettings::default()
        };
        let kinds = [OperationKind::TripOut, OperationKind::RotateOffBottom];
        let [pulled, turning] = kinds.map(|kind| {
            let operation = operation(kind, length_m);
            let solve = |_| {
                let begin = Instant::now();
                let found = stiff::solve(&model, &operation, &settings).expect("an equilibrium");
                (found.convergence, 1e3 * begin.elapsed().as_secs_f64())
            };
            let tries = (0..TIMES).map(solve);
            tries.min_by(|a, b| a.1.total_cmp(&b.1)).expect("one")
        });
        println!(
            "{length_km} | {} | {}, {:.1} | {}, {:.1}",
            pulled.0.elements, pulled.0.iterations, pulled.1, turning.0.iterations, turning.1
        );
    }
}
