use std::collections::BTreeMap;

use wholestring::{operation::OperationKind, outcome::ModelKind, well::FrictionLevel};
use wholestring_results::{
    PlanFatigue, PlanFatigueHour, PlanMeasured, PlanOverlay, PlanOverlayDifference, PlanOverlayRow,
    PlanSurfaceLimit, PlanWear,
};

use super::{
    BucklingCurve, Plan, PlanCurve, PlanEvent, PlanLevel, PlanLimitRow, PlanMud, PlanMudRow,
    PlanPeakRow, PlanSpot, PlanVerdict, plan_html, plan_plots,
};
use crate::{
    Cell, DisplayUnit, Fact, PageHead, Section, Severity,
    figure::{Mark, Panel, Range, Stroke},
};

fn plan() -> Plan {
    let unit = |symbol: &str, factor: f64| DisplayUnit { symbol: symbol.into(), factor };
    let units = [
        ("length", [unit("m", 1.0), unit("m", 1.0), unit("ft", 0.3048)]),
        ("diameter", [unit("mm", 1e-3), unit("mm", 1e-3), unit("in", 0.0254)]),
        ("force", [unit("kN", 1e3), unit("t", 9806.65), unit("klbf", 4448.22)]),
        ("pressure", [unit("MPa", 1e6), unit("bar", 1e5), unit("psi", 6894.76)]),
        ("density", [unit("kg/m³", 1.0), unit("sg", 1000.0), unit("ppg", 119.826)]),
        ("torque", [unit("kN·m", 1e3), unit("kN·m", 1e3), unit("ft·lbf", 1.355_82)]),
    ];
    let units = units.map(|(name, units)| (name.to_owned(), units));
    let levels = ["low", "expected", "high"].into_iter().zip(["0.1", "0.2", "0.3"]);
    let depths = [500.0, 1000.0, 2000.0];
    let curve = |operation: OperationKind, level: usize| {
        let pull = match operation {
            OperationKind::TripOut => level as f64,
            OperationKind::TripIn => -(level as f64),
            _ => 0.0,
        };
        let points = depths.map(|bit_depth_m| {
            let lost = operation == OperationKind::TripIn && level == 2 && bit_depth_m > 1500.0;
            let value = |value: f64| if lost { f64::NAN } else { value };
            PlanSpot {
                bit_depth_m,
                hook_load_N: value(200.0 * bit_depth_m * (1.0 + 0.2 * pull)),
                torque_N_m: value(if operation == OperationKind::Drill {
                    5.0 * bit_depth_m
                } else {
                    0.0
                }),
                buckling: if lost { String::new() } else { "none".into() },
                worst: (operation == OperationKind::TripIn)
                    .then(|| ("Helical buckling: exceeded".into(), Severity::Warning)),
                message: lost.then(|| ["the string <locks> up"; 3].map(str::to_owned)),
            }
        });
        PlanCurve { model: ModelKind::Soft, operation, level, points: points.into() }
    };
    use OperationKind::{Drill, RotateOffBottom, TripIn, TripOut};
    let operations = [TripOut, TripIn, RotateOffBottom, Drill];
    Plan {
        head: PageHead {
            program: "wholestring".into(),
            title: "<Well> & \"plan\"".into(),
            units: "si".into(),
            dimensions: BTreeMap::from(units),
            facts: vec![Fact { label: "Depths".into(), value: Cell::Text("3".into()) }],
        },
        message: None,
        models: vec![ModelKind::Soft],
        levels: levels
            .map(|(name, label)| PlanLevel {
                name: name.into(),
                label: label.into(),
                sections: vec![format!("casing {label}")],
            })
            .collect(),
        curves: operations
            .iter()
            .flat_map(|operation| [0, 1, 2].map(|level| curve(*operation, level)))
            .collect(),
        buckling: [OperationKind::Drill, OperationKind::Slide]
            .iter()
            .flat_map(|operation| {
                [0, 1, 2].map(|level| BucklingCurve {
                    operation: *operation,
                    level,
                    points: depths.map(|depth| (depth, [4e4, 6e4])).into(),
                })
            })
            .collect(),
        mud: Some(PlanMud {
            operation: OperationKind::Drill,
            density_kg_per_m3: 1200.0,
            pump_limit_Pa: Some(35e6),
            rows: depths
                .map(|bit_depth_m| PlanMudRow {
                    bit_depth_m,
                    standpipe_Pa: 1e4 * bit_depth_m,
                    at_shoe_kg_per_m3: [1230.0, 1250.0, 1220.0, 1150.0, 1180.0],
                    at_bit_kg_per_m3: [1240.0, 1260.0, 1230.0, 1140.0, 1170.0],
                })
                .into(),
        }),
        hole: vec![
            Section {
                kind: "casing".into(),
                from_m: 0.0,
                to_m: 900.0,
                diameter_m: 0.22,
                friction: 0.2,
            },
            Section {
                kind: "open".into(),
                from_m: 900.0,
                to_m: 2000.0,
                diameter_m: 0.2,
                friction: 0.2,
            },
        ],
        block_N: Some(2e5),
        surface_limits: vec![
            borne("hoist", false, 6e5),
            borne("tension", false, 5.8e5),
            borne("top_drive", true, 1.2e4),
            borne("top_drive_peak", true, 1e6),
            borne("make_up", true, 1.25e4),
        ],
        limits: vec![
            limit("Tension", 1.05, "below required factor", Severity::Warning),
            PlanLimitRow {
                breaks: false,
                ..limit("Helical buckling", 0.5, "exceeded", Severity::Warning)
            },
            limit("Hoist", 1.2, "marginal", Severity::Note),
        ],
        checks: vec![
            PlanVerdict {
                severity: Severity::Error,
                verdict: "exceeded".into(),
                governs: false,
                model: ModelKind::Soft,
                operation: "slide".into(),
                friction: FrictionLevel::High,
                bit_depth_m: 2000.0,
                sentences: ["kN.m", "kN.m", "ft-lbf"].map(|unit| format!("Lock-up <at> 3 {unit}")),
            },
            PlanVerdict {
                severity: Severity::Note,
                verdict: "OK".into(),
                governs: true,
                model: ModelKind::Soft,
                operation: "drill".into(),
                friction: FrictionLevel::High,
                bit_depth_m: 2000.0,
                sentences: ["N.m", "N.m", "ft-lbf"].map(|unit| format!("Tension 3 {unit}")),
            },
        ],
        unchecked: [(); 3].map(|()| vec!["no make-up torque of pipe".into()]),
        counted: [(); 3].map(|()| vec!["drill from 900 m to 2000 m in 55.0 h".into()]),
        not_counted: [(); 3].map(|()| vec!["trip in: no <speed>".into()]),
        fatigue: vec![fatigue("drill <pipe>", 1.2), fatigue("collar", 1e-7)],
        wear: vec![wear()],
        events: Vec::new(),
        weight_on_bit_N: Some(3e4),
        uncertain: None,
        measured: Vec::new(),
        overlay: None,
    }
}

