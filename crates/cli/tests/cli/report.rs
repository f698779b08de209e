//! `report.html`: a run writes it, and `report` rebuilds it.

use std::fs;

use wholestring_report::{Cell, Place, Report};

use crate::desk::{Desk, args, text};

/// The report that is embedded in a page.
fn read(page: &str) -> Report {
    let (_, rest) = page.split_once(r#"id="report">"#).expect("a page");
    let (json, _) = rest.split_once("</script>").expect("the data end");
    serde_json::from_str(json).expect("a report")
}

const WITH_FRAMES: [&str; 6] =
    ["-o", "out", "--set", "records.frames=50Hz", "--set", "mesh.element_length=3.2m"];

#[test]
fn a_run_writes_it_and_report_makes_it_again() {
    let desk = Desk::new();
    desk.done(&[&["run", "slant.toml"], &WITH_FRAMES[..]].concat());
    let path = desk.path("out/report.html");
    let page = fs::read_to_string(&path).unwrap();
    fs::remove_file(&path).unwrap();
    let output = desk.done(&["report", "out"]);
    let stdout = text(&output.stdout);
    assert_eq!(stdout.trim_end(), "out/report.html");
    assert!(fs::read_to_string(&path).unwrap() == page, "the same page");

    let report = read(&page);
    assert_eq!(report.head.title, "Straight slant");
    let solved: Vec<_> = report
        .solved
        .iter()
        .map(|solved| (solved.model.name(), solved.operation.name(), solved.key_results.len()))
        .collect();
    assert_eq!(
        solved,
        [
            ("soft", "trip_out", 5),
            ("dynamic", "trip_out", 5),
            ("soft", "rotate_off_bottom", 5),
            ("dynamic", "rotate_off_bottom", 5),
        ]
    );
    // The page shows the values of the summary.
    let summary = desk.summary("out");
    for (answer, operation) in report.solved.iter().zip(&summary.operations) {
        assert_eq!(
            answer.key_results[0].value,
            Cell::quantity(operation.scalars.hook_load_N, "force")
        );
        let tension = answer.profile["tension_N"].values();
        assert!((tension[0] / operation.scalars.hook_load_N - 1.0).abs() < 1e-6);
    }
    for run in &report.runs {
        assert_eq!(run.history["time_s"].values().len(), run.samples);
        let contact = run.contact.as_ref().expect("a map");
        let (times, depths) = (contact.time_s.values(), contact.md_m.values());
        assert_eq!(contact.values["side_force_N_per_m"].values().len(), times.len() * depths.len());
        let frames = run.frames.as_ref().expect("frames");
        let (times, depths) = (frames.time_s.values(), frames.md_m.values());
        // 2 s at 50 Hz, to whole samples.
        assert!((95..=105).contains(&frames.kept), "{}", frames.kept);
        assert_eq!(times.len(), frames.kept);
        let [high, right] =
            ["offset_high_m", "offset_right_m"].map(|name| frames.channels[name].values());
        assert_eq!(high.len(), times.len() * depths.len());
        // A pipe of 120 mm in a hole of 200 mm lies 40 mm off its axis, on the low side; where it
        // rotates it climbs the wall to the right. The contact yields by hundredths of a
        // millimetre.
        let middle = high.len() - depths.len() / 2;
        let offset = high[middle].hypot(right[middle]);
        assert!((offset - 0.04).abs() < 1e-4, "{offset} m");
        assert!(high[middle] < -0.038, "{} m", high[middle]);
    }
    let places = [Place::Results, Place::Numerics, Place::Inputs];
    for place in places {
        assert!(report.page_tables.iter().any(|table| table.place == place));
    }
}

/// A string that is pulled with its pumps off draws mud after it: the page shows that negative
/// pressure as swab, and a pump pressure only if there is one.
#[test]
fn a_negative_pump_pressure_is_swab() {
    let desk = Desk::new();
    let kinds = "operation.kind=[\"trip_out\", \"trip_in\"]";
    let mud = ["--set", "mud.rheology=newtonian", "--set", "mud.viscosity=20 cP"];
    let run = ["run", "slant.toml", "--set", "model=soft", "--set", kinds, "-o", "out"];
    desk.done(&[&run[..], &mud].concat());
    let operations = desk.summary("out").operations;
    let pressures_Pa =
        operations.iter().map(|operation| operation.hydraulics.expect("a mud").pump_pressure_Pa);
    let [pulled_Pa, lowered_Pa] = pressures_Pa.collect::<Vec<_>>()[..] else { panic!("two") };
    assert!(pulled_Pa < 0.0 && lowered_Pa > 0.0, "{pulled_Pa} {lowered_Pa}");
    let report = read(&fs::read_to_string(desk.path("out/report.html")).unwrap());
    let rows = report.page_tables.iter().flat_map(|table| &table.rows);
    let rows: Vec<_> = rows.collect();
    let row = |label: &str| {
        let is_it = |row: &&&Vec<Cell>| row[0] == Cell::Text(label.into());
        rows.iter().find(is_it).unwrap_or_else(|| panic!("no {label}"))[1..].to_vec()
    };
    let pressure = |si: f64| Cell::quantity(si, "pressure");
    assert_eq!(row("Swab below the bit"), [pressure(pulled_Pa), Cell::Nothing]);
    assert_eq!(row("Pump pressure"), [Cell::Nothing, pressure(lowered_Pa)]);
}

/// Straight down at 60 deg: the page's drawing of path, hole and string.
#[test]
fn path_hole_and_string_are_those_of_the_case() {
    let desk = Desk::new();
    desk.done(&["run", "slant.toml", "-o", "out", "--set", "model=soft"]);
    let report = read(&desk.text("out/report.html"));
    let last = |name: &str| *report.well.columns[name].values().last().unwrap();
    assert_eq!(last("md_m"), 600.0);
    assert!((last("tvd_m") - 300.0).abs() < 1e-3);
    assert!((last("north_m") - 600.0 * 0.75_f64.sqrt()).abs() < 1e-3);
    let ends: Vec<_> = report.hole.iter().map(|hole| (hole.from_m, hole.to_m)).collect();
    assert_eq!(ends, [(0.0, 400.0), (400.0, 600.0)]);
    assert_eq!(report.string.len(), 1);
    assert_eq!((report.string[0].from_m, report.string[0].to_m), (0.0, 600.0));
    assert!(report.runs.is_empty());
}

/// Every operation by both models over a minute, with as many frames as samples: however much a run
/// records, its page stays small.
#[test]
fn a_report_of_a_minute_stays_small() {
    let desk = Desk::new();
    desk.done(&args(
        r#"run slant.toml -o out --set dynamics.duration=60s --set records.frames=100Hz
           --set mesh.element_length=3.2m
           --set 'operation.kind=["trip_out", "rotate_off_bottom", "drill"]'"#,
    ));
    let page = desk.text("out/report.html");
    assert!(page.len() < 5_000_000, "{} bytes", page.len());
    let report = read(&page);
    for run in &report.runs {
        let rows = run.history["time_s"].values().len();
        assert!(rows <= 4000 && run.samples > 5500, "{rows} of {}", run.samples);
        let frames = run.frames.as_ref().expect("frames");
        let count = frames.time_s.values().len();
        assert!((30..400).contains(&count), "{count} of {}", frames.kept);
    }
}

/// The hook load excludes the block, as in the summary, and is followed by the hook load with the
/// block, which the hoist carries; checks and spectra are on the page.
#[test]
fn block_checks_and_spectra_reach_the_page() {
    let desk = Desk::new();
    let settings = [
        "operation.kind=\"rotate_off_bottom\"",
        "rig.block_weight=\"200 kN\"",
        "rig.hoist_capacity=\"1000 kN\"",
        "records.spectra=[\"surface_torque\"]",
    ];
    let settings = settings.iter().flat_map(|key| ["--set", key]);
    let words: Vec<&str> = ["run", "slant.toml", "-o", "out"].into_iter().chain(settings).collect();
    desk.done(&words);
    let mut summary = desk.summary("out");
    for solved in &mut summary.operations {
        let check = serde_json::json!({
            "kind": "helical_buckling", "severity": "error", "md_m": 100.0, "to_md_m": 300.0,
            "value": 190e3, "limit": 95e3, "unit": "N", "sentence": "Helically buckled",
        });
        solved.checks = vec![serde_json::from_value(check).unwrap()];
    }
    fs::write(desk.path("out/summary.json"), serde_json::to_string(&summary).unwrap()).unwrap();
    desk.done(&["report", "out"]);
    let report = read(&desk.text("out/report.html"));
    for (answer, operation) in report.solved.iter().zip(&summary.operations) {
        let hook = &answer.key_results[0];
        let load_N = operation.scalars.hook_load_N;
        assert_eq!(hook.label, "Hook load without block");
        assert_eq!(hook.value, Cell::quantity(load_N, "force"));
        assert_eq!(hook.more[0].value, Cell::quantity(load_N + 200e3, "force"));
        let largest_N = operation.statistics.as_ref().map_or(load_N, |all| all["hook_load_N"].max);
        assert_eq!(hook.compared, Some(largest_N + 200e3));
        assert_eq!(hook.limit, Some(1e6));
        let found = &answer.checks[0];
        assert_eq!((found.md_m, found.to_md_m), (Some(100.0), Some(300.0)));
        assert_eq!(found.value, Cell::quantity(190e3, "force"));
        assert_eq!(found.limit, Cell::quantity(95e3, "force"));
    }
    let results = report.page_tables.iter().find(|table| table.place == Place::Results);
    let names: Vec<&Cell> = results.unwrap().rows.iter().map(|row| &row[0]).collect();
    for name in ["Hook load without block", "Hook load with block"] {
        assert!(names.contains(&&Cell::Text(name.into())), "{name}");
    }
    let spectra = &report.runs[0].spectra;
    assert_eq!(spectra.len(), 1);
    assert_eq!(
        (spectra[0].signal.as_str(), spectra[0].dimension.as_str()),
        ("surface_torque", "torque")
    );
    let lengths = [&spectra[0].frequency_Hz, &spectra[0].density].map(Vec::len);
    assert!(lengths[0] > 3 && lengths[0] == lengths[1], "{lengths:?}");
}

#[test]
fn a_folder_of_no_run_is_refused() {
    let desk = Desk::new();
    let output = desk.run(&["report", "nowhere"]);
    assert_eq!(output.status.code(), Some(2));
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(
        stderr,
        "error: nowhere holds no results: neither summary.json nor sweep.csv is there\n"
    );
}

#[test]
fn a_damaged_folder_is_refused() {
    let desk = Desk::new();
    desk.done(&["run", "slant.toml", "-o", "out", "--set", "model=soft"]);
    fs::write(desk.path("out/nodes.parquet"), "not a table").unwrap();
    let output = desk.run(&["report", "out"]);
    assert_eq!(output.status.code(), Some(2));
    let stderr = text(&output.stderr);
    assert!(stderr.starts_with("error: out/nodes.parquet is not a file of results: "), "{stderr}");
}
