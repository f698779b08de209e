//! Interface for scripts: the keys of `summary.json` and the columns of the tables, for every
//! operation and model. A key may be added; a removed or retyped one breaks them.

use std::{collections::BTreeSet, fs, path::Path};

use crate::desk::{Desk, args};
use serde_json::Value;
use wholestring_results::CheckKind;
use wholestring_results::{Data, Table};

const OPERATIONS: [&str; 7] =
    ["trip_out", "trip_in", "rotate_off_bottom", "drill", "slide", "ream", "back_ream"];

/// Numbers of every operation.
const SCALARS: [&str; 10] = [
    "bit_depth_m",
    "weight_on_bit_N",
    "bit_torque_N_m",
    "hook_load_N",
    "surface_torque_N_m",
    "friction_torque_N_m",
    "axial_friction_N",
    "side_force_total_N",
    "twist_rad",
    "stretch_m",
];

/// Numbers, or `null` if there is none.
const DEPTHS: [&str; 2] = ["neutral_point_m", "cutoff_depth_m"];

const STATISTIC: [&str; 9] =
    ["mean", "std", "min", "max", "p05", "p95", "std_error", "drift", "drifts"];

const NUMERICS: [&str; 11] = [
    "elements",
    "time_step_s",
    "steps",
    "added_axial_mass_fraction",
    "max_penetration_m",
    "energy_residual",
    "wall_time_s",
    "real_time_factor",
    "settle_s",
    "mean_bit_depth_m",
    "bit_travel_m",
];

/// A run of every operation with both models.
fn solved() -> Desk {
    let desk = Desk::new();
    let kinds = format!("operation.kind={OPERATIONS:?}");
    let short = args(
        "run slant.toml -o results --set 'dynamics.duration=0.1 s' --set 'dynamics.settle=0.1 s'",
    );
    desk.done(&[&short[..], &["--set", &kinds]].concat());
    desk
}

fn keys(object: &Value) -> BTreeSet<&str> {
    object.as_object().expect("an object").keys().map(String::as_str).collect()
}

#[test]
fn keys_of_the_summary() {
    let desk = solved();
    let text = fs::read(desk.path("results/summary.json")).unwrap();
    let summary: Value = serde_json::from_slice(&text).unwrap();
    let top = ["schema_version", "engine_version", "case", "identity", "settings", "operations"];
    assert_eq!(keys(&summary), top.into());
    assert_eq!(summary["schema_version"], 3);
    assert_eq!(summary["case"], "Straight slant");
    // A default that is not in the case.
    assert_eq!(summary["settings"]["dynamics"]["seed"], 1);

    let operations = summary["operations"].as_array().unwrap();
    let found: Vec<(&str, &str)> = operations
        .iter()
        .map(|o| (o["operation"].as_str().unwrap(), o["model"].as_str().unwrap()))
        .collect();
    let expected: Vec<(&str, &str)> =
        OPERATIONS.iter().flat_map(|name| [(*name, "soft"), (*name, "dynamic")]).collect();
    assert_eq!(found, expected);

    for operation in operations {
        let mut expected: BTreeSet<&str> =
            ["model", "operation", "status", "friction", "checks"].into();
        expected.extend(SCALARS);
        expected.extend(DEPTHS);
        let dynamic = operation["model"] == "dynamic";
        if dynamic {
            expected.extend(["statistics", "indicators", "numerics"]);
        }
        if operation.get("unchecked").is_some() {
            expected.insert("unchecked");
        }
        assert_eq!(keys(operation), expected);
        check_checks(&operation["checks"]);
        assert_eq!(operation["status"], "complete");
        assert_eq!(operation["friction"], 0.25);
        assert_eq!(operation["bit_depth_m"], 600.0);
        for key in SCALARS {
            assert!(operation[key].is_number(), "{key}: {operation}");
        }
        for key in DEPTHS {
            let value = &operation[key];
            assert!(value.is_number() || value.is_null(), "{key}: {value}");
        }
        if dynamic {
            check_dynamic(operation);
        }
    }
}