fn borne(kind: &str, is_torque: bool, allowed: f64) -> PlanSurfaceLimit {
    let kind = kind.to_owned();
    PlanSurfaceLimit { kind, component: None, is_torque, capacity: allowed, required: 1.0, allowed }
}

/// Lines down the page and their names.
fn rules(panel: &Panel) -> Vec<(f64, String)> {
    let rule = |mark: &Mark| match mark {
        Mark::OwnRule { at, label } => Some((*at, label.clone())),
        _ => None,
    };
    panel.marks.iter().filter_map(rule).collect()
}

fn measured(operation: OperationKind, bit_depth_m: f64, held_out: bool) -> PlanMeasured {
    PlanMeasured {
        model: ModelKind::Soft,
        place: "line <2>".into(),
        operation,
        reading: "pick_up".into(),
        is_torque: false,
        held_out,
        bit_depth_m,
        measured: 5e5,
        block_N: 2e5,
        predicted: [4.5e5, 4.8e5, 4.9e5].map(Some),
        message: None,
    }
}

/// Points without the block appear with the curves, the table row with it; a point deeper than the
/// plan has room.
#[test]
fn what_was_measured_stands_on_the_broomstick() {
    let rows = [(OperationKind::TripOut, 1000.0, false), (OperationKind::TripOut, 2400.0, true)];
    let rows = rows.map(|(operation, depth_m, out)| measured(operation, depth_m, out));
    let measured_plan = Plan { measured: rows.into(), ..plan() };
    let plots = plan_plots(&measured_plan, "si");
    let hook_load = &plots[0].figure;
    let points: Vec<_> = hook_load.panels[0]
        .marks
        .iter()
        .filter_map(|mark| match mark {
            Mark::Points { points, .. } => Some(points.as_slice()),
            _ => None,
        })
        .collect();
    assert_eq!(points, [[(2400.0, 300.0)], [(1000.0, 300.0)]]);
    let keys: Vec<&str> = hook_load.keys.iter().map(|key| key.name.as_str()).collect();
    assert!(keys.ends_with(&["measured", "measured, held out"]), "{keys:?}");
    // No torque was read.
    assert!(plots[1].figure.keys.iter().all(|key| !key.name.contains("measured")));
    assert!(matches!(hook_load.shared.range, Range::Fixed(_, to) if to > 2400.0));
    let page = plan_html(&measured_plan);
    for text in ["plan_measured.csv", "weight with block, kN", "500", "line &lt;2&gt;, held out"] {
        assert!(page.contains(text), "{text}");
    }
    assert!(!plan_html(&plan()).contains("plan_measured"));
}

