//! Every column matches its declaration: a value in every row of the models that have it, except
//! where it is declared to be possibly `null`; none in rows of the others.

use std::{collections::BTreeSet, fs};

use wholestring::outcome::ModelKind;
use wholestring_results::{
    CONTACT, Column, ColumnSpec, Data, FRAMES, NODES, SPECTRA, TIME, Table, WEAR,
};

use crate::desk::{Desk, args};

/// A build and a tangent, tool joints and known strength, a flowing mud, a motor; all records over
/// time.
const DEVIATED: &str = r#"
name = "Deviated"
model = ["soft", "dynamic"]

[well]
stations = [[0, 0, 0], [100, 0, 0], [300, 60, 0], [700, 60, 0]]

[[well.hole]]
kind = "casing"
to = "350 m"
diameter = "222 mm"
friction = 0.25

[[well.hole]]
kind = "open"
to = "720 m"
diameter = "215.9 mm"
friction = 0.3

[mud]
density = "1.2 sg"
rheology = "bingham"
plastic_viscosity = "0.025 Pa.s"
yield_point = "7 Pa"

[steel]
density = "7850 kg/m3"
youngs_modulus = "210 GPa"
shear_modulus = "80 GPa"

[[string]]
component = "bit"
od = "215.9 mm"
id = "60 mm"
length = "0.3 m"

[[string]]
component = "drill collar"
od = "165 mm"
id = "71.4 mm"
length = "50 m"

[[string]]
component = "drill pipe"
catalogue = "5 in 19.50 lb/ft S-135"
length = "to surface"

[bit]
torque = "1 kN.m"

[bit.motor]
displacement = "0.012 m3"
max_differential_pressure = "6 MPa"

[operation]
kind = KINDS
bit_depth = "700 m"
rpm = 60
wob = "20 kN"
rop = "10 m/h"
trip_speed = "0.3 m/s"
flow_rate = "0.03 m3/s"
SCHEDULE

[mesh]
element_length = "9.6 m"

[dynamics]
duration = "1.2 s"
settle = "0.2 s"

[records]
frames = "5 Hz"
channels = ["position", "coordinates", "velocity", "rotation", "tilt", "contact", "friction", "force", "stress"]
spectra = ["surface_torque"]
node_spectra = ["tension"]
node_spectra_at = ["350 m"]
"#;

const KINDS: &str =
    r#"["trip_out", "trip_in", "rotate_off_bottom", "drill", "slide", "ream", "back_ream"]"#;

const NOTED: &str = r#"
[[operation.schedule]]
at = "0.1 s"
rpm = 70
note = "faster"
"#;

/// Tables by their names, and their columns.
const TABLES: [(&str, &[ColumnSpec]); 6] = [
    ("nodes", NODES),
    ("time", TIME),
    ("wear", WEAR),
    ("contact", CONTACT),
    ("frames", FRAMES),
    ("spectra", SPECTRA),
];

fn number(table: &Table, name: &str, row: usize) -> Option<f64> {
    table.numbers(name).expect(name)[row]
}

/// Whether a column has a value in a row; a number is finite.
fn has_value(column: &Column, row: usize) -> bool {
    match &column.data {
        Data::Number(values) => values[row].is_some_and(f64::is_finite),
        Data::Text(words) => !words[row].is_empty(),
    }
}

/// The model of a row; the dynamics for a table without that column.
fn model(models: Option<&[String]>, row: usize) -> ModelKind {
    match models.map(|models| models[row].as_str()) {
        Some("soft") => ModelKind::Soft,
        Some("dynamic") | None => ModelKind::Dynamic,
        Some(other) => panic!("a model `{other}`"),
    }
}

/// Whether a column that may be `null` must be, as far as the row itself determines it.
fn must_be_null(table: &Table, column: &str, row: usize) -> Option<bool> {
    match column {
        "climb_rad" => Some(number(table, "contact_fraction", row) == Some(0.0)),
        _ => None,
    }
}

