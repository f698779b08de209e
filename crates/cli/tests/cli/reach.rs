//! `reach`: how far the well can go, and what stops it.

use std::fs;

use wholestring_results::{REACH, REACH_LIMITS, ReachSummary, Table, UNCERTAIN_STOPS};

use crate::desk::{Desk, transcript};

/// A rig whose limits are met.
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

/// Terminal, summary, tables and page tell the same.
#[test]
fn reach_of_a_slant_well() {
    let desk = Desk::new();
    let asked = ["reach", "slant.toml", "-o", "out", "--friction", "0.2, 0.4", "--to", "6km"];
    let output = desk.done(&[&asked[..], &RIG].concat());
    let said = String::from_utf8(output.stdout).unwrap();
    let summary = summary(&desk);
    assert_eq!((summary.to_m, summary.helix_side_force), (6000.0, true));
    let [easy, hard] = &summary.frictions[..] else { panic!("two frictions") };
    assert_eq!([easy.friction, hard.friction], [Some(0.2), Some(0.4)]);
    let depth = |of: &wholestring_results::ReachOfFriction| of.first.as_ref().unwrap().depth_m;
    assert!(depth(hard) < depth(easy), "{said}");
    for of in [easy, hard] {
        let first = of.first.as_ref().unwrap();
        assert!(said.contains(&format!("At friction {}", of.friction.unwrap())), "{said}");
        assert!(said.contains(&format!("{:.0}", first.depth_m)), "{said}");
        let stops = of.limits.iter().filter(|limit| limit.stops);
        let least = stops.filter_map(|limit| limit.depth_m).fold(f64::INFINITY, f64::min);
        assert_eq!(first.depth_m, least);
    }
    assert!(said.contains("none to 6000") && said.contains("by its own weight"), "{said}");
    // What the sentence says stands in the summary: 78.7 and 68.2 degrees.
    for (of, friction) in [(easy, 0.2_f64), (hard, 0.4)] {
        let critical_rad = of.critical_inclination_rad.unwrap();
        assert!((critical_rad.tan() * friction - 1.0).abs() < 1e-12, "{of:?}");
        assert!(said.contains(&format!("{:.1}", critical_rad.to_degrees())), "{said}");
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
    let met = [easy, hard].map(|of| of.limits.iter().filter_map(|limit| limit.depth_m));
    assert_eq!(column("met_at_bit_depth_m"), met.into_iter().flatten().collect::<Vec<_>>());
    assert_eq!(column("stops_first").iter().sum::<f64>(), 2.0);
    // Margins change their sign where the summary says that the limit is met.
    let words = |name: &str| margins.words(name).unwrap();
    let numbers = |name: &str| margins.numbers(name).unwrap();
    for of in [easy, hard] {
        for limit in of.limits.iter().filter(|limit| limit.depth_m.is_some() && !limit.already) {
            for row in 0..margins.rows() {
                let same = words("operation")[row] == limit.operation
                    && words("limit")[row] == limit.limit
                    && numbers("friction")[row] == of.friction;
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

/// The case's own friction, one operation, and a helix that does not rub.
#[test]
fn one_operation_at_the_cases_friction() {
    let desk = Desk::new();
    let asked = ["reach", "slant.toml", "-o", "out", "-q", "--operation", "trip_in"];
    let output = desk.done(&[&asked[..], &["--no-helix-friction"]].concat());
    assert!(output.stdout.is_empty());
    let summary = summary(&desk);
    let [of] = &summary.frictions[..] else { panic!("one friction") };
    assert_eq!(of.friction, None);
    assert!(of.limits.iter().all(|limit| limit.operation == "trip_in"));
    let locks = of.limits.iter().find(|limit| limit.limit == "lock_up").unwrap();
    assert_eq!(locks.depth_m, None);
    let output = desk.run(&["reach", "slant.toml", "-o", "out", "-q"]);
    assert_eq!(output.status.code(), Some(2), "another question's answer lies there");
}

/// Bad input gets an answer.
#[test]
fn what_cannot_be_asked() {
    let desk = Desk::new();
    for (more, answer) in [
        (&["--to", "100m"][..], "is not below its beginning"),
        (&["--to", "200km"], "100000 m is the most"),
        (&["--from", "0m"], "the reach begins with the bit at 0 m: expected more than"),
        (&["--from", "1kN"], "is no length"),
        (&["--to", "3km,4km"], "--to takes one depth"),
        (&["--friction", "much"], "`much` is no friction factor"),
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
        let said = transcript(&output);
        assert_eq!(output.status.code(), Some(2), "{more:?}: {said}");
        assert!(said.contains(answer), "{more:?}: {said}");
    }
}

/// A helix is no stop, and is one if it is asked for: then the well ends where it begins, unless
/// something else stops it before.
#[test]
fn a_helix_stops_the_well_if_asked() {
    let desk = Desk::new();
    // Long and smooth enough to hang on the hook with a weight on bit that makes a helix.
    let asked = ["reach", "slant.toml", "--operation=slide", "--friction=0.05", "--from=4km"];
    let kind = ["--to=6km", "--set=operation.wob=400 kN", "--set=operation.kind=[\"slide\"]", "-o"];
    let solved = |folder: &str, more: &[&str]| {
        let output = desk.done(&[&asked[..], &kind, &[folder], more].concat());
        let path = desk.path(&format!("{folder}/summary.json"));
        (ReachSummary::read(&path).unwrap(), String::from_utf8(output.stdout).unwrap())
    };
    let (free, _) = solved("free", &[]);
    let (stopped, said) = solved("stopped", &["--stop-at-helix"]);
    let helix = |of: &ReachSummary| {
        let limits = &of.frictions[0].limits;
        limits.iter().find(|of| of.limit == "helix").unwrap().clone()
    };
    let (goes_on, stops) = (helix(&free), helix(&stopped));
    assert_eq!((goes_on.stops, stops.stops), (false, true));
    assert_eq!(goes_on.depth_m, stops.depth_m);
    assert!(stops.already);
    let first = |of: &ReachSummary| of.frictions[0].first.clone();
    assert_eq!(first(&free), None);
    let end = first(&stopped).expect("a stop");
    assert_eq!((end.limit.as_str(), end.depth_m), ("helix", 4000.0));
    assert!(said.contains("A helix counts as a stop"), "{said}");
    // It is another reach.
    let output = desk.run(&[&asked[..], &kind, &["free", "--stop-at-helix"]].concat());
    assert_eq!(output.status.code(), Some(2), "{}", transcript(&output));
}

/// Bands of how far the well goes, and how often each limit is what stops it.
#[test]
fn a_reach_of_uncertain_numbers() {
    let desk = Desk::new();
    let uncertain = "plan.uncertain.input=[{ key = \"friction\", from = 0.15, to = 0.35 }, \
        { key = \"mud.density\", from = \"1.1 sg\", to = \"1.3 sg\" }]";
    let asked = ["reach", "slant.toml", "-o", "out", "--to", "6km", "--set", uncertain];
    let more = ["--set", "plan.uncertain.samples=20", "--operation", "trip_out"];
    let output = desk.done(&[&asked[..], &more, &RIG].concat());
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(said.contains("Bands: 5 to 95 % of 20 samples") && said.contains("\nreach "), "{said}");
    let found = summary(&desk).uncertain.expect("bands");
    assert_eq!((found.solved, found.lacking), (20, 0));
    assert_eq!(found.stops.iter().map(|of| of.samples).sum::<usize>(), 20);
    for name in ["reach_uncertain", "reach_uncertain_indices", "reach_uncertain_samples"] {
        assert!(
            Table::read_parquet(&desk.path(&format!("out/{name}.parquet"))).unwrap().rows() > 0
        );
    }
    // The numbers of the picture have its bands, its bars and where limits are met.
    let picture = Table::read_csv(&desk.path("out/reach.csv")).unwrap();
    let filled =
        |name: &str| picture.words(name).unwrap().iter().filter(|cell| !cell.is_empty()).count();
    let margins = found.bands.iter().filter(|of| of.quantity == "margin").count();
    assert_eq!((filled("margin_p05"), filled("margin_p95")), (margins, margins));
    assert!(margins > 0 && filled("met_p05_m") > 0);
    // What the page counts stands in the table that it leads to.
    let stops = Table::read_parquet(&desk.path("out/reach_uncertain_stops.parquet")).unwrap();
    assert!(stops.is_like(&Table::with_columns(UNCERTAIN_STOPS)));
    let counted = stops.numbers("samples").unwrap();
    let told: Vec<_> = found.stops.iter().map(|of| Some(of.samples as f64)).collect();
    assert_eq!(counted, told);
    assert!(desk.path("out/reach_uncertain_stops.csv").is_file());
    let page = fs::read_to_string(desk.path("out/report.html")).unwrap();
    assert!(page.contains("reach_uncertain_stops"));
    for expected in ["What is uncertain", "What stops the samples", "Sensitivity", "Sobol indices"]
    {
        assert!(page.contains(expected), "{expected}");
    }
}