/// A line over the curves, its name in the legend, and the differences of our curve from it in a
/// table.
#[test]
fn another_program_lies_over_the_broomstick() {
    let row = |bit_depth_m: f64, theirs: f64| PlanOverlayRow {
        model: ModelKind::Soft,
        operation: OperationKind::TripOut,
        place: String::new(),
        is_torque: false,
        bit_depth_m,
        theirs,
        ours: None,
    };
    let overlay = PlanOverlay {
        file: "other <program>.csv".into(),
        rows: vec![row(1000.0, 3e5), row(2500.0, 6e5)],
        differences: vec![PlanOverlayDifference {
            model: ModelKind::Soft,
            operation: OperationKind::TripOut,
            is_torque: false,
            count: 2,
            mean: 4e3,
            largest: -1.2e4,
            largest_at_m: 2500.0,
            theirs_there: 6e5,
            largest_part: Some(-0.02),
        }],
    };
    let overlaid = Plan { overlay: Some(overlay), ..plan() };
    let plots = plan_plots(&overlaid, "si");
    let hook_load = &plots[0].figure;
    let lines: Vec<_> = hook_load.panels[0]
        .marks
        .iter()
        .filter_map(|mark| match mark {
            Mark::Curve { stroke: Stroke::LongDashed, points, .. } => Some(points.as_slice()),
            _ => None,
        })
        .collect();
    assert_eq!(lines, [[(1000.0, 300.0), (2500.0, 600.0)]]);
    let keys: Vec<&str> = hook_load.keys.iter().map(|key| key.name.as_str()).collect();
    assert!(keys.ends_with(&["another program: other <program>.csv"]), "{keys:?}");
    assert!(plots[1].figure.keys.iter().all(|key| !key.name.contains("another program")));
    assert!(matches!(hook_load.shared.range, Range::Fixed(_, to) if to > 2500.0));
    let page = plan_html(&overlaid);
    for text in
        ["plan_overlay.csv", "hook load, kN", "\u{2212}12.00", "\u{2212}2.0", "Ours less theirs"]
    {
        assert!(page.contains(text), "{text}");
    }
    assert!(!page.contains("<program>"));
    assert!(!plan_html(&plan()).contains("plan_overlay"));
}

fn fatigue(component: &str, damage: f64) -> PlanFatigue {
    let hour = PlanFatigueHour {
        md_m: 700.4,
        damage_per_hour: 0.01,
        bending_Pa: 1.2e8,
        dogleg_rad_per_m: 0.0017,
        permissible_dogleg_rad_per_m: None,
    };
    let hour = (damage > 1.0).then_some(hour);
    PlanFatigue {
        model: ModelKind::Soft,
        component: component.into(),
        damage,
        from_lower_end_m: 0.0,
        hour,
    }
}

