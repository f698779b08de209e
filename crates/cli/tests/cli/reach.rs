//! `reach`: greatest depth of the well, and the limit that stops it.

use std::fs;

use wholestring::operation::OperationKind;
use wholestring_results::{REACH, REACH_LIMITS, ReachSummary, Table, UNCERTAIN_STOPS};

use crate::desk::{Desk, transcript};

/// A rig whose limits are reached.
const RIG: [&str; 6] = [
    "--set",
    "rig.top_drive_torque=12kN.m",
    "--set",
    "rig.block_weight=150kN",
    "--set",
    "rig.hoist_capacity=600kN",
];

fn summary(desk: &Desk) -> ReachSummary {
    ReachSummary::read(&desk.path("out/summary.json")).unwrap()
}

/// Terminal, summary, tables and page agree.
#[test]
fn reach_of_a_slant_well() {
    let desk = Desk::new();
    let arguments = ["reach", "slant.toml", "-o", "out", "--friction", "0.2, 0.4", "--to", "6km"];
    let output = desk.done(&[&arguments[..], &RIG].concat());
    let stdout = String::from_utf8(output.stdout).unwrap();
    let summary = summary(&desk);
    assert_eq!((summary.to_m, summary.helix_side_force), (6000.0, true));
    let [easy, hard] = &summary.frictions[..] else { panic!("two frictions") };
    assert_eq!([easy.friction, hard.friction], [Some(0.2), Some(0.4)]);
    let depth =
        |friction: &wholestring_results::ReachOfFriction| friction.first.as_ref().unwrap().depth_m;
    assert!(depth(hard) < depth(easy), "{stdout}");
    for friction in [easy, hard] {
        let first = friction.first.as_ref().unwrap();
        assert!(
            stdout.contains(&format!("At friction {}", friction.friction.unwrap())),
            "{stdout}"
        );
        assert!(stdout.contains(&format!("{:.0}", first.depth_m)), "{stdout}");
        // The verdict of the operation in the headline names its limit.
        let verdict = summary.checks.iter().find(|check| {
            check.friction == friction.friction && check.operation == first.operation
        });
        let verdict = &verdict.expect("a verdict").check.sentence;
        assert!(verdict.ends_with(first.limit.title()), "{verdict}: {:?}", first.limit);
        let stops = friction.limits.iter().filter(|limit| limit.stops);
        let least = stops.filter_map(|limit| limit.depth_m).fold(f64::INFINITY, f64::min);
        assert_eq!(first.depth_m, least);
    }
    assert!(stdout.contains("none to 6000") && stdout.contains("by its own weight"), "{stdout}");
    // The numbers of the sentence are in the summary: 78.7 and 68.2 degrees.
    for (found, friction) in [(easy, 0.2_f64), (hard, 0.4)] {
        let critical_rad = found.critical_inclination_rad.unwrap();
        assert!((critical_rad.tan() * friction - 1.0).abs() < 1e-12, "{found:?}");
        assert!(stdout.contains(&format!("{:.1}", critical_rad.to_degrees())), "{stdout}");
    }

    let table =
        |name: &str| Table::read_parquet(&desk.path(&format!("out/{name}.parquet"))).unwrap();
    let (margins, limits) = (table("reach"), table("reach_limits"));
    assert!(margins.is_like(&Table::with_columns(REACH)));
    assert!(limits.is_like(&Table::with_columns(REACH_LIMITS)));
    assert_eq!(limits.rows(), easy.limits.len() + hard.limits.len());
    assert_eq!(margins.rows(), 61 * limits.rows());
    assert!(desk.path("out/reach.csv").is_file() && desk.path("out/reach_limits.csv").is_file());
    let picture = Table::read_csv(&desk.path("out/reach.csv")).unwrap();
    let column = |name: &str| {
        let cells = picture.words(name).unwrap().iter().filter(|cell| !cell.is_empty());
        cells.map(|cell| cell.parse().unwrap()).collect::<Vec<f64>>()
    };
    let met = [easy, hard].map(|friction| friction.limits.iter().filter_map(|limit| limit.depth_m));
    assert_eq!(column("met_at_bit_depth_m"), met.into_iter().flatten().collect::<Vec<_>>());
    assert_eq!(column("stops_first").iter().sum::<f64>(), 2.0);
    // Margins change sign where the summary reports that the limit is met.
    let words = |name: &str| margins.words(name).unwrap();
    let numbers = |name: &str| margins.numbers(name).unwrap();
    for friction in [easy, hard] {
        for limit in
            friction.limits.iter().filter(|limit| limit.depth_m.is_some() && !limit.already)
        {
            for row in 0..margins.rows() {
                let same = words("operation")[row] == limit.operation.name()
                    && words("limit")[row] == limit.limit.name()
                    && numbers("friction")[row] == friction.friction;
                let above = numbers("bit_depth_m")[row] < limit.depth_m;
                if same && above {
                    assert!(numbers("margin")[row] > Some(0.0), "{limit:?}");
                }
            }
        }
    }

    let page = fs::read_to_string(desk.path("out/report.html")).unwrap();
    assert!(page.contains("Margins against depth") && page.contains("stops the well first"));
    fs::remove_file(desk.path("out/report.html")).unwrap();
    desk.done(&["report", "out"]);
    assert_eq!(fs::read_to_string(desk.path("out/report.html")).unwrap(), page);
    desk.done(&["plot", "out", "--units", "field"]);
    assert!(desk.path("out/plots/reach.svg").is_file());
    let output = desk.run(&["plot", "out", "out"]);
    assert!(transcript(&output).contains("a reach cannot be overlaid with anything"));
}

