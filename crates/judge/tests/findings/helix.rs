//! A helix that is pushed down, on two meshes of the stiff string.

use wholestring::{
    operation::OperationKind::{Slide, TripOut},
    statics::stiff::{self, FinerHelix, StiffSettings},
};
use wholestring_judge::{CheckKind, Judge, Severity};

use crate::judged::{at_full_depth, five_inch, none, only};

/// A lateral in which the string slides as a helix: the two meshes agree, and nothing is reported.
/// Two that differ by more than 2 % of the drag, or a finer one without an equilibrium, are. Beside
/// a solution of the finer mesh, its hook load is set by hand: the limit is that of the definition.
#[test]
fn a_helix_is_reported_where_another_mesh_changes_it() {
    let stations = [[0.0, 0.0, 0.0], [500.0, 0.0, 0.0], [1175.0, 90.0, 0.0], [2000.0, 90.0, 0.0]];
    let model = five_inch(&stations, 0.2159, 0.3, 222.0);
    let slide = at_full_depth(Slide, &model, 40e3);
    let mut solved = stiff::solve(&model, &slide, &StiffSettings::default()).expect("a helix");
    let finer = solved.convergence.finer_helix.expect("it is pushed down as a helix");
    let (hook_load_N, drag_N) = (solved.scalars.hook_load_N, solved.scalars.axial_friction_N.abs());
    let off_N = (finer.hook_load_N.expect("an answer") - hook_load_N).abs();
    assert!(off_N > 0.0 && off_N < 0.02 * drag_N, "{off_N} of {drag_N}");
    none(&Judge::default().stiff(&model, &slide, &solved).checks, CheckKind::HelixNotResolved);

    let mut with = |hook_load_N: Option<f64>| {
        solved.convergence.finer_helix = Some(FinerHelix { hook_load_N });
        let found = Judge::default().stiff(&model, &slide, &solved).checks;
        only(&found, CheckKind::HelixNotResolved)
    };
    assert_eq!(with(Some(hook_load_N + 0.019 * drag_N)), None);
    for finer_N in [Some(hook_load_N - 0.021 * drag_N), None] {
        let check = with(finer_N).expect("a warning");
        assert_eq!((check.severity, check.value), (Severity::Warning, Some(hook_load_N)));
        assert_eq!(check.limit, finer_N);
        let words = if finer_N.is_some() { "and is " } else { "and is not found" };
        assert!(check.sentence.contains(words), "{}", check.sentence);
    }

    let trip = at_full_depth(TripOut, &model, 0.0);
    let pulled = stiff::solve(&model, &trip, &StiffSettings::default()).expect("an answer");
    assert_eq!(pulled.convergence.finer_helix, None);
}
