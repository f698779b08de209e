//! `summary.json` against its contract.

use std::{collections::BTreeMap, fs, path::Path};

use serde_json::{Value, json};
use wholestring::{
    dynamics::{
        self, EnergyBalance, Indicators, StickSlip, TableUse, TorqueUse, TunedHookLoad, Whirl,
    },
    mud::Hydraulics,
    operation::OperationKind,
    outcome::{ModelKind, Scalars},
};
use wholestring_results::{
    ENGINE_VERSION, Friction, Numerics, OperationSummary, SCHEMA_VERSION, Statistic, Status,
    Summary, digest,
};

const SCALARS: Scalars = Scalars {
    hook_load_N: 1.0,
    surface_torque_N_m: 2.0,
    friction_torque_N_m: 3.0,
    axial_friction_N: 4.0,
    side_force_total_N: 5.0,
    weight_on_bit_N: 6.0,
    bit_torque_N_m: 7.0,
    twist_rad: 8.0,
    stretch_m: 9.0,
    neutral_point_m: Some(10.0),
    cutoff_depth_m: None,
};

/// A check as in the file.
fn buckled() -> Value {
    json!({
        "kind": "helical_buckling", "severity": "warning", "verdict": "exceeded",
        "component": "5 in drill pipe", "md_m": 50.0, "to_md_m": 3350.0, "value": 190e3,
        "limit": 95e3, "factor": 0.5, "required": 1.0, "unit": "N",
        "sentence": "Buckled to a helix", "parts": []
    })
}

fn soft() -> OperationSummary {
    OperationSummary {
        model: ModelKind::Soft,
        operation: OperationKind::Drill,
        status: Status::Complete,
        friction: Friction::of(&[0.3, 0.3]),
        bit_depth_m: 4305.0,
        scalars: SCALARS,
        checks: Vec::new(),
        unchecked: Vec::new(),
        lift: None,
        hydraulics: None,
        at_rest: None,
        statistics: None,
        indicators: None,
        bit_table: None,
        numerics: None,
    }
}

fn dynamic() -> OperationSummary {
    let statistic = Statistic {
        mean: 1.0,
        std: 2.0,
        min: 3.0,
        max: 4.0,
        p05: 5.0,
        p95: 6.0,
        std_error: 0.5,
        drift: -0.25,
        drifts: true,
    };
    OperationSummary {
        model: ModelKind::Dynamic,
        status: Status::Failed("the string flew off at 3.2 s".into()),
        friction: Friction::of(&[0.2, 0.3]),
        checks: vec![serde_json::from_value(buckled()).expect("a check")],
        lift: Some(TunedHookLoad { hook_load_N: 7e5, weight_on_bit_N: 59.9e3, runs: 5 }),
        hydraulics: Some(Hydraulics {
            mud_drag_N: 1.0,
            mud_torque_N_m: 2.0,
            jet_thrust_N: 3.0,
            bore_loss_Pa: 4.0,
            bit_loss_Pa: 5.0,
            motor_loss_Pa: 7.0,
            annulus_loss_Pa: 6.0,
            pump_pressure_Pa: 22.0,
        }),
        statistics: Some(BTreeMap::from([("hook_load_N".into(), statistic)])),
        indicators: Some(Indicators {
            stick_slip: Some(StickSlip {
                severity: Some(1.25),
                torque_severity: Some(0.5),
                period_s: None,
                stuck_fraction: 0.25,
                bit_speed_max_rad_per_s: 16.0,
            }),
            backward_whirl: Some(Whirl {
                md_m: 4290.0,
                rate_rad_per_s: -24.0,
                ratio: -3.0,
                length_fraction: 0.125,
            }),
            forward_whirl: None,
            top_drive: Some(TorqueUse { p95: 0.5, max: 0.75 }),
        }),
        bit_table: Some(TableUse {
            outside_fraction: 0.25,
            weights_N: [10e3, 90e3],
            table_weights_N: [20e3, 80e3],
            speeds_rad_per_s: [0.0, 12.0],
            table_speeds_rad_per_s: [4.0, 10.0],
        }),
        numerics: Some(Numerics {
            run: dynamics::Numerics {
                elements: 1350,
                time_step_s: 2e-4,
                assembly_steps: None,
                steps: 400_000,
                added_axial_mass_fraction: 0.003,
                max_penetration_m: 1e-5,
                deepest_contact: None,
                energy_residual: 1e-4,
                energy: Some(EnergyBalance {
                    hoist_work_J: 5.0,
                    gravity_change_J: 4.0,
                    friction_loss_J: 1.0,
                    ..EnergyBalance::default()
                }),
                instructions: "avx2".into(),
                settle_s: 12.5,
                settled: Some(true),
                mean_bit_depth_m: 4305.5,
                bit_travel_m: 1.5,
                buckled_element: None,
            },
            wall_time_s: 2.5,
            real_time_factor: 32.0,
        }),
        ..soft()
    }
}

