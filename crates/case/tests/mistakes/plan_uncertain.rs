//! Mistakes in `[plan.uncertain]`.

use wholestring_plan::{Statics, uncertainty::Distribution};

use crate::{
    common::{change::rows, read},
    plan::{accepted, planned},
    refused, warned,
};

/// The plan with these inputs.
fn with(inputs: &str) -> String {
    planned(&format!("uncertain = {{ input = [{inputs}] }}"))
}

#[test]
fn inputs() {
    let cases = rows(
        r#"
        uncertain_key_unknown: `{ key = "mud.densty", from = "1.1 sg", to = "1.3 sg" }`
        uncertain_key_of_no_table: `{ key = "weight", from = 1, to = 2 }`
        uncertain_key_of_no_item: `{ key = "well.hole.2.friction", from = 0.1, to = 0.3 }`
        uncertain_key_of_words: `{ key = "operation.kind", from = 1, to = 2 }`
        uncertain_key_of_a_table: `{ key = "mud", from = 1, to = 2 }`
        uncertain_key_of_itself: `{ key = "plan.uncertain.samples", from = 100, to = 200 }`
        uncertain_key_missing: `{ from = 0.1, to = 0.3 }`
        uncertain_key_misspelt: `{ key = "friction", form = 0.1, to = 0.3 }`
        uncertain_how_missing: `{ key = "friction" }`
        uncertain_to_missing: `{ key = "friction", from = 0.1 }`
        uncertain_two_forms: `{ key = "friction", from = 0.1, to = 0.3, values = [0.2, 0.3] }`
        uncertain_range_empty: `{ key = "friction", from = 0.3, to = 0.3 }`
        uncertain_mode_outside: `{ key = "friction", from = 0.1, to = 0.3, mode = 0.4 }`
        uncertain_deviation_zero: `{ key = "friction", mean = 0.3, std = 0 }`
        uncertain_all_cut_off: `{ key = "friction", mean = 0.3, std = 0.01, from = 0.5 }`
        uncertain_median_zero: `{ key = "friction", median = 0, factor = 1.2 }`
        uncertain_factor_one: `{ key = "friction", median = 0.3, factor = 1 }`
        uncertain_factor_below_one: `{ key = "friction", median = 0.3, factor = 0.5 }`
        uncertain_one_value: `{ key = "dynamics.seed", values = [1] }`
        uncertain_values_as_number: `{ key = "dynamics.seed", values = 7 }`
        uncertain_value_as_list: `{ key = "dynamics.seed", values = [[1, 2], 3] }`
        uncertain_value_twice: `{ key = "friction", values = [0.2, 0.3, 0.2] }`
        uncertain_values_without_a_step: `{ key = "dynamics.seed", values = "1..100" }`
        uncertain_amount_as_list: `{ key = "friction", from = [0.1], to = 0.3 }`
        uncertain_amount_in_fractions: `{ key = "string.0.od", from = "8-1/4 in", to = "9 in" }`
        uncertain_amount_as_word: `{ key = "friction", from = "little", to = 0.3 }`
        uncertain_amount_infinite: `{ key = "friction", from = 0.1, to = inf }`
        uncertain_two_units: `{ key = "mud.density", from = "1.1 sg", to = "10 ppg" }`
        uncertain_unit_of_another_kind: `{ key = "mud.density", from = "1.1 m", to = "1.3 m" }`
        uncertain_below_its_range: `{ key = "friction", mean = 0.3, std = 0.15 }`
        uncertain_makes_no_case: `{ key = "operation.bit_depth", from = "4200 m", to = "5000 m" }`
        uncertain_whole_number_in_a_range: `{ key = "mesh.refinement", from = 1, to = 4 }`
        uncertain_twice: `{ key = "rpm", from = 60, to = 80 }, { key = "rpm", from = 70, to = 80 }`
        uncertain_the_same_number: `{ key = "friction", from = 0.2, to = 0.4 }, { key = "well.hole.1.friction", from = 0.2, to = 0.4 }`
        uncertain_no_input: ``
        "#,
    );
    for (name, inputs) in cases {
        refused(name, read(&with(&inputs)));
    }
    let cases = rows(
        r#"
        uncertain_without_input: `uncertain = { samples = 100 }`
        uncertain_input_as_table: `uncertain = { input = { key = "friction", from = 0.1, to = 0.3 } }`
        uncertain_as_list: `uncertain = [0.1, 0.2]`
        uncertain_samples_too_few: `uncertain = { samples = 5, input = [{ key = "friction", from = 0.1, to = 0.3 }] }`
        uncertain_samples_as_text: `uncertain = { samples = "200", input = [{ key = "friction", from = 0.1, to = 0.3 }] }`
        uncertain_seed_negative: `uncertain = { seed = -1, input = [{ key = "friction", from = 0.1, to = 0.3 }] }`
        uncertain_model_dynamic: `uncertain = { model = "dynamic", input = [{ key = "friction", from = 0.1, to = 0.3 }] }`
        "#,
    );
    for (name, keys) in cases {
        refused(name, read(&planned(&keys)));
    }
}

