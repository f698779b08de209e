//! Study files: their contents, and the messages for mistakes.

#[path = "../../case/tests/common/change.rs"]
#[allow(dead_code, reason = "a table of texts is for others")]
mod change;

use change::changes;
use wholestring_case::Report;
use wholestring_study::{ColumnName, FigureData, Pointing, Source, Statistic, Study, parse};
use wholestring_units::Dimension;

const EXAMPLE: &str = r#"name = "Example"
description = "What it asks."

[[sweep]]
name = "deep"
case = "well.toml"
set = { rpm = 70, well.mud = 1 }
vary = { bit_depth = "300m..1500m/300m", friction = [0.1, 0.3] }

[[sweep.where]]
when = { bit_depth = "..600 m", friction = 0.3 }
case = "shallow.toml"
set = { "mesh.element_length" = "5 m" }

[[sweep]]
name = "soft"
case = "well.toml"
vary = { friction = "0.1..0.4/0.1", bit_depth = ["1200 m", "1.5 km"] }

[[figure]]
title = "Torque"
only = { friction = 0.3 }
x = "bit_depth"
y = "torque_N_m"
statistic = ["mean", "std"]

[[figure.level]]
label = "rated"
value = "45 kN.m"

[[figure]]
title = "Contact"
name = "contact"
sweeps = "deep"
from = "frames"
x = "time_s"
y = "|contact_force_N|"
depths = "600 m"
window = ["0 s", "10 s"]

[[figure]]
title = "Map"
sweeps = ["deep"]
from = "contact"
x = "time_s"
y = "md_m"
colour = "|side_force_N_per_m|"

[[table]]
title = "Numbers"
only = { bit_depth = "1500 m", friction = 0.3 }

[[table.row]]
label = "torque"
column = "torque_N_m"
expected = "34.6 kN.m"
tolerance = "8 %"

[[table.row]]
label = "more friction, more torque"
column = "torque_N_m"
over = { friction = 0.1 }
at_least = 2
at_most = 3

[[table.row]]
label = "hardest contact"
sweeps = ["deep"]
from = "frames"
column = "|contact_force_N|"
depth = "600 m"
statistic = "p98"

[[table.row]]
label = "side force where it touches"
sweeps = ["deep"]
from = "contact"
column = "side_force_N_per_m"
depth = "650 m"
"#;

const COLUMNS: &[ColumnName] = &[
    column(Source::Summary, "torque_N_m", Dimension::Torque),
    column(Source::Summary, "hook_load_N", Dimension::Force),
    column(Source::Nodes, "md_m", Dimension::Length),
    column(Source::Nodes, "tension_N", Dimension::Force),
    column(Source::Frames, "time_s", Dimension::Time),
    column(Source::Frames, "md_m", Dimension::Length),
    column(Source::Frames, "contact_force_N", Dimension::Force),
    column(Source::Contact, "time_s", Dimension::Time),
    column(Source::Contact, "md_m", Dimension::Length),
    column(Source::Contact, "side_force_N_per_m", Dimension::ForcePerLength),
];

const fn column(source: Source, name: &'static str, dimension: Dimension) -> ColumnName {
    ColumnName { source, name, dimension: Some(dimension) }
}

fn read(text: &str) -> Result<Study, Report> {
    parse("study.toml", text.as_bytes(), COLUMNS)
}

/// The example with one text replaced by another; it must contain the text exactly once.
fn changed(from: &str, to: &str) -> String {
    assert_eq!(EXAMPLE.matches(from).count(), 1, "`{from}` must stand once in the example");
    EXAMPLE.replace(from, to)
}

#[test]
fn an_example_is_read_as_it_is_meant() {
    let study = read(EXAMPLE).unwrap_or_else(|report| panic!("{report}"));
    assert!(study.warnings.is_empty(), "{}", study.warnings);
    let [deep, soft] = &study.sweeps[..] else { panic!("two sweeps") };
    let set: Vec<_> = deep.set.iter().map(|set| (set.key.as_str(), set.value.as_str())).collect();
    assert_eq!(set, [("rpm", "70"), ("well.mud", "1")]);
    let values =
        |index: usize| deep.vary[index].values.iter().map(|value| value.bare()).collect::<Vec<_>>();
    assert_eq!(values(0), ["300m", "600m", "900m", "1200m", "1500m"]);
    assert_eq!(values(1), ["0.1", "0.3"]);
    assert_eq!(soft.vary[0].values.len(), 4);

    let keys = ["bit_depth".to_owned(), "friction".to_owned()];
    let has = |depth: &str, friction: &str| {
        deep.exceptions[0].when.has(&keys, &[depth.to_owned(), friction.to_owned()])
    };
    assert!(has("300m", "0.3") && has("600m", "0.30"));
    assert!(!has("900m", "0.3") && !has("300m", "0.1"));

    let FigureData::Summary { x, statistics } = &study.figures[0].data else {
        panic!("a point for each case")
    };
    assert_eq!(x.number("1.5 km"), Some(1500.0));
    assert_eq!(statistics[..], [Statistic::Mean, Statistic::Std]);
    assert_eq!(study.figures[0].name, "figure-01");
    assert_eq!(study.figures[0].levels[0].value, 45e3);
    assert_eq!(study.figures[0].chosen.sweeps, [0, 1]);
    assert!(study.figures[1].y[0].magnitude);
    let FigureData::Map { colour, window_s } = &study.figures[2].data else {
        panic!("a map for each case")
    };
    assert!(colour.magnitude && colour.column.source == Source::Contact);
    assert_eq!(*window_s, None);

    let rows = &study.tables[0].rows;
    let limits = rows[0].wanted;
    assert!((limits.least.unwrap() - 0.92 * 34.6e3).abs() < 1e-6);
    assert!((limits.most.unwrap() - 1.08 * 34.6e3).abs() < 1e-6);
    assert_eq!(rows[1].dimension(), None);
    assert_eq!(rows[2].chosen.sweeps, [0]);
    assert_eq!(rows[2].number.statistic, Statistic::Percentile(98.0));
    assert_eq!(rows[3].number.depth_m, Some(650.0));
}