fn summary(operations: Vec<OperationSummary>) -> Summary {
    Summary {
        schema_version: SCHEMA_VERSION,
        engine_version: Some(ENGINE_VERSION.into()),
        case: "NP13-X1042 at total depth".into(),
        identity: Some(digest(&json!({"mesh": 3.2}))),
        settings: json!({"mesh": {"element_length": "3.2 m"}}),
        operations,
    }
}

fn written(summary: &Summary) -> Value {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("summary.json");
    summary.write(&path).unwrap();
    assert_eq!(&Summary::read(&path).unwrap(), summary);
    serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap()
}

#[test]
fn the_keys_are_the_contract() {
    let file = written(&summary(vec![soft(), dynamic()]));
    let mut expected = json!({
        "schema_version": 3,
        "engine_version": env!("CARGO_PKG_VERSION"),
        "case": "NP13-X1042 at total depth",
        "identity": digest(&json!({"mesh": 3.2})),
        "settings": {"mesh": {"element_length": "3.2 m"}},
        "operations": [
            {
                "model": "soft", "operation": "drill", "status": "complete", "friction": 0.3,
                "checks": [],
                "bit_depth_m": 4305.0, "weight_on_bit_N": 6.0, "bit_torque_N_m": 7.0,
                "hook_load_N": 1.0, "surface_torque_N_m": 2.0, "friction_torque_N_m": 3.0,
                "axial_friction_N": 4.0, "side_force_total_N": 5.0, "twist_rad": 8.0,
                "stretch_m": 9.0, "neutral_point_m": 10.0, "cutoff_depth_m": null
            },
            {
                "model": "dynamic", "operation": "drill", "status": "failed",
                "message": "the string flew off at 3.2 s", "friction": [0.2, 0.3],
                "bit_depth_m": 4305.0, "weight_on_bit_N": 6.0, "bit_torque_N_m": 7.0,
                "hook_load_N": 1.0, "surface_torque_N_m": 2.0, "friction_torque_N_m": 3.0,
                "axial_friction_N": 4.0, "side_force_total_N": 5.0, "twist_rad": 8.0,
                "stretch_m": 9.0, "neutral_point_m": 10.0, "cutoff_depth_m": null,
                "statistics": {"hook_load_N": {
                    "mean": 1.0, "std": 2.0, "min": 3.0, "max": 4.0, "p05": 5.0, "p95": 6.0,
                    "std_error": 0.5, "drift": -0.25, "drifts": true
                }},
                "bit_table": {
                    "outside_fraction": 0.25,
                    "weights_N": [10e3, 90e3],
                    "table_weights_N": [20e3, 80e3],
                    "speeds_rad_per_s": [0.0, 12.0],
                    "table_speeds_rad_per_s": [4.0, 10.0]
                },
                "indicators": {
                    "stick_slip": {
                        "severity": 1.25, "torque_severity": 0.5, "period_s": null,
                        "stuck_fraction": 0.25, "bit_speed_max_rad_per_s": 16.0
                    },
                    "backward_whirl": {
                        "md_m": 4290.0, "rate_rad_per_s": -24.0, "ratio": -3.0,
                        "length_fraction": 0.125
                    },
                    "forward_whirl": null,
                    "top_drive": {"p95": 0.5, "max": 0.75}
                },
                "numerics": {
                    "elements": 1350, "time_step_s": 2e-4, "steps": 400_000,
                    "added_axial_mass_fraction": 0.003, "max_penetration_m": 1e-5,
                    "energy_residual": 1e-4,
                    "instructions": "avx2", "wall_time_s": 2.5, "real_time_factor": 32.0
                }
            }
        ]
    });
    let failed = &mut expected["operations"][1];
    failed["checks"] = json!([buckled()]);
    for (key, value) in [
        ("settle_s", json!(12.5)),
        ("settled", json!(true)),
        ("mean_bit_depth_m", json!(4305.5)),
        ("bit_travel_m", json!(1.5)),
    ] {
        failed["numerics"][key] = value;
    }
    failed["hydraulics"] = json!({
        "mud_drag_N": 1.0, "mud_torque_N_m": 2.0, "jet_thrust_N": 3.0, "bore_loss_Pa": 4.0,
        "bit_loss_Pa": 5.0, "motor_loss_Pa": 7.0, "annulus_loss_Pa": 6.0, "pump_pressure_Pa": 22.0
    });
    failed["lift"] = json!({"hook_load_N": 700_000.0, "weight_on_bit_N": 59_900.0, "runs": 5});
    failed["numerics"]["energy"] = json!({
        "top_drive_work_J": 0.0, "hoist_work_J": 5.0, "bit_work_J": 0.0, "bend_work_J": 0.0,
        "flow_work_J": 0.0, "friction_loss_J": 1.0, "contact_loss_J": 0.0, "mud_loss_J": 0.0, "damping_loss_J": 0.0,
        "kinetic_change_J": 0.0, "elastic_change_J": 0.0, "gravity_change_J": 4.0, "residual_J": 0.0
    });
    assert_eq!(file, expected);
}