/// The case's own friction, one operation, and no helix friction.
#[test]
fn one_operation_at_the_cases_friction() {
    let desk = Desk::new();
    let arguments = ["reach", "slant.toml", "-o", "out", "-q", "--operation", "trip_in"];
    let output = desk.done(&[&arguments[..], &["--no-helix-friction"]].concat());
    assert!(output.stdout.is_empty());
    let summary = summary(&desk);
    let [friction] = &summary.frictions[..] else { panic!("one friction") };
    assert_eq!(friction.friction, None);
    assert!(friction.limits.iter().all(|limit| limit.operation == OperationKind::TripIn));
    let locks = friction.limits.iter().find(|limit| limit.limit.name() == "push_absorbed").unwrap();
    assert_eq!(locks.depth_m, None);
    let output = desk.run(&["reach", "slant.toml", "-o", "out", "-q"]);
    assert_eq!(output.status.code(), Some(2), "another question's answer lies there");
}

/// Invalid input is reported.
#[test]
fn what_cannot_be_asked() {
    let desk = Desk::new();
    for (more, answer) in [
        (&["--to", "100m"][..], "is not below its beginning"),
        (&["--to", "200km"], "100000 m is the most"),
        (&["--from", "0m"], "the reach begins with the bit at 0 m: expected more than"),
        (&["--from", "1kN"], "is no length"),
        (&["--to", "3km,4km"], "`to`: 2 values; expected one"),
        (&["--friction", "much"], "expected a friction factor, such as 0.3"),
        (&["--friction", "-0.1"], "outside 0 to 2"),
        (&["--operation", "fly"], "`fly` is no operation"),
        (
            &[
                "--operation",
                "drill",
                "--set",
                "operation.kind=trip_in",
                "--set",
                "operation.wob=0kN",
            ],
            "has no wob",
        ),
    ] {
        let more: Vec<&str> = more.to_vec();
        let glued: Vec<String> = match more[..] {
            ["--friction", value] => vec![format!("--friction={value}")],
            _ => more.iter().map(|word| (*word).to_owned()).collect(),
        };
        let mut all = vec!["reach", "slant.toml", "-o", "out"];
        all.extend(glued.iter().map(String::as_str));
        let output = desk.run(&all);
        let stdout = transcript(&output);
        assert_eq!(output.status.code(), Some(2), "{more:?}: {stdout}");
        assert!(stdout.contains(answer), "{more:?}: {stdout}");
    }
}