/// `x` points across the page unless it is set to point down.
#[test]
fn an_axis_points_down_where_that_is_asked_for() {
    let across = read(EXAMPLE).unwrap_or_else(|report| panic!("{report}"));
    let text = EXAMPLE.replacen("x = \"bit_depth\"", "x = \"bit_depth\"\nx_axis = \"down\"", 1);
    let down = read(&text).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(across.figures[0].x_axis, Pointing::Across);
    assert_eq!(down.figures[0].x_axis, Pointing::Down);
    assert_eq!(down.figures[1].x_axis, Pointing::Across);
}

#[test]
fn mistakes_get_an_answer() {
    let refused = |name: &str, text: &str| match read(text) {
        Ok(_) => panic!("`{name}` was accepted"),
        Err(report) => on_record(name, &report),
    };
    refused("no_sweep", "name = \"nothing\"\n");
    refused("empty", "");
    for (name, from, to) in changes(
        r#"
        key_misspelt: `description =` -> `descripton =`
        key_of_another_table: `description =` -> `expected = 1\ndescription =`
        sweep_unknown: `sweeps = "deep"` -> `sweeps = "depe"`
        sweep_twice: `name = "soft"` -> `name = "Deep"`
        range_without_step: `300m..1500m/300m` -> `300m..1500m`
        value_twice: `[0.1, 0.3]` -> `[0.1, 0.1]`
        no_values: `[0.1, 0.3]` -> `[]`
        where_of_no_case: `"..600 m", friction = 0.3` -> `"..100 m"`
        where_of_another_key: `"..600 m", friction = 0.3` -> `"..600 m", fricton = 0.3`
        where_backwards: `"..600 m", friction = 0.3` -> `"900 m..600 m"`
        x_axis_unknown: `statistic = ["mean", "std"]` -> `x_axis = "up"`
        axis_not_varied: `x = "bit_depth"` -> `x = "rpm"`
        column_unknown: `y = "torque_N_m"` -> `y = "torqe_N_m"`
        column_of_another_table: `y = "torque_N_m"` -> `y = "tension_N"`
        columns_of_two_units: `y = "torque_N_m"` -> `y = ["torque_N_m", "hook_load_N"]`
        statistic_unknown: `["mean", "std"]` -> `"sdt"`
        percentile_of_a_summary: `["mean", "std"]` -> `"p98"`
        level_of_another_unit: `value = "45 kN.m"` -> `value = "45 kN"`
        window_backwards: `["0 s", "10 s"]` -> `["10 s", "0 s"]`
        frames_without_place: `depths = "600 m"\n` -> ``
        map_without_colour: `colour = "|side_force_N_per_m|"\n` -> ``
        map_upside_down: `y = "md_m"` -> `y = "time_s"`
        map_of_an_unknown_colour: `|side_force_N_per_m|` -> `side_force_N`
        case_open: `only = { bit_depth = "1500 m", friction = 0.3 }` -> `only = { friction = 0.3 }`
        other_case_unknown: `over = { friction = 0.1 }` -> `over = { friction = 0.9 }`
        tolerance_of_nothing: `tolerance = "8 %"` -> `tolerance = 0`
        ratio_with_a_unit: `at_least = 2` -> `at_least = "2 kN"`
        shape_without_key: `at_least = 2` -> `shape = "growth"\nat_least = 2`
        file_name_unsound: `name = "contact"` -> `name = "a/b"`
        "#,
    ) {
        refused(name, &changed(&from, &to));
    }
    for (name, from, to) in changes(
        r#"
        statistic_of_frames: `window = ["0 s", "10 s"]` -> `statistic = "std"`
        tolerance_of_no_number: `at_least = 2\n` -> `tolerance = "1 %"\n`
        x_axis_of_a_map: `colour = "|side_force_N_per_m|"\n`
            -> `colour = "side_force_N_per_m"\nx_axis = "down"\n`
        colour_of_frames: `window = ["0 s", "10 s"]` -> `colour = "md_m"`
        times_of_a_map: `colour = "|side_force_N_per_m|"\n`
            -> `colour = "side_force_N_per_m"\ntimes = "1 s"\n`
        depth_of_a_summary: `at_least = 2\n` -> `depth = "10 m"\n`
        "#,
    ) {
        let study = read(&changed(&from, &to)).unwrap_or_else(|report| panic!("{name}: {report}"));
        on_record(name, &study.warnings);
    }
}

fn on_record(name: &str, report: &Report) {
    assert!(!report.is_empty(), "{name}");
    let mut settings = insta::Settings::clone_current();
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_snapshot_path("snapshots/study");
    settings.bind(|| insta::assert_snapshot!(name, report.render(false)));
}

/// Every key is described.
#[test]
fn the_schema_says_what_keys_mean() {
    fn visit(schema: &serde_json::Value) {
        for (key, value) in schema["properties"].as_object().into_iter().flatten() {
            let description = value["description"].as_str().unwrap_or_default();
            assert!(!description.is_empty(), "{key}");
            visit(value);
            visit(&value["items"]);
        }
    }
    visit(&wholestring_study::schema());
}