fn wear() -> PlanWear {
    PlanWear {
        model: ModelKind::Soft,
        section: 1,
        md_m: 802.5,
        groove_m: Some(0.0062),
        wall_m: Some(0.012),
        wall_left_m: Some(0.0058),
        worn: Some(0.517),
        burst_Pa: Some([5e7, 2.4e7]),
        collapse_Pa: None,
    }
}

fn limit(kind: &str, factor: f64, verdict: &str, severity: Severity) -> PlanLimitRow {
    PlanLimitRow {
        breaks: true,
        kind: kind.into(),
        operation: "trip out".into(),
        friction: FrictionLevel::High,
        bit_depth_m: 2000.0,
        component: "drill <pipe>".into(),
        md_m: (kind == "Tension").then_some(0.0),
        load: 1e6,
        capacity: 1e6 * factor,
        dimension: "force".into(),
        factor,
        required: 1.0 / 0.9,
        verdict: verdict.into(),
        severity,
    }
}

fn names(panel: &Panel) -> Vec<((f64, f64), &str)> {
    let name = |mark: &'_ Mark| match mark {
        Mark::Foot { at, text } => Some((*at, text.clone())),
        _ => None,
    };
    let all = panel.marks.iter().filter_map(name);
    all.map(|(at, text)| (at, Box::leak(text.into_boxed_str()) as &str)).collect()
}

/// Each operation has a line for each friction, with the friction at its end, which is at the last
/// answer; lines that coincide have none. Limits are drawn where they are near, and written
/// otherwise.
#[test]
fn lines_end_with_their_friction() {
    let plots = plan_plots(&plan(), "si");
    let known: Vec<&str> = plots.iter().map(|plot| plot.name.as_str()).collect();
    assert_eq!(known, ["hook_load", "torque", "buckling_weight", "hydraulics"]);
    let [off, on] = &plots[0].figure.panels[..] else { panic!("two panels") };
    assert_eq!(off.axis.label, "Hook load, off bottom, kN");
    let found = names(off);
    assert_eq!(found.len(), 6, "{found:?}");
    assert_eq!(found[2], ((2000.0, 560.0), "0.3"));
    assert_eq!(found[5], ((1000.0, 120.0), "0.3"));
    let borne = [(600.0, "hoist".to_owned()), (580.0, "pipe, tension".to_owned())];
    assert_eq!(rules(off), borne);
    // Farther than 1.35 times 400 kN.
    assert!(rules(on).is_empty() && names(on).is_empty());
    let shoes = plots[0].figure.hole.iter().filter(|hole| hole.shoe);
    assert_eq!(shoes.map(|shoe| shoe.to).collect::<Vec<_>>(), [900.0]);
    // Every torque limit that is near is drawn; only the far one is written.
    let torque = &plots[1].figure;
    let drilling = torque.panels.last().expect("drilling");
    assert_eq!(rules(drilling), [(12.0, "top drive".to_owned()), (12.5, "make-up".to_owned())]);
    let limit = "limit beyond the picture: top drive, peak 1000 kN·m";
    assert!(torque.subtitle.contains(limit), "{}", torque.subtitle);
    assert!(!plots[0].figure.subtitle.contains("beyond"), "{}", plots[0].figure.subtitle);
    // In the reader's units.
    let field = plan_plots(&plan(), "field");
    assert_eq!(field[0].figure.panels[0].axis.label, "Hook load, off bottom, klbf");
}

/// A plan of one depth has marks where it would have lines.
#[test]
fn a_plan_of_one_depth_is_seen() {
    let whole = plan();
    let mut plan = plan();
    for curve in &mut plan.curves {
        curve.points = curve.points.split_off(2);
    }
    let finite = plan.curves.iter().filter(|curve| curve.points[0].hook_load_N.is_finite()).count();
    let plots = plan_plots(&plan, "si");
    let is_seen = |mark: &&Mark| matches!(mark, Mark::Points { points, .. } if points.len() == 1);
    let panels = plots[0].figure.panels.iter();
    let seen = panels.flat_map(|panel| panel.marks.iter().filter(is_seen)).count();
    assert_eq!(seen, finite);
    assert!(finite > 3);
    // A point with neighbours needs no mark.
    let plots = plan_plots(&whole, "si");
    assert!(!plots[0].figure.panels[1].marks.iter().any(|mark| is_seen(&mark)));
}