#[test]
fn what_is_not_finite_becomes_null_and_is_read_back() {
    let mut operation = soft();
    operation.scalars.twist_rad = f64::NAN;
    operation.scalars.neutral_point_m = Some(f64::INFINITY);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("summary.json");
    summary(vec![operation]).write(&path).unwrap();
    let file: Value = serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
    assert_eq!(file["operations"][0]["twist_rad"], Value::Null);
    assert_eq!(file["operations"][0]["neutral_point_m"], Value::Null);
    let back = Summary::read(&path).unwrap();
    assert!(back.operations[0].scalars.twist_rad.is_nan());
    assert_eq!(back.operations[0].scalars.neutral_point_m, None);
}

#[test]
fn zero_has_no_sign() {
    let mut operation = soft();
    operation.scalars.surface_torque_N_m = -0.0;
    let file = written(&summary(vec![operation]));
    let torque = file["operations"][0]["surface_torque_N_m"].as_f64().unwrap();
    assert_eq!(torque.to_bits(), 0.0_f64.to_bits());
}

#[test]
fn another_version_is_refused_by_number() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("summary.json");
    for (text, reason) in [
        (r#"{"schema_version": 4}"#, "its schema_version is 4, expected 1 to 3"),
        (r#"{"schema_version": 0}"#, "its schema_version is 0, expected 1 to 3"),
        (r#"{"case": "x"}"#, "it has no schema_version"),
        ("[]", "it has no schema_version"),
    ] {
        fs::write(&path, text).unwrap();
        let error = Summary::read(&path).unwrap_err().to_string();
        assert_eq!(error, format!("{} is not a file of results: {reason}", path.display()));
    }
}

/// A damaged summary is reported in words, with its line: no type of the program is named.
#[test]
fn a_damaged_summary_is_reported_in_words() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("summary.json");
    summary(vec![soft()]).write(&path).unwrap();
    let valid = fs::read_to_string(&path).unwrap();
    let check = r#""checks": [{"kind": "hoist", "severity": "ok", "verdict": "OK",
        "component": null, "md_m": null, "to_md_m": null, "value": 1.0, "limit": 2.0,
        "factor": 2.0, "required": 1.0, "unit": "N", "sentence": "s", "parts": [{"value": 3}]}]"#;
    let cut = "its text ends at line 3 before it is complete, expected the whole summary";
    for (text, reason) in [
        (String::new(), "its text ends at line 1 before it is complete"),
        (valid.lines().take(3).collect::<Vec<_>>().join("\n"), cut),
        (valid.replacen(':', "=", 1), "its text is no JSON at line 2, expected the summary"),
        (valid.replacen("\"operations\"", "\"others\"", 1), "it has no `operations` at line"),
        (
            valid.replacen("\"soft\"", "\"supple\"", 1),
            "`supple` is unknown, expected one of `soft`, `stiff`, `dynamic`",
        ),
        (
            valid.replacen("\"case\": \"", "\"case\": 3, \"was\": \"", 1),
            "a value is integer `3`, expected a string at line 4",
        ),
        (
            valid.replacen("\"friction\": ", "\"friction\": {}, \"was\": ", 1),
            "a `friction` is neither a number nor a list with a number for each hole section",
        ),
        (
            valid.replacen("\"checks\": []", check, 1),
            "a part of a sentence is neither a text nor a quantity",
        ),
    ] {
        fs::write(&path, &text).unwrap();
        let error = Summary::read(&path).unwrap_err();
        assert!(error.is_of_reading());
        let error = error.to_string();
        let begin = format!("{} is not a file of results: {reason}", path.display());
        assert!(error.starts_with(&begin), "{error}, expected {reason}");
        for word in ["untagged", "enum", "struct", "EOF", "f64", "column"] {
            assert!(!error.contains(word), "{error}");
        }
    }
}

