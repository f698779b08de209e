//! Uncertain inputs: bands and indices of a plan and a reach, from the case to the files.

mod slant;

use std::{fs, path::Path};

use wholestring::{GRAVITY_M_PER_S2, operation::OperationKind};
use wholestring_judge::DepthLimit;
use wholestring_results::{PlanSummary, UncertainBand, UncertainSummary};
use wholestring_runner::{CancellationToken, Existing, Output, Silent, plan, reach};
use wholestring_verification::{report_worst, verify};

use slant::{Slant, Stops, same};

/// Density and friction, uniformly distributed.
const BOTH: &str = "plan.uncertain.input=[{ key = \"mud.density\", from = \"1000 kg/m3\", \
    to = \"2000 kg/m3\" }, { key = \"friction\", from = 0.05, to = 0.95 }]";

fn planned(slant: &Slant, folder: &Path) -> PlanSummary {
    let request = slant.plan(folder, Existing::Overwrite);
    plan::run(&request, &Silent, &CancellationToken::new()).expect("a plan").summary
}

fn band<'a>(
    summary: &'a UncertainSummary,
    quantity: &str,
    operation: Option<OperationKind>,
) -> &'a UncertainBand {
    let found = summary
        .bands
        .iter()
        .filter(|band| band.quantity == quantity && band.operation == operation);
    found.max_by(|a, b| a.bit_depth_m.partial_cmp(&b.bit_depth_m).expect("depths")).expect("a band")
}

/// Without axial friction the hook load is `g A L (ρ_s − ρ) cos θ`, linear in the mud's density, so
/// that both have a uniform distribution. While pulling it is `g A L (ρ_s − ρ)(cos θ + μ sin θ)`, a
/// product, whose indices are those of Sudret's (2008) product of functions: with means `m` and
/// variances `v` of the two factors the variance is `v_1 v_2 + v_1 m_2² + v_2 m_1²`, and the
/// first-order shares are the last two.
#[test]
fn hook_load_of_a_slant_has_its_bands() {
    let place = tempfile::tempdir().expect("a folder");
    let slant = Slant::with(&[BOTH, "plan.bit_depths=[\"300 m\", \"600 m\"]"]);
    let summary = planned(&slant, place.path());
    let found = summary.uncertain.expect("bands");
    assert_eq!((found.samples, found.solved, found.lacking), (200, 200, 0));

    let area_m2 = 0.25 * std::f64::consts::PI * (0.12_f64.powi(2) - 0.08_f64.powi(2));
    let hangs_N =
        |density: f64, slope: f64| GRAVITY_M_PER_S2 * area_m2 * 600.0 * (7850.0 - density) * slope;
    let (cos, sin) = (0.5, 0.75_f64.sqrt());
    let turning = band(&found, "hook_load", Some(OperationKind::RotateOffBottom));
    let range_N = hangs_N(1000.0, cos) - hangs_N(2000.0, cos);
    // Each of 200 equal parts contains one sample. The quantile is between two consecutive samples
    // at 199 parts of the count: less than two parts of the range away.
    let why = "two of 200 parts of the range, of which a Latin hypercube has one sample each";
    let mut rows = Vec::new();
    for (part, quantile) in [0.05, 0.1, 0.5, 0.9, 0.95].into_iter().zip(turning.quantiles) {
        let exact = hangs_N(2000.0 - 1000.0 * part, cos);
        let named = format!("hook load turning, {:.0} % quantile, N", 100.0 * part);
        rows.push(verify("uncertainty", named).absolute(range_N / 100.0, why).row(exact, quantile));
    }
    let mean = hangs_N(1500.0, cos);
    let why = "means of parts of a Latin hypercube: range over count^1.5, three times";
    let of_mean = verify("uncertainty", "mean hook load turning, N");
    rows.push(of_mean.absolute(3.0 * range_N / 200.0_f64.powf(1.5), why).row(mean, turning.mean));
    let own = turning.expected.expect("the case's own");
    assert!((own / hangs_N(1200.0, cos) - 1.0).abs() < 1e-6, "{own}");
    let owed = turning.owed.as_ref().expect("indices");
    assert!((owed.first[0].expect("an index") - 1.0).abs() < 1e-9, "{owed:?}");
    assert!(owed.total[1] < 1e-9, "{owed:?}");

    let pulling = band(&found, "hook_load", Some(OperationKind::TripOut));
    let owed = pulling.owed.as_ref().expect("indices");
    let spread = |from: f64, to: f64| (0.5 * (from + to), (to - from).powi(2) / 12.0);
    let (heavy, v_heavy) = spread(7850.0 - 2000.0, 7850.0 - 1000.0);
    let (slope, v_slope) = spread(cos + 0.05 * sin, cos + 0.95 * sin);
    let shares = [v_heavy * slope * slope, v_slope * heavy * heavy];
    let variance = v_heavy * v_slope + shares[0] + shares[1];
    // A product of two uniform inputs is a polynomial of the second degree, so the fit is exact
    // except for the rounding of the soft string's integration.
    let why = "a polynomial of the second degree, fitted without an error: rounding";
    for (input, name) in ["density", "friction"].into_iter().enumerate() {
        let (first, other) = (shares[input] / variance, shares[1 - input] / variance);
        let row = |what: &str, expected: f64, found: f64| {
            let named = format!("hook load pulling: {what} index of {name}");
            verify("uncertainty", named).absolute(1e-6, why).row(expected, found)
        };
        rows.push(row("first-order", first, owed.first[input].expect("an index")));
        rows.push(row("total", 1.0 - other, owed.total[input]));
    }
    assert_eq!(owed.degree, 2);
    report_worst(rows);

    for name in ["plan_uncertain", "plan_uncertain_indices", "plan_uncertain_samples"] {
        for ending in ["parquet", "csv"] {
            assert!(place.path().join(format!("{name}.{ending}")).is_file(), "{name}.{ending}");
        }
    }
    let page = fs::read_to_string(place.path().join("report.html")).expect("a page");
    assert!(page.contains("Sensitivity") && page.contains("Uncertain inputs"));
    let numbers = fs::read_to_string(place.path().join("hook_load.csv")).expect("numbers");
    assert!(numbers.contains("trip_out_p95_hook_load_N"), "{numbers}");
    // Fixed inputs have no bands.
    let certain = Slant::with(&["plan.bit_depths=[\"300 m\", \"600 m\"]"]);
    assert_eq!(planned(&certain, place.path()).uncertain, None);
    for name in ["plan_uncertain.csv", "uncertain.csv", "uncertain.svg"] {
        assert!(!place.path().join(name).exists(), "{name}");
    }
}