#[test]
fn what_is_doubted() {
    let cases = rows(
        r#"
        warn_uncertain_excludes_own: `{ key = "mud.density", from = "1.25 sg", to = "1.3 sg" }`
        warn_uncertain_excludes_own_bare: `{ key = "friction", mean = 0.2, std = 0.01 }`
        warn_uncertain_without_effect: `{ key = "dynamics.duration", from = "50 s", to = "70 s" }`
        warn_uncertain_unusual: `{ key = "mud.density", from = "0.55 sg", to = "1.3 sg" }`
        "#,
    );
    for (name, inputs) in cases {
        warned(name, read(&with(&inputs)));
    }
    let idle = planned(
        "friction = { expected = 0.3 }\n\
         uncertain = { input = [{ key = \"friction\", from = 0.2, to = 0.4 }] }",
    );
    warned("warn_uncertain_friction_beside_expected", read(&idle));
}

#[test]
fn inputs_say_what_they_mean() {
    assert_eq!(accepted("").plan.uncertain, None);
    let case = accepted(
        "[plan.uncertain]\nsamples = 50\nseed = 3\nmodel = \"stiff\"\n\
         [[plan.uncertain.input]]\nkey = \"mud.density\"\nmean = \"1.2 sg\"\nstd = \"0.02 sg\"\nto = \"1.3 sg\"\n\
         [[plan.uncertain.input]]\nkey = \"wob\"\nfrom = \"5 tf\"\nmode = \"6 tf\"\nto = \"8 tf\"\n\
         [[plan.uncertain.input]]\nkey = \"rpm\"\nvalues = [60, 70, 80]\n\
         [[plan.uncertain.input]]\nkey = \"friction\"\nmedian = 0.3\nfactor = 1.1",
    );
    assert!(case.warnings.is_empty(), "{}", case.warnings);
    let uncertain = case.plan.uncertain.expect("uncertain numbers");
    assert_eq!((uncertain.samples, uncertain.seed), (50, 3));
    assert_eq!(uncertain.model, Statics::Stiff);
    assert_eq!(
        uncertain.distributions(),
        [
            Distribution::TruncatedNormal {
                mean: 1.2,
                std: 0.02,
                from: f64::NEG_INFINITY,
                to: 1.3
            },
            Distribution::Triangular { from: 5.0, mode: 6.0, to: 8.0 },
            Distribution::Choice { count: 3 },
            Distribution::LogNormal { median: 0.3, factor: 1.1 },
        ]
    );
    let [density, weight, speed, friction] = &uncertain.inputs[..] else { panic!("four") };
    assert_eq!(density.written(1.25), "1.25 sg");
    assert_eq!(speed.written(1.0), "70");
    assert_eq!(
        [density, weight, speed, friction].map(|input| input.said()),
        [
            "normal, 1.2 sg ± 0.02 sg, up to 1.3 sg",
            "triangular, 5 tf to 8 tf, likeliest 6 tf",
            "one of 60, 70, 80",
            "log-normal, 0.3 times or over 1.1"
        ]
    );
    let points = uncertain.points();
    assert_eq!((points.len(), points[0].len()), (50, 4));
}

/// A friction table keeps its ratios, as it does with `--set`.
#[test]
fn tables_of_friction_keep_their_ratios() {
    let text = with("{ key = \"friction\", from = 0.2, to = 0.4 }")
        .replace("friction = 0.3", "friction = { kinetic = 0.3, around = 0.2 }");
    let case = read(&text).unwrap_or_else(|report| panic!("{report}"));
    assert!(case.warnings.is_empty(), "{}", case.warnings);
}
