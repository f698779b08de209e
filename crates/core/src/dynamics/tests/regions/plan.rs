//! Position of the border in a plan, and its steps.

use super::{LONG_M, mesh_of, model_of};
use crate::{
    dynamics::assemble::chain,
    rod::{
        element::Stiffness,
        regions,
        stability::{self, Motion, StepPlan},
    },
};

/// None: the limits of elements are then as their lengths.
const BETA_S: f64 = 0.0;

fn plan(lengths_m: &[f64], highest_lower: usize) -> StepPlan {
    let model = model_of(lengths_m);
    let mesh = mesh_of(&model, lengths_m);
    let lateral = chain::lateral_mass_kg_per_m(&model, &mesh, mesh.length_m());
    regions::plan(&mesh, &lateral, BETA_S, highest_lower)
}

fn plan_of_one(lengths_m: &[f64]) -> StepPlan {
    let model = model_of(lengths_m);
    let mesh = mesh_of(&model, lengths_m);
    let lateral = chain::lateral_mass_kg_per_m(&model, &mesh, mesh.length_m());
    stability::plan(&mesh, &lateral, BETA_S)
}

/// So many ordinary elements, and below them so many short ones.
fn lengths(long: usize, short: usize, short_m: f64) -> Vec<f64> {
    [vec![LONG_M; long], vec![short_m; short]].concat()
}

/// The border leaves three ordinary elements above the first short one, the upper region takes the
/// step of ordinary pipe and the lower one a whole fraction of it within its own limit: short
/// elements of a third take three. The inertia that the coupling lacks is `EA/L DT²/12 (1 − 1/M²)`,
/// and as much of `GJ/L`.
#[test]
fn the_border_lies_three_elements_above_the_first_short_one() {
    let lengths = lengths(100, 60, LONG_M / 3.0);
    let plan = plan(&lengths, usize::MAX);
    let found = plan.subcycling.expect("regions");
    assert_eq!((found.border_node, found.parts), (100 - 1 - 3, 3));
    let pipe = plan_of_one(&vec![LONG_M; 100]);
    assert!((plan.dt_s / pipe.dt_s - 1.0).abs() < 1e-6, "{} {}", plan.dt_s, pipe.dt_s);
    assert!(plan.added_axial_mass_fraction <= 0.003, "{plan:?}");

    let model = model_of(&lengths);
    let mesh = mesh_of(&model, &lengths);
    let k = Stiffness::new(&mesh.elements[found.border_node].section, LONG_M);
    let beside = plan.dt_s * plan.dt_s / 12.0 * (8.0 / 9.0);
    assert!((found.axial_kg / (k.axial * beside) - 1.0).abs() < 1e-12);
    assert!((found.polar_kg_m2 / (k.twist * beside) - 1.0).abs() < 1e-12);
}

/// No regions where all elements are alike, where nearly all are short, and where the loads on the
/// body leave no room above it; a border higher up where that suffices.
#[test]
fn a_string_is_divided_where_that_pays_and_nowhere_else() {
    let long = lengths(160, 0, LONG_M);
    assert_eq!(plan(&long, usize::MAX), plan_of_one(&long));
    let short = lengths(20, 300, LONG_M / 3.0);
    assert_eq!(plan(&short, usize::MAX), plan_of_one(&short));
    let both = lengths(100, 20, LONG_M / 3.0);
    assert_eq!(plan(&both, 9), plan_of_one(&both));
    let border = |highest| plan(&both, highest).subcycling.map(|s| s.border_node);
    assert_eq!([usize::MAX, 98, 97, 60].map(border), [96, 96, 95, 58].map(Some));
}

/// Limits of the steps: the pipe's own speed of sound, and below, for one element of a metre to
/// which mass but no polar inertia can be added, its torsion, `L √(ρJ/GJ)` but for the last
/// hundredth.
#[test]
fn the_plan_says_which_element_holds_each_step() {
    let mut lengths = lengths(200, 40, LONG_M / 3.0);
    lengths[220] = 1.0;
    let plan = plan(&lengths, usize::MAX);
    let found = plan.subcycling.expect("regions");
    let (upper, lower) = (plan.holder.expect("a holder"), found.holder.expect("a holder"));
    assert_eq!(upper.motion, Motion::Axial);
    assert!(upper.element <= found.border_node);
    assert_eq!((lower.element, lower.motion), (220, Motion::Torsion));
    let own_s = 0.99 / 3178.35;
    let dt_s = plan.shortest_s();
    // `M` steps in one of the pipe may be a little shorter each.
    let most = 1.0 / f64::from(found.parts);
    assert!(dt_s < own_s && dt_s > own_s * (1.0 - most), "{dt_s} {own_s}");
}