/// For seeds, as for any of several inputs, the variance that the others do not explain is known.
#[test]
fn seeds_have_what_is_left() {
    let place = tempfile::tempdir().expect("a folder");
    let slant = Slant::with(&[
        "well.tortuosity={ kind = \"random\", amplitude = \"1 deg\", period = \"60 m\" }",
        "plan.uncertain.input=[{ key = \"well.tortuosity.seed\", values = \"1..100/1\" }, \
         { key = \"mud.density\", mean = \"1.2 sg\", std = \"0.002 sg\" }]",
        "plan.uncertain.samples=100",
        "plan.bit_depths=[\"600 m\"]",
        "plan.operations=[\"trip_out\"]",
    ]);
    let found = planned(&slant, place.path()).uncertain.expect("bands");
    let owed =
        band(&found, "hook_load", Some(OperationKind::TripOut)).owed.as_ref().expect("indices");
    assert_eq!(owed.first[0], None);
    assert!(owed.total[0] > 0.1 && owed.total.iter().sum::<f64>() < 1.0 + 1e-9, "{owed:?}");
}

/// Strings that lock up have no solution: they are counted and reported, and they are those with
/// the most weight on bit.
#[test]
fn samples_without_an_answer_are_counted() {
    let place = tempfile::tempdir().expect("a folder");
    let slant = Slant::with(&[
        "plan.uncertain.input=[{ key = \"wob\", from = \"20 kN\", to = \"3000 kN\" }]",
        "plan.uncertain.samples=40",
        "operation.kind=[\"slide\"]",
        "buckling.helix_side_force=counted",
        "plan.bit_depths=[\"600 m\"]",
        "plan.operations=[\"trip_in\", \"slide\"]",
    ]);
    let found = planned(&slant, place.path()).uncertain.expect("bands");
    assert_eq!(found.solved, 40);
    assert!((1..40).contains(&found.lacking), "{found:?}");
    let sliding = band(&found, "hook_load", Some(OperationKind::Slide));
    let counts = (sliding.answers, sliding.without_answer);
    assert_eq!(counts, (40 - found.lacking, found.lacking));
    assert_eq!(band(&found, "hook_load", Some(OperationKind::TripIn)).without_answer, 0);
    assert_eq!(found.reasons.iter().map(|(_, count)| count).sum::<usize>(), found.lacking);
    let notes = plan::notes(&found).join(" ");
    let counted = format!("{} of 40 samples have points without an answer", found.lacking);
    assert!(notes.contains(&counted) && notes.contains("locks up"), "{notes}");
    let page = fs::read_to_string(place.path().join("report.html")).expect("a page");
    assert!(page.contains(&counted));

    let table = place.path().join("plan_uncertain_samples.parquet");
    let table = wholestring_results::Table::read_parquet(&table).expect("a table");
    let numbers = |name: &str| table.numbers(name).expect("a column").to_vec();
    let rows = numbers("value").into_iter().zip(numbers("without_answer"));
    let (locked, free): (Vec<_>, Vec<_>) = rows.partition(|(_, lacking)| *lacking == Some(1.0));
    let weights = |rows: Vec<(Option<f64>, Option<f64>)>| rows.into_iter().filter_map(|row| row.0);
    let most = weights(free).fold(0.0, f64::max);
    let least = weights(locked).fold(f64::INFINITY, f64::min);
    assert!(most < least, "{most} {least}");
}

