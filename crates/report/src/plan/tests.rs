use std::collections::BTreeMap;

use super::{
    BucklingCurve, Plan, PlanCurve, PlanFatigueHourRow, PlanFatigueRow, PlanLevel, PlanLimitRow,
    PlanMud, PlanMudRow, PlanRig, PlanSpot, PlanWearRow, plan_html, plan_plots,
};
use crate::{
    Cell, DisplayUnit, Fact, Level, PageHead, Section,
    figure::{Mark, Panel},
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
    let curve = |operation: &str, level: usize| {
        let pull = match operation {
            "trip_out" => level as f64,
            "trip_in" => -(level as f64),
            _ => 0.0,
        };
        let points = depths.map(|bit_depth_m| {
            let lost = operation == "trip_in" && level == 2 && bit_depth_m > 1500.0;
            let value = |value: f64| if lost { f64::NAN } else { value };
            PlanSpot {
                bit_depth_m,
                hook_load_N: value(200.0 * bit_depth_m * (1.0 + 0.2 * pull)),
                torque_N_m: value(if operation == "drill" { 5.0 * bit_depth_m } else { 0.0 }),
                buckling: if lost { String::new() } else { "none".into() },
                worst: (operation == "trip_in")
                    .then(|| ("helical_buckling".into(), Level::Warning)),
                message: lost.then(|| "the string <locks> up".to_owned()),
            }
        });
        PlanCurve {
            model: "soft".into(),
            operation: operation.into(),
            level,
            points: points.into(),
        }
    };
    let operations = ["trip_out", "trip_in", "rotate_off_bottom", "drill"];
    Plan {
        head: PageHead {
            program: "wholestring".into(),
            title: "<Well> & \"plan\"".into(),
            units: "si".into(),
            dimensions: BTreeMap::from(units),
            facts: vec![Fact { label: "Depths".into(), value: Cell::Text("3".into()) }],
        },
        message: None,
        models: vec!["soft".into()],
        levels: levels
            .map(|(name, label)| PlanLevel {
                name: name.into(),
                label: label.into(),
                sections: vec![format!("casing {label}")],
            })
            .collect(),
        curves: operations.iter().flat_map(|of| [0, 1, 2].map(|level| curve(of, level))).collect(),
        buckling: ["drill", "slide"]
            .iter()
            .flat_map(|of| {
                [0, 1, 2].map(|level| BucklingCurve {
                    operation: (*of).into(),
                    level,
                    points: depths.map(|depth| (depth, [4e4, 6e4])).into(),
                })
            })
            .collect(),
        mud: Some(PlanMud {
            operation: "drill".into(),
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
        rig: PlanRig { block_N: Some(2e5), hoist_N: Some(8e5), top_drive_N_m: Some(1e6) },
        limits: vec![limit("Tension", 1.05, "short"), limit("Hoist", 1.2, "near")],
        unchecked: vec!["no make-up torque of pipe".into()],
        fatigue: vec![fatigue("drill <pipe>", 1.2), fatigue("collar", 1e-7)],
        wear: vec![wear()],
        weight_on_bit_N: Some(3e4),
    }
}

fn fatigue(component: &str, damage: f64) -> PlanFatigueRow {
    let hour = PlanFatigueHourRow {
        md_m: 700.4,
        damage_per_hour: 0.01,
        bending_Pa: 1.2e8,
        doglegs_rad_per_m: [0.0017, f64::NAN],
    };
    let hour = (damage > 1.0).then_some(hour);
    PlanFatigueRow { model: "soft".into(), component: component.into(), damage, hour }
}

fn wear() -> PlanWearRow {
    PlanWearRow {
        model: "soft".into(),
        section: 1,
        md_m: 802.5,
        groove_m: 0.0062,
        wall_left_m: 0.0058,
        worn: 0.517,
        burst_Pa: [5e7, 2.4e7],
        collapse_Pa: [f64::NAN; 2],
    }
}

fn limit(kind: &str, factor: f64, standing: &str) -> PlanLimitRow {
    PlanLimitRow {
        kind: kind.into(),
        operation: "trip_out".into(),
        friction: "high".into(),
        bit_depth_m: 2000.0,
        component: "drill <pipe>".into(),
        md_m: (kind == "Tension").then_some(0.0),
        load: 1e6,
        capacity: 1e6 * factor,
        dimension: "force".into(),
        factor,
        required: 1.0 / 0.9,
        standing: standing.into(),
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

/// Each operation has a line for each friction, with the friction at its end, which is where the last
/// answer is; lines that are one have none. The hoist's limit is without its block, and drawn where it
/// is near.
#[test]
fn lines_end_with_their_friction() {
    let plots = plan_plots(&plan(), "si");
    let known: Vec<&str> = plots.iter().map(|of| of.name.as_str()).collect();
    assert_eq!(known, ["hook_load", "torque", "buckling_weight", "hydraulics"]);
    let [off, on] = &plots[0].figure.panels[..] else { panic!("two panels") };
    assert_eq!(off.axis.label, "Hook load, off bottom, kN");
    let found = names(off);
    assert_eq!(found.len(), 6, "{found:?}");
    assert_eq!(found[2], ((2000.0, 560.0), "0.3"));
    assert_eq!(found[5], ((1000.0, 120.0), "0.3"));
    let hoist = |mark: &&Mark| matches!(mark, Mark::OwnRule { at, .. } if *at == 600.0);
    assert_eq!(off.marks.iter().filter(hoist).count(), 1);
    assert!(names(on).is_empty());
    let shoes = plots[0].figure.hole.iter().filter(|of| of.shoe);
    assert_eq!(shoes.map(|of| of.to).collect::<Vec<_>>(), [900.0]);
    // A top drive that is far from its limit is told.
    assert!(
        plots[1].figure.subtitle.contains("top drive 1000 kN·m"),
        "{}",
        plots[1].figure.subtitle
    );
    // In the reader's units.
    let field = plan_plots(&plan(), "field");
    assert_eq!(field[0].figure.panels[0].axis.label, "Hook load, off bottom, klbf");
}

/// Pressure beside the densities at bit and shoe, five states each and the mud at rest; a limit that is
/// far beyond is told. Without a rheology there is nothing.
#[test]
fn the_mud_beside_it() {
    let mut plan = plan();
    let plots = plan_plots(&plan, "field");
    let figure = &plots[3].figure;
    let labels: Vec<&str> = figure.panels.iter().map(|of| of.axis.label.as_str()).collect();
    assert_eq!(
        labels,
        [
            "Standpipe pressure, drilling, psi",
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

/// The page has the pictures, the tables, what is found and why something has no answer, and nothing in
/// it becomes markup.
#[test]
fn the_page_says_everything() {
    let page = plan_html(&plan());
    for expected in [
        "Hook load",
        "Surface torque, kN·m, soft string",
        "slack-off 0.1",
        "warning: helical buckling",
        "the string &lt;locks&gt; up",
        "plan_broomstick.parquet",
        "href=\"hook_load.csv\"",
        "href=\"plan.xlsx\"",
        "With the bit at 2000 m",
        "<td class=\"differs\">1.05\u{a0}short</td>",
        "<td class=\"words near\">near</td>",
        "drill &lt;pipe&gt;, 0\u{a0}m",
        "Not all was checked: no make-up torque of pipe.",
    ] {
        assert!(page.contains(expected), "{expected}");
    }
    // In three sets of units.
    assert_eq!(page.matches("<svg").count(), 3 * 4);
    assert!(page.contains("Surface torque, ft·lbf, soft string"));
    assert!(!page.contains("<Well>") && !page.contains("<locks>"));
}

/// What is used up says so in a word, what is not known too; numbers are in the reader's units.
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