/// Checks a table of a folder against its declaration, and records by table, column and model
/// whether there was a value.
fn check(
    desk: &Desk,
    folder: &str,
    (name, specs): (&'static str, &'static [ColumnSpec]),
    seen: &mut BTreeSet<(&'static str, &'static str, &'static str)>,
) {
    let path = desk.path(folder).join(format!("{name}.parquet"));
    if !path.is_file() {
        assert!(matches!(name, "frames" | "spectra"), "no {name} in {folder}");
        return;
    }
    let table = Table::read_parquet(&path).unwrap();
    let models = table.words("model");
    assert_eq!(table.columns().len(), specs.len(), "{name}");
    for spec in specs {
        let column = table.column(spec.name).unwrap_or_else(|| panic!("no `{}`", spec.name));
        for row in 0..table.rows() {
            let model = model(models, row);
            let place = || format!("`{}` of {name} in {folder}, {model:?}, row {row}", spec.name);
            let has = has_value(column, row);
            if !spec.is_known_by(model) {
                assert!(!has, "{} has a value", place());
                continue;
            }
            match spec.null_where {
                None => assert!(has, "{} has none", place()),
                Some(_) => {
                    if let Some(null) = must_be_null(&table, spec.name, row) {
                        assert_eq!(!has, null, "{}", place());
                    }
                }
            }
            if has {
                seen.insert((name, spec.name, model.name()));
            }
        }
    }
}

/// Runs of every operation with both models: plain pipe in a straight hole, a string with joints in
/// a deviated one, and one with a schedule.
fn solved() -> Desk {
    let desk = Desk::new();
    let write = |name: &str, kinds: &str, schedule: &str| {
        let text = DEVIATED.replace("KINDS", kinds).replace("SCHEDULE", schedule);
        fs::write(desk.path(name), text).unwrap();
    };
    write("deviated.toml", KINDS, "");
    write("scheduled.toml", "\"rotate_off_bottom\"", NOTED);
    let kinds = format!("operation.kind={KINDS}");
    let short = args("--set 'dynamics.duration=0.1 s' --set 'dynamics.settle=0.1 s'");
    let plain = [&["run", "slant.toml", "-o", "plain", "--set", &kinds], &short[..]].concat();
    for arguments in [
        &plain[..],
        &["run", "deviated.toml", "-o", "deviated"],
        &["run", "scheduled.toml", "-o", "scheduled"],
    ] {
        desk.done(arguments);
    }
    desk
}

#[test]
fn every_column_has_what_it_declares() {
    let desk = solved();
    let mut seen = BTreeSet::new();
    for folder in ["plain", "deviated", "scheduled"] {
        for table in TABLES {
            check(&desk, folder, table, &mut seen);
        }
    }
    // A column that may be `null` is not always so, in rows of any model that has it.
    for (name, specs) in TABLES {
        let tells_models = specs.iter().any(|spec| spec.name == "model");
        for spec in specs {
            for model in [ModelKind::Soft, ModelKind::Dynamic] {
                if spec.is_known_by(model) && (tells_models || model == ModelKind::Dynamic) {
                    let had = seen.contains(&(name, spec.name, model.name()));
                    assert!(had, "`{}` of {name} never has a value, {model:?}", spec.name);
                }
            }
        }
    }
    // Plain pipe of unknown strength has no joints and no utilization; the other string's pipe has
    // both.
    for (folder, expected) in [("plain", false), ("deviated", true)] {
        let nodes = desk.table(&format!("{folder}/nodes.parquet"));
        for name in ["side_force_per_joint_N", "yield_use"] {
            let any = (0..nodes.rows()).any(|row| number(&nodes, name, row).is_some());
            assert_eq!(any, expected, "{name} in {folder}");
        }
    }
    for folder in ["plain", "deviated"] {
        for solved in desk.summary(folder).operations {
            let scalars = &solved.scalars;
            let place = format!("{} of {:?} in {folder}", solved.operation, solved.model);
            let finite = [
                scalars.hook_load_N,
                scalars.surface_torque_N_m,
                scalars.friction_torque_N_m,
                scalars.axial_friction_N,
                scalars.side_force_total_N,
                scalars.weight_on_bit_N,
                scalars.bit_torque_N_m,
                scalars.twist_rad,
                scalars.stretch_m,
            ];
            assert!(finite.iter().all(|value| value.is_finite()), "{place}");
            let deviated = folder == "deviated";
            assert_eq!(solved.hydraulics.is_some(), deviated, "{place}");
            // Such depths exist only with a build and a loaded bit.
            assert_eq!(scalars.cutoff_depth_m.is_some(), deviated, "{place}");
            if deviated && scalars.weight_on_bit_N > 0.0 {
                assert!(scalars.neutral_point_m.is_some(), "{place}");
            }
        }
    }
}