const FEW: [&str; 4] = [
    BOTH,
    "plan.uncertain.samples=12",
    "plan.bit_depths=[\"300 m\", \"600 m\"]",
    "plan.operations=[\"trip_out\"]",
];

/// A plan that is interrupted in its samples keeps those that are solved, reports it, and continues
/// to the same bytes.
#[test]
fn a_plan_goes_on_in_its_samples() {
    let place = tempfile::tempdir().expect("a folder");
    let (whole, stopped) = (place.path().join("whole"), place.path().join("stopped"));
    let slant = Slant::with(&[&FEW[..], &["plan.campaign.round_trips=0"]].concat());
    let done = planned(&slant, &whole);
    // Two operations at depths, two weights to buckle, twelve samples.
    let stops = Stops::after(9);
    let first = plan::run(&slant.plan(&stopped, Existing::Protect), &stops, &stops.token);
    let first = first.expect("a part");
    assert!(first.batch.is_interrupted());
    let part = first.summary.uncertain.expect("bands of what was solved");
    assert_eq!((part.samples, part.solved), (12, 5));
    assert!(plan::notes(&part).iter().any(|note| note.contains("5 of 12 samples")));
    let goes_on = Stops::after(usize::MAX);
    let request = slant.plan(&stopped, Existing::Resume);
    let second = plan::run(&request, &goes_on, &CancellationToken::new()).expect("the rest");
    assert_eq!(goes_on.finished(), 9);
    assert_eq!(second.summary, done);
    let names = [
        "summary.json",
        "plan_uncertain.parquet",
        "plan_uncertain_indices.csv",
        "plan_uncertain_samples.csv",
        "report.html",
        "uncertain.svg",
    ];
    same(&names, [&whole, &stopped]);
}

/// The same for a reach. A friction factor given for all sections replaces uncertain friction.
#[test]
fn a_reach_has_bands_and_goes_on() {
    let place = tempfile::tempdir().expect("a folder");
    let (whole, stopped) = (place.path().join("whole"), place.path().join("stopped"));
    let slant =
        Slant::with(&[&FEW[..], &["rig.hoist_capacity=300 kN", "rig.block_weight=50 kN"]].concat());
    let request = |folder: &Path, existing| reach::Request {
        to_m: Some(6000.0),
        output: Output { folder: Some(folder.to_owned()), existing, ..Output::default() },
        operations: vec![wholestring::operation::OperationKind::TripOut],
        jobs: std::num::NonZeroUsize::new(1),
        ..reach::Request::new(&slant.case, &slant.template, &slant.overrides)
    };
    let token = CancellationToken::new();
    let done = reach::run(&request(&whole, Existing::Protect), &Silent, &token).expect("a reach");
    let found = done.summary.uncertain.as_ref().expect("bands");
    let first = band(found, "depth", None);
    let own = done.summary.frictions[0].first.as_ref().expect("a stop").depth_m;
    assert_eq!(first.expected, Some(own));
    assert!(first.quantiles[0] < own && own < first.quantiles[4], "{first:?}");
    // The hoist: `g A L (ρ_s − ρ)(cos θ + μ sin θ)` is 250 kN.
    let area_m2 = 0.25 * std::f64::consts::PI * (0.12_f64.powi(2) - 0.08_f64.powi(2));
    let depth_m = |density: f64, friction: f64| {
        let slope = 0.5 + friction * 0.75_f64.sqrt();
        250e3 / (GRAVITY_M_PER_S2 * area_m2 * (7850.0 - density) * slope)
    };
    let [low, high] = [depth_m(1000.0, 0.95), depth_m(2000.0, 0.05)];
    assert!(low < first.quantiles[0] && first.quantiles[4] < high, "{first:?} {low} {high}");
    assert_eq!(found.stops.len(), 1);
    assert_eq!((found.stops[0].limit, found.stops[0].samples), (Some(DepthLimit::Hoist), 12));

    let stops = Stops::after(4);
    let part = reach::run(&request(&stopped, Existing::Protect), &stops, &stops.token);
    let part = part.expect("a part");
    assert!(part.samples.expect("samples").is_interrupted());
    assert_eq!(part.summary.uncertain.expect("bands").solved, 4);
    let goes_on = Stops::after(usize::MAX);
    let rest =
        reach::run(&request(&stopped, Existing::Resume), &goes_on, &token).expect("the rest");
    assert_eq!(goes_on.finished(), 4);
    assert_eq!(rest.summary, done.summary);
    let names =
        ["summary.json", "reach_uncertain.parquet", "reach_uncertain_indices.csv", "report.html"];
    same(&names, [&whole, &stopped]);
}