/// Pressure and the densities at bit and shoe, five states each and the mud at rest; a limit that
/// is far beyond is written. Without a rheology there is no picture.
#[test]
fn the_mud_beside_it() {
    let mut plan = plan();
    let plots = plan_plots(&plan, "field");
    let figure = &plots[3].figure;
    let labels: Vec<&str> = figure.panels.iter().map(|panel| panel.axis.label.as_str()).collect();
    assert_eq!(
        labels,
        [
            "Standpipe pressure, drill, psi",
            "Equivalent density at the bit, ppg",
            "Equivalent density at the shoe, ppg"
        ]
    );
    assert_eq!(figure.panels[1].marks.len(), 6);
    assert!(figure.subtitle.contains("limit of the pump"), "{}", figure.subtitle);
    assert!(plan_html(&plan).contains("plan_hydraulics.parquet"));
    plan.mud = None;
    assert_eq!(plan_plots(&plan, "field").len(), 3);
    assert!(!plan_html(&plan).contains("plan_hydraulics"));
}

/// The page has the pictures, the tables, the findings and the reasons for missing answers, and
/// nothing in it becomes markup.
#[test]
fn the_page_says_everything() {
    let page = plan_html(&plan());
    for expected in [
        "Hook load",
        "Surface torque, kN·m, soft string",
        "trip in 0.1",
        "<td class=\"words level-error\">exceeded</td>",
        "the string &lt;locks&gt; up",
        "plan_broomstick.parquet",
        "href=\"hook_load.csv\"",
        "href=\"plan.xlsx\"",
        "With the bit at 2000 m",
        "<td class=\"level-warning\">1.05\u{a0}below required factor</td>",
        "<td class=\"words level-note\">marginal</td>",
        "drill &lt;pipe&gt;, 0\u{a0}m",
        "Not checked for want of data: no make-up torque of pipe.",
    ] {
        assert!(page.contains(expected), "{expected}");
    }
    // In three sets of units.
    let narrow = page.matches("<figure class=\"narrow\"").count();
    assert_eq!(page.matches("<svg").count(), 3 * 4 + narrow);
    assert!(page.contains("Surface torque, ft·lbf, soft string"));
    assert!(!page.contains("<Well>") && !page.contains("<locks>"));
}

/// Limits that break something precede the others, whatever their reserve, and are written for each
/// operation.
#[test]
fn what_would_break_first() {
    let page = plan_html(&plan());
    let (_, nearest) = page.split_once("<h2>Nearest limits").expect("a table");
    let place = |kind: &str| nearest.find(kind).unwrap_or_else(|| panic!("{kind}"));
    assert!(place("Tension") < place("Hoist") && place("Hoist") < place("Helical buckling"));
    // The verdict is one table, in the reader's units; its sentences name their check.
    for sentence in ["Lock-up &lt;at&gt; 3\u{a0}kN·m", "Lock-up &lt;at&gt; 3\u{a0}ft·lbf"] {
        assert!(page.contains(sentence), "{sentence}");
    }
    assert!(!page.contains("<h2>Governing limits") && !page.contains("<th class=\"words\">check"));
    assert!(page.contains("<td class=\"words level-note\">OK, governs</td>"));
}

/// A used-up life is written as a word, and so is an unknown one; numbers are in the reader's
/// units.
#[test]
fn fatigue_and_wear_stand_on_the_page() {
    let page = plan_html(&plan());
    for text in [
        "120.0 % used up",
        "under 0.001 %",
        "drill &lt;pipe&gt;",
        "section 1",
        "51.70 %",
        "6.200",
        "not known",
        "plan_fatigue.csv",
        "plan_wear.parquet",
    ] {
        assert!(page.contains(text), "{text}");
    }
    let none = Plan { fatigue: Vec::new(), wear: Vec::new(), ..plan() };
    assert!(!plan_html(&none).contains("Casing wear"));
}