/// Findings have the same keys whatever their kind, and the kinds are those of the engine.
fn check_checks(checks: &Value) {
    let keys_of_all = [
        "kind",
        "severity",
        "verdict",
        "component",
        "md_m",
        "to_md_m",
        "value",
        "limit",
        "factor",
        "required",
        "unit",
        "sentence",
    ];
    for check in checks.as_array().expect("a list") {
        // A sentence without a quantity has no parts.
        let mut own = keys(check);
        own.remove("parts");
        assert_eq!(own, keys_of_all.into());
        let mut kinds = CheckKind::ALL.iter();
        let kind = kinds.find(|kind| check["kind"] == kind.name()).expect("a kind");
        assert_eq!(check["unit"], kind.unit());
        assert!(["ok", "note", "warning", "error"].map(Value::from).contains(&check["severity"]));
        for key in ["md_m", "to_md_m", "value", "limit", "factor", "required"] {
            assert!(check[key].is_number() || check[key].is_null(), "{check}");
        }
        assert_eq!(check["factor"].is_number(), kind.is_limit(), "{check}");
        assert!(check["sentence"].as_str().is_some_and(|words| !words.is_empty()), "{check}");
    }
}

fn check_dynamic(operation: &Value) {
    let numerics = &operation["numerics"];
    for key in NUMERICS {
        assert!(numerics[key].is_number(), "{key}: {numerics}");
    }
    for key in ["elements", "steps"] {
        assert!(numerics[key].as_u64().unwrap() > 0, "{key}: {numerics}");
    }
    let statistics = &operation["statistics"];
    // All means of the operation.
    for key in SCALARS.iter().filter(|key| **key != "bit_depth_m") {
        let statistics = &statistics[key];
        assert_eq!(keys(statistics), STATISTIC.into(), "{key}");
        let value = |name: &str| statistics[name].as_f64().unwrap();
        assert_eq!(statistics["mean"], operation[key], "{key}");
        let order = ["min", "p05", "p95", "max"].map(value);
        assert!(order.is_sorted(), "{key}: {statistics}");
        // Except for the rounding of a mean of equal numbers.
        let rounding = 1e-9 * value("mean").abs();
        assert!(value("mean") >= value("min") - rounding, "{key}: {statistics}");
        assert!(value("mean") <= value("max") + rounding, "{key}: {statistics}");
        assert!(value("std") >= 0.0, "{key}: {statistics}");
        assert!(value("std_error") >= 0.0 && value("drift").is_finite(), "{key}: {statistics}");
        assert!(statistics["drifts"].is_boolean(), "{key}: {statistics}");
    }
}

/// Checks that a table has these columns, each of them filled, and only finite numbers.
fn check_table(path: &Path, texts: &[&str], numbers: &[&str]) -> usize {
    let table = Table::read_parquet(path).unwrap();
    for name in texts {
        assert!(table.words(name).is_some(), "{name}");
    }
    for name in numbers {
        let values = table.numbers(name).expect(name);
        assert!(values.iter().all(Option::is_some), "gaps in `{name}`");
    }
    for column in table.columns() {
        if let Data::Number(values) = &column.data {
            let finite = values.iter().flatten().all(|value| value.is_finite());
            assert!(finite, "`{}` holds a number that is none", column.name);
        }
    }
    table.rows()
}

#[test]
fn columns_of_the_tables() {
    let desk = solved();
    let nodes = check_table(
        &desk.path("results/nodes.parquet"),
        &["model", "operation"],
        &["md_m", "tension_N", "torque_N_m", "side_force_N_per_m", "contact_fraction"],
    );
    assert!(nodes > 14 * 100, "{nodes} rows");
    let mut scalars: Vec<&str> = SCALARS.to_vec();
    scalars.push("time_s");
    let rows = check_table(&desk.path("results/time.parquet"), &["operation"], &scalars);
    assert!(rows >= 7 * 18, "{rows} rows");
}

/// Machine files are SI, whatever the units on the screen.
#[test]
fn units_of_the_screen_leave_the_files_alone() {
    let desk = Desk::new();
    let run = |units: &str| {
        let soft = ["--set", "model=soft", "--csv", "-o", units];
        desk.done(&[&["run", "slant.toml", "--units", units], &soft[..]].concat());
        ["summary.json", "nodes.csv", "nodes.parquet", "time.csv"]
            .map(|name| fs::read(desk.path(units).join(name)).unwrap())
    };
    let si = run("si");
    assert_eq!(run("field"), si);
    assert_eq!(run("metric"), si);
}

/// If standard error is closed, the exit status still reports the error.
#[cfg(target_os = "linux")]
#[test]
fn an_error_that_nobody_hears() {
    let desk = Desk::new();
    let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let mut command = desk.command(&["check", "slant.toml", "--set", "frction=0.1"]);
    assert_eq!(command.stderr(full).status().unwrap().code(), Some(2));
}