/// A helix is a stop only if requested: the well then ends where it begins, unless another limit
/// stops it before.
#[test]
fn a_helix_stops_the_well_if_asked() {
    let desk = Desk::new();
    // Long and smooth enough to hang on the hook with a weight on bit that causes a helix.
    let arguments = ["reach", "slant.toml", "--operation=slide", "--friction=0.05", "--from=4km"];
    let kind = ["--to=6km", "--set=operation.wob=400 kN", "--set=operation.kind=[\"slide\"]", "-o"];
    let solved = |folder: &str, more: &[&str]| {
        let output = desk.done(&[&arguments[..], &kind, &[folder], more].concat());
        let path = desk.path(&format!("{folder}/summary.json"));
        (ReachSummary::read(&path).unwrap(), String::from_utf8(output.stdout).unwrap())
    };
    let (free, _) = solved("free", &[]);
    let (stopped, stdout) = solved("stopped", &["--stop-at-helix"]);
    let helix = |summary: &ReachSummary| {
        let limits = &summary.frictions[0].limits;
        limits.iter().find(|limit| limit.limit.name() == "helix").unwrap().clone()
    };
    let (goes_on, stops) = (helix(&free), helix(&stopped));
    assert_eq!((goes_on.stops, stops.stops), (false, true));
    assert_eq!(goes_on.depth_m, stops.depth_m);
    assert!(stops.already);
    let first = |summary: &ReachSummary| summary.frictions[0].first.clone();
    assert_eq!(first(&free), None);
    let end = first(&stopped).expect("a stop");
    assert_eq!((end.limit.name(), end.depth_m), ("helix", 4000.0));
    assert!(stdout.contains("A helix counts as a stop"), "{stdout}");
    // It is a different reach.
    let output = desk.run(&[&arguments[..], &kind, &["free", "--stop-at-helix"]].concat());
    assert_eq!(output.status.code(), Some(2), "{}", transcript(&output));
}

/// Bands of the greatest depth, and the frequency with which each limit governs.
#[test]
fn a_reach_of_uncertain_numbers() {
    let desk = Desk::new();
    let uncertain = "plan.uncertain.input=[{ key = \"friction\", from = 0.15, to = 0.35 }, \
        { key = \"mud.density\", from = \"1.1 sg\", to = \"1.3 sg\" }]";
    let arguments = ["reach", "slant.toml", "-o", "out", "--to", "6km", "--set", uncertain];
    let more = ["--set", "plan.uncertain.samples=20", "--operation", "trip_out"];
    let output = desk.done(&[&arguments[..], &more, &RIG].concat());
    let stdout = String::from_utf8(output.stdout).unwrap();
    assert!(
        stdout.contains("Bands: 5 to 95 % of 20 samples") && stdout.contains("\nreach "),
        "{stdout}"
    );
    let found = summary(&desk).uncertain.expect("bands");
    assert_eq!((found.solved, found.lacking), (20, 0));
    assert_eq!(found.stops.iter().map(|stop| stop.samples).sum::<usize>(), 20);
    for name in ["reach_uncertain", "reach_uncertain_indices", "reach_uncertain_samples"] {
        assert!(
            Table::read_parquet(&desk.path(&format!("out/{name}.parquet"))).unwrap().rows() > 0
        );
    }
    // The numbers of the picture include its bands, its bars and the depths of the limits.
    let picture = Table::read_csv(&desk.path("out/reach.csv")).unwrap();
    let filled =
        |name: &str| picture.words(name).unwrap().iter().filter(|cell| !cell.is_empty()).count();
    let margins = found.bands.iter().filter(|band| band.quantity == "margin").count();
    assert_eq!((filled("margin_p05"), filled("margin_p95")), (margins, margins));
    assert!(margins > 0 && filled("met_p05_m") > 0);
    // The counts of the page are in the table that it links to.
    let stops = Table::read_parquet(&desk.path("out/reach_uncertain_stops.parquet")).unwrap();
    assert!(stops.is_like(&Table::with_columns(UNCERTAIN_STOPS)));
    let counted = stops.numbers("samples").unwrap();
    let expected: Vec<_> = found.stops.iter().map(|stop| Some(stop.samples as f64)).collect();
    assert_eq!(counted, expected);
    assert!(desk.path("out/reach_uncertain_stops.csv").is_file());
    let page = fs::read_to_string(desk.path("out/report.html")).unwrap();
    assert!(page.contains("reach_uncertain_stops"));
    for expected in
        ["Uncertain inputs", "Limits that stop the samples", "Sensitivity", "Sobol indices"]
    {
        assert!(page.contains(expected), "{expected}");
    }
}