fn event(name: &str, bit_depth_m: f64, quantities: &[(&'static str, &str, f64)]) -> PlanEvent {
    let peak = |(quantity, dimension, peak): &(&'static str, &str, f64)| PlanPeakRow {
        quantity,
        dimension: (*dimension).to_owned(),
        at_rest: 0.5 * peak,
        peak: *peak,
        time_s: 2.0,
        steady: 0.8 * peak,
        ratio: 1.25,
        overshoot: 2.0 / 3.0,
    };
    let times_s: Vec<f64> = (0..2000).map(|i| 0.01 * f64::from(i)).collect();
    let series = |dimension: &str| {
        let quantities = quantities.iter().find(|quantity| quantity.1 == dimension);
        let peak = quantities.map_or(f64::NAN, |quantity| quantity.2);
        let at = |time_s: &f64| if (time_s - 2.0).abs() < 0.005 { peak } else { 0.8 * peak };
        times_s.iter().map(at).collect::<Vec<f64>>()
    };
    PlanEvent {
        name: name.into(),
        level: 1,
        bit_depth_m,
        peaks: quantities.iter().map(peak).collect(),
        gel_Pa: (name == "breaking circulation").then_some(6e6),
        gel_lift_N: 2e4,
        hook_load_N: series("force"),
        torque_N_m: series("torque"),
        pump_Pa: series("pressure"),
        time_s: times_s,
        message: None,
    }
}

/// An event has a panel for each quantity that changes, with a curve and a ring for each depth, in
/// the colour of its depth; a single high sample keeps its height although the curve has fewer
/// points. The pressure that breaks the gel and a limit that is near are lines; the table gives the
/// reason for a missing answer.
#[test]
fn events_stand_against_time() {
    let lost = PlanEvent {
        message: Some("it <diverged>".into()),
        ..event("pick-up from slips", 500.0, &[])
    };
    let plan = Plan {
        events: vec![
            event("pick-up from slips", 1000.0, &[("hook load", "force", 5e5)]),
            event("pick-up from slips", 2000.0, &[("hook load", "force", 9e5)]),
            event(
                "breaking circulation",
                2000.0,
                &[("hook load", "force", 4e5), ("pump pressure", "pressure", 5e6)],
            ),
            lost,
        ],
        ..plan()
    };
    let plots = plan_plots(&plan, "si");
    let figure = &plots.last().expect("pictures").figure;
    let labels: Vec<&str> = figure.panels.iter().map(|panel| panel.axis.label.as_str()).collect();
    assert_eq!(
        labels,
        [
            "Pick-up from slips: hook load, kN",
            "Breaking circulation: hook load, kN",
            "Breaking circulation: pump pressure, MPa"
        ]
    );
    let [lifted, _, pumped] = &figure.panels[..] else { panic!("three panels") };
    let curves = lifted.marks.iter().filter_map(|mark| match mark {
        Mark::Curve { points, .. } => Some(points),
        _ => None,
    });
    let peaks = curves.map(|points| points.iter().map(|point| point.1).fold(0.0, f64::max));
    assert_eq!(peaks.collect::<Vec<_>>(), [500.0, 900.0]);
    // Hoist and pipe carry less.
    let borne = [(600.0, "hoist".to_owned()), (580.0, "pipe, tension".to_owned())];
    assert_eq!(rules(lifted), borne);
    assert_eq!(rules(pumped), [(6.0, "gel, 2000 m".to_owned())]);
    let page = plan_html(&plan);
    for text in [
        "Setting in motion",
        "to break the gel",
        "1.250",
        "66.7 %",
        "it &lt;diverged&gt;",
        "plan_peaks.csv",
    ] {
        assert!(page.contains(text), "{text}");
    }
    assert!(!plan_html(&super::Plan { events: Vec::new(), ..plan }).contains("plan_peaks"));
}