/// Data missing in a summary of an earlier version are not made up: the error and the drift of a
/// mean are no numbers, and the beginning of its window is taken from its settings.
#[test]
fn a_summary_without_drift_is_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("summary.json");
    let mut old = written(&summary(vec![dynamic()]));
    old["settings"]["dynamics"]["settle_s"] = json!(7.5);
    let operation = &mut old["operations"][0];
    let statistic = operation["statistics"]["hook_load_N"].as_object_mut().unwrap();
    for key in ["std_error", "drift", "drifts"] {
        assert!(statistic.remove(key).is_some(), "{key}");
    }
    let numerics = operation["numerics"].as_object_mut().unwrap();
    for key in ["settle_s", "settled", "mean_bit_depth_m", "bit_travel_m"] {
        assert!(numerics.remove(key).is_some(), "{key}");
    }
    fs::write(&path, old.to_string()).unwrap();
    let read = Summary::read(&path).unwrap();
    let solved = &read.operations[0];
    let statistic = solved.statistics.as_ref().unwrap()["hook_load_N"];
    assert!(statistic.std_error.is_nan() && statistic.drift.is_nan() && !statistic.drifts);
    assert_eq!(solved.numerics.as_ref().unwrap().run.settled, None);
    assert_eq!(solved.window_from_s(&read.settings), 7.5);
    assert_eq!(dynamic().window_from_s(&read.settings), 12.5);
}

/// The slant well by the soft string, as version 1 wrote it: keys that a component does not have
/// are `null`.
#[test]
fn a_summary_of_version_1_is_read() {
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/summary-version-1.json"));
    let read = Summary::read(path).unwrap();
    assert_eq!((read.schema_version, read.case.as_str()), (1, "Slant well"));
    assert!(read.settings["string"][0]["joint_od_m"].is_null());
    let drill = &read.operations[0];
    assert_eq!((drill.model, drill.status.clone()), (ModelKind::Soft, Status::Complete));
    let stored: Value = serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap();
    assert_eq!(stored["operations"][0]["hook_load_N"], drill.scalars.hook_load_N);
}
