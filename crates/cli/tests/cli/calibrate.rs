//! `calibrate`: friction factors from readings at the surface.

use std::{fs, path::Path};

use wholestring::{
    operation::{Operation, OperationKind},
    outcome::ModelKind,
    statics::soft::soft_string,
};
use wholestring_results::{
    CALIBRATION, CALIBRATION_BANDS, CALIBRATION_DYNAMIC, CALIBRATION_PROFILES, CalibrationSummary,
    Summary, Table,
};

use crate::desk::{Desk, transcript};

const BLOCK_N: f64 = 200e3;

/// A desk with the shipped slant well.
pub(crate) fn desk() -> Desk {
    let desk = Desk::new();
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slant.toml");
    fs::copy(shipped, desk.path("well.toml")).unwrap();
    desk
}

/// Output of a command that ends with the status of invalid input.
fn refused(desk: &Desk, arguments: &[&str]) -> String {
    let output = desk.run(arguments);
    assert_eq!(output.status.code(), Some(2), "{}", transcript(&output));
    // Sentences are wrapped at the width of the screen.
    transcript(&output).split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Readings of the slant well with the friction of its case, 0.2 and 0.3, a block of 200 kN and a
/// bit torque of 2.5 kN·m.
pub(crate) fn readings(desk: &Desk) -> String {
    let case = wholestring_case::load(&desk.path("well.toml"), &[]).unwrap();
    let setup = case.setup();
    let mut text = "Bit depth (m),Pick-up (kN),Slack-off (kN),Rotating (kN),Torque (kN.m),\
                    Torque on bottom (kN.m)\n"
        .to_owned();
    for depth_m in [300.0, 450.0, 600.0, 700.0, 800.0, 900.0, 1000.0, 1100.0, 1200.0] {
        let model = setup.at(depth_m).unwrap();
        let scalars = |kind: OperationKind| {
            let operation =
                case.operations.iter().find(|operation| operation.kind == kind).unwrap();
            let operation = Operation { bit_depth_m: depth_m, ..*operation };
            soft_string(&model, &operation).unwrap().scalars
        };
        let hook_kN = |kind| 1e-3 * (scalars(kind).hook_load_N + BLOCK_N);
        let torque_kN_m = |kind| 1e-3 * scalars(kind).surface_torque_N_m;
        text += &format!(
            "{depth_m},{:.6},{:.6},{:.6},{:.6},{:.6}\n",
            hook_kN(OperationKind::TripOut),
            hook_kN(OperationKind::TripIn),
            hook_kN(OperationKind::RotateOffBottom),
            torque_kN_m(OperationKind::RotateOffBottom),
            torque_kN_m(OperationKind::Drill),
        );
    }
    text
}

const ERRORS: [&str; 3] = ["--weight-error=5kN", "--rotating-error=3kN", "--torque-error=200N.m"];

fn calibrate<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&["calibrate", "well.toml", "--data", "read.csv"], more].concat()
}

/// Terminal, folder, tables and page agree, and the estimates form a valid case.
#[test]
fn friction_of_a_slant_well() {
    let desk = desk();
    fs::write(desk.path("read.csv"), readings(&desk)).unwrap();
    let more = [&ERRORS[..], &["--bit-torque", "-o", "out"]].concat();
    let output = desk.done(&calibrate(&more));
    let screen = String::from_utf8(output.stdout).unwrap();
    let summary = CalibrationSummary::read(&desk.path("out/summary.json")).unwrap();
    let expected = [
        ("friction_cased", 0.2),
        ("friction_open", 0.3),
        ("block_weight_N", BLOCK_N),
        ("bit_torque_N_m", 2500.0),
    ];
    for (estimate, (name, value)) in summary.estimates.iter().zip(expected) {
        assert_eq!(estimate.parameter, name);
        // Steps of 5 m of the soft string; the readings have steps of 1 m.
        assert!((estimate.value / value - 1.0).abs() < 2e-3, "{estimate:?}");
        assert!(screen.contains(&estimate.words), "{screen}");
    }
    assert_eq!((summary.readings, summary.within_band), (45, 45));
    for (name, columns) in [
        ("calibration", CALIBRATION),
        ("calibration_bands", CALIBRATION_BANDS),
        ("calibration_profiles", CALIBRATION_PROFILES),
    ] {
        let table = Table::read_parquet(&desk.path(&format!("out/{name}.parquet"))).unwrap();
        assert!(table.is_like(&Table::with_columns(columns)), "{name}");
        assert!(table.rows() > 0 && desk.path(&format!("out/{name}.csv")).is_file(), "{name}");
        assert!(desk.path(&format!("out/{name}.svg")).is_file(), "{name}");
    }
    let page = fs::read_to_string(desk.path("out/report.html")).unwrap();
    assert!(page.contains("Measured and predicted") && page.contains("Correlations"));
    // The numbers of a picture are all that it shows: readings with their bands, the profiles with
    // the ends of the intervals, the residuals with the bound of outliers.
    let csv = |name: &str| Table::read_csv(&desk.path(&format!("out/{name}.csv"))).unwrap();
    let filled = |table: &Table, name: &str| {
        table.words(name).unwrap().iter().filter(|cell| !cell.is_empty()).count()
    };
    let bands = csv("calibration_bands");
    assert_eq!(filled(&bands, "measured_N") + filled(&bands, "measured_N_m"), 45);
    assert_eq!(filled(&csv("calibration_profiles"), "interval_end"), 8);
    assert_eq!(filled(&csv("calibration"), "outlier_beyond"), 45);

    // The page is rebuilt from the files.
    fs::remove_file(desk.path("out/report.html")).unwrap();
    desk.done(&["report", "out"]);
    assert_eq!(fs::read_to_string(desk.path("out/report.html")).unwrap(), page);
    desk.done(&["plot", "out", "--units", "field"]);
    assert!(desk.path("out/plots/calibration_bands.svg").is_file());

    // The fragment, checked and merged into the case.
    let fragment = fs::read_to_string(desk.path("out/friction.toml")).unwrap();
    let tried = fragment.lines().find(|line| line.contains("--set")).unwrap();
    let mut arguments = vec!["check", "well.toml"];
    for change in tried.split('\'').skip(1).step_by(2) {
        arguments.extend(["--set", change]);
    }
    assert_eq!(arguments.len(), 8);
    desk.done(&arguments);
    let case = fs::read_to_string(desk.path("well.toml")).unwrap();
    let (before, rest) = case.split_once("[[well.hole]]").unwrap();
    let after = &rest[rest.find("[mud]").unwrap()..];
    assert!(!case.contains("[rig]"));
    fs::write(desk.path("found.toml"), format!("{before}{fragment}\n{after}")).unwrap();
    desk.done(&["check", "found.toml"]);
}

/// The shipped well with readings from its rig: the numbers of its chapter in the book, to the
/// printed digits.
#[test]
fn the_real_well_has_what_its_chapter_prints() {
    let desk = Desk::new();
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let (case, data) = (cases.join("forge-16a.toml"), cases.join("forge-16a-measured.csv"));
    let [case, data] = [case, data].map(|path| path.display().to_string());
    desk.done(&[
        "calibrate",
        &case,
        "--data",
        &data,
        "--friction-around",
        "--block-weight",
        "-o",
        "out",
        "--quiet",
    ]);
    let summary = CalibrationSummary::read(&desk.path("out/summary.json")).unwrap();
    assert_eq!((summary.within_band, summary.readings), (59, 63));
    assert_eq!((summary.held_out_within_band, summary.held_out), (15, 23));
    const KLBF_N: f64 = 4_448.221_615_260_5;
    // Half of the last digit.
    for (name, printed, unit, half) in [
        ("friction_cased", 0.10, 1.0, 0.005),
        ("friction_open", 0.53, 1.0, 0.005),
        ("friction_cased_around", 0.175, 1.0, 0.0005),
        ("friction_open_around", 0.220, 1.0, 0.0005),
        ("block_weight_N", 47.6, KLBF_N, 0.05),
    ] {
        let estimates =
            summary.estimates.iter().find(|estimate| estimate.parameter == name).unwrap();
        assert!((estimates.value / unit - printed).abs() <= half, "{estimates:?}");
    }
    // Each reading has its prediction and its band: the count is of the readings between its ends.
    let table = desk.table("out/calibration.parquet");
    let column = |name: &str| table.numbers(name).unwrap();
    let mut within = 0;
    for row in 0..table.rows() {
        let is_torque = table.words("reading").unwrap()[row].starts_with("torque");
        let value_of = |name: &str| {
            let unit = if is_torque { "N_m" } else { "N" };
            column(&format!("{name}_{unit}"))[row].unwrap()
        };
        let (measured, predicted) = (value_of("measured"), value_of("predicted"));
        assert!((value_of("residual") - (measured - predicted)).abs() < 1e-6);
        let (low, high) = (value_of("reading_low"), value_of("reading_high"));
        let half = 0.5 * (high - low);
        assert!((low + half - predicted).abs() < 1e-6 * half);
        // The errors of reading and prediction: 1.645 times the root of their squares.
        assert!(half > 1.64 * value_of("predicted_error"));
        let is_within = (low..=high).contains(&measured);
        assert_eq!(column("within_band")[row], Some(f64::from(u8::from(is_within))));
        within += usize::from(is_within);
    }
    assert_eq!(within, 59 + 15);
    assert!(desk.text("out/report.html").contains("band of 90 %"));
}

/// A factor for each section that the readings reach, written back section by section. The error is
/// largest in the deepest one, which only the deepest readings reach. A section that no reading
/// reaches keeps the case's own factor.
#[test]
fn friction_of_each_section() {
    let desk = desk();
    let case = fs::read_to_string(desk.path("well.toml")).unwrap();
    let (before, rest) = case.split_once("[[well.hole]]").unwrap();
    let after = &rest[rest.find("[mud]").unwrap()..];
    let sections = |all: &[(&str, &str, &str, &str)]| {
        let section = |(kind, to, diameter, friction): &(&str, &str, &str, &str)| {
            format!(
                "[[well.hole]]\nkind = \"{kind}\"\nto = \"{to}\"\ndiameter = \"{diameter}\"\n\
                 friction = {friction}\n"
            )
        };
        format!("{before}{}{after}", all.iter().map(section).collect::<String>())
    };
    let hole = [
        ("casing", "500 m", "250 mm", "0.2"),
        ("casing", "800 m", "230 mm", "0.35"),
        ("open", "1200 m", "215.9 mm", "0.28"),
    ];
    fs::write(desk.path("well.toml"), sections(&hole)).unwrap();
    fs::write(desk.path("read.csv"), readings(&desk)).unwrap();
    let more = ["--by-section", "--hold=block_weight=200kN", "-o", "out"];
    desk.done(&calibrate(&[&ERRORS[..], &more].concat()));
    let summary = CalibrationSummary::read(&desk.path("out/summary.json")).unwrap();
    let expected =
        [("friction_section_1", 0.2), ("friction_section_2", 0.35), ("friction_section_3", 0.28)];
    assert_eq!(summary.estimates.len(), expected.len(), "{:?}", summary.estimates);
    for (estimate, (name, value)) in summary.estimates.iter().zip(expected) {
        assert_eq!(estimate.parameter, name);
        // Steps of 5 m of the soft string; the readings have steps of 1 m.
        assert!((estimate.value / value - 1.0).abs() < 5e-3, "{estimate:?}");
    }
    // The fragment has each section with its own factor.
    let fragment = desk.text("out/friction.toml");
    fs::write(desk.path("found.toml"), format!("{before}{fragment}\n{after}")).unwrap();
    let found = wholestring_case::load(&desk.path("found.toml"), &[]).unwrap();
    let sections_found = found.model.well.hole.sections();
    assert_eq!(sections_found.len(), expected.len());
    for (section, (_, value)) in sections_found.iter().zip(expected) {
        assert!((section.friction.kinetic / value - 1.0).abs() < 5e-3, "{section:?}");
    }
    // Two sections that every reading passes alike cannot be separated, and a warning reports this:
    // readings from 1100 m down all span the whole of the upper two.
    let deep: Vec<String> = readings(&desk)
        .lines()
        .enumerate()
        .filter(|(line, text)| *line == 0 || text.starts_with("1100") || text.starts_with("1200"))
        .map(|(_, text)| text.to_owned())
        .collect();
    fs::write(desk.path("deep.csv"), deep.join("\n")).unwrap();
    let few = ["calibrate", "well.toml", "--data", "deep.csv", "-o", "deep"];
    desk.done(&[&few[..], &ERRORS, &more[..2]].concat());
    let summary = CalibrationSummary::read(&desk.path("deep/summary.json")).unwrap();
    let untold = summary
        .warnings
        .iter()
        .filter(|warning| warning.contains("do not separate the friction factor"));
    assert!(untold.count() >= 1, "{:?}", summary.warnings);

    // More sections than can be separated.
    let depths = ["200 m", "400 m", "600 m", "800 m", "1000 m", "1200 m"];
    let many = depths.map(|to| ("casing", to, "230 mm", "0.2"));
    fs::write(desk.path("well.toml"), sections(&many)).unwrap();
    let screen = refused(&desk, &calibrate(&[&ERRORS[..], &more[..2]].concat()));
    assert!(screen.contains("6 sections, but at most 5 can be fitted"), "{screen}");
    let screen = refused(&desk, &calibrate(&["--by-section", "--one-factor"]));
    assert!(screen.contains("cannot be used with"), "{screen}");
}

/// Another fit or other readings under the same name do not replace existing results; a repetition
/// of the same does.
#[test]
fn another_calibration_is_refused() {
    let desk = desk();
    let text = readings(&desk);
    fs::write(desk.path("read.csv"), &text).unwrap();
    let named = [&ERRORS[..], &["-o", "out"]].concat();
    desk.done(&calibrate(&named));
    let summary = || fs::read(desk.path("out/summary.json")).unwrap();
    let first = summary();
    for more in [&["--model", "stiff"][..], &["--one-factor"], &["--band", "80"]] {
        let screen = refused(&desk, &calibrate(&[&named[..], more].concat()));
        assert!(screen.contains("with other settings or data"), "{more:?}: {screen}");
        assert!(screen.contains("--overwrite"), "{screen}");
    }
    fs::write(desk.path("read.csv"), text.replace("\n300,", "\n310,")).unwrap();
    let screen = refused(&desk, &calibrate(&named));
    assert!(screen.contains("out holds the calibration \"Slant well calibration\""), "{screen}");
    assert_eq!(summary(), first);
    fs::write(desk.path("read.csv"), &text).unwrap();
    desk.done(&calibrate(&named));
    assert_eq!(summary(), first);
}

/// Readings made with a friction factor by stiff strings are fitted by stiff strings, which report
/// their progress.
#[test]
fn friction_by_the_stiff_string() {
    use std::sync::Mutex;

    use wholestring::statics::stiff;
    use wholestring_case::{Override, Template};
    use wholestring_runner::{
        BatchSize, CancellationToken, CaseEnded, Observer, Output,
        calibrate::{self, Fit, NamedCase, Request},
    };

    /// Keeps the number of strings requested at once, and of those that have ended.
    #[derive(Default)]
    struct Counts(Mutex<Vec<[usize; 2]>>);
    impl Observer for Counts {
        fn batch_started(&self, size: &BatchSize) {
            self.0.lock().unwrap().push([size.cases, 0]);
        }
        fn case_ended(&self, ended: &CaseEnded) {
            let mut counts = self.0.lock().unwrap();
            let last = counts.last_mut().unwrap();
            assert_eq!((ended.ended, ended.of), (last[1] + 1, last[0]));
            last[1] += 1;
        }
    }

    let desk = desk();
    // Coarse, because the readings are of the same strings.
    let overrides: Vec<Override> = ["well.hole.0.friction=0.25", "well.hole.1.friction=0.25"]
        .into_iter()
        .chain(["mesh.element_length=20 m"])
        .map(|word| word.parse().unwrap())
        .collect();
    let template = Template::read(&desk.path("well.toml")).unwrap();
    let case = template.case(&overrides).unwrap();
    let mut text = "Bit depth (m),Pick-up (kN),Slack-off (kN)\n".to_owned();
    for depth_m in [600.0, 1200.0] {
        let model = case.setup().at(depth_m).unwrap();
        let hook_kN = |kind: OperationKind| {
            let operation =
                case.operations.iter().find(|operation| operation.kind == kind).unwrap();
            let operation = Operation { bit_depth_m: depth_m, ..*operation };
            let found = stiff::solve(&model, &operation, &case.dynamics.stiff_string()).unwrap();
            1e-3 * (found.scalars.hook_load_N + BLOCK_N)
        };
        let (pick_up, slack_off) =
            (hook_kN(OperationKind::TripOut), hook_kN(OperationKind::TripIn));
        text += &format!("{depth_m},{pick_up:.6},{slack_off:.6}\n");
    }
    fs::write(desk.path("read.csv"), text).unwrap();
    let named = [NamedCase {
        file: "well".into(),
        template: &template,
        overrides: &overrides,
        case: &case,
    }];
    let request = Request {
        cases: &named,
        content: None,
        data: &desk.path("read.csv"),
        fit: Fit {
            one_factor: true,
            by_section: false,
            friction_around: false,
            block_weight: true,
            bit_torque: false,
            hold: Vec::new(),
            errors: [Some(5e3), Some(3e3), Some(200.0)],
            outlier_beyond: 3.0,
            without_outliers: false,
            band_confidence: 0.9,
            model: wholestring::outcome::ModelKind::Stiff,
        },
        check: None,
        units: None,
        output: Output { folder: Some(desk.path("out")), ..Output::default() },
        png: false,
    };
    let counts = Counts::default();
    let outcome = calibrate::run(&request, &counts, &CancellationToken::new()).unwrap();
    let summary = outcome.summary;
    assert_eq!(summary.model, ModelKind::Stiff);
    let [friction, block] = &summary.estimates[..] else { panic!("{:?}", summary.estimates) };
    // Between the nodes a prediction may be off by a fiftieth of an error, 100 N; the drag of a
    // pick-up at 1200 m changes by more than 100 kN for a change of friction by one.
    assert!((friction.value - 0.25).abs() < 1e-3, "{friction:?}");
    assert!((block.value - BLOCK_N).abs() < 100.0, "{block:?}");
    // Both have intervals, wherever the initial box of factors ends.
    assert!(!friction.interval.contains(&None) && !block.interval.contains(&None), "{summary:?}");
    let counts = counts.0.into_inner().unwrap();
    assert!(counts.iter().all(|[started, ended]| started == ended), "{counts:?}");
    assert_eq!(counts.iter().map(|[started, _]| started).sum::<usize>(), summary.strings);
}

/// Two cases that share their friction, each with its rows; one parameter is fixed.
#[test]
fn rows_belong_to_cases() {
    let desk = desk();
    let case = fs::read_to_string(desk.path("well.toml")).unwrap();
    let other = case.replace("Slant well", "Short collars").replace("\"55 m\"", "\"30 m\"");
    fs::write(desk.path("short.toml"), other).unwrap();
    let text = readings(&desk);
    let mut lines = text.lines();
    let mut with_case = format!("{},case\n", lines.next().unwrap());
    for (place, line) in lines.enumerate() {
        let case = if place < 8 { "well" } else { "short collars" };
        with_case += &format!("{line},{case}\n");
    }
    fs::write(desk.path("read.csv"), &with_case).unwrap();
    let two = ["calibrate", "well.toml", "short.toml", "--data", "read.csv", "-o", "out"];
    let held = ["--hold", "friction_cased=0.2", "--hold=block_weight=200kN", "--outlier=2.5"];
    desk.done(&[&two[..], &ERRORS, &held].concat());
    let summary = CalibrationSummary::read(&desk.path("out/summary.json")).unwrap();
    let names: Vec<&str> =
        summary.estimates.iter().map(|estimate| estimate.parameter.as_str()).collect();
    assert_eq!(names, ["friction_open"]);
    assert!(summary.held.contains(&("friction_cased".to_owned(), 0.2)));
    // Shorter collars are lighter: the last row's weights are too large for them.
    let outliers = summary.warnings.iter().filter(|warning| warning.starts_with("outlier"));
    assert!(outliers.count() >= 1, "{:?}", summary.warnings);

    fs::write(desk.path("read.csv"), with_case.replace("short collars", "long")).unwrap();
    let screen = refused(&desk, &two);
    assert!(screen.contains("there is no case 'long'"), "{screen}");
}

#[test]
fn bad_readings_get_an_answer() {
    let desk = desk();
    let sound = readings(&desk);
    let answer = |text: &str, more: &[&str]| {
        fs::write(desk.path("read.csv"), text).unwrap();
        refused(&desk, &calibrate(more))
    };
    for (text, more, expected) in [
        (sound.replace("Pick-up (kN)", "Pick-up"), &[][..], "has no unit"),
        (sound.replace("\n300,", "\n1300,"), &[], "hole and survey of its case end at 1200"),
        (sound.replace("\n300,", "\n100,"), &[], "long below its drill pipe"),
        (
            sound.lines().take(2).collect::<Vec<_>>().join("\n"),
            &["--one-factor"],
            "give their standard error",
        ),
        (
            sound.clone(),
            &["--hold", "friction=0.2"],
            "is not a parameter of this fit and cannot be kept fixed",
        ),
        (sound.clone(), &["--hold", "mass=2"], "there is no parameter 'mass'"),
        (sound.clone(), &["--hold", "friction_open=5"], "expected 0 to 2"),
        (sound.clone(), &["--weight-error", "5"], "has no unit"),
        (sound.clone(), &["--band", "100"], "expected 50 to 99.9"),
        (sound.clone(), &["--band", "0.9"], "expected 50 to 99.9"),
        (sound.clone(), &["--band", "wide"], "expected a number"),
        (sound.clone(), &["--outlier", "0.5"], "expected 1 to 100"),
        (sound.clone(), &["--outlier", "nan"], "expected 1 to 100"),
        (String::new(), &[], "the file is empty"),
    ] {
        let screen = answer(&text, more);
        assert!(screen.contains(expected), "{screen}\nlacks: {expected}");
    }
    let none = refused(&desk, &["calibrate", "well.toml", "--data", "none.csv"]);
    assert!(none.contains("there is no such file"), "{none}");
}

/// The dynamic model with the fitted values, at the requested depths, on terminal, page and in the
/// tables: equal to a run of the case with that friction and that block.
#[test]
fn the_dynamics_check_what_was_found() {
    let desk = desk();
    fs::write(desk.path("read.csv"), readings(&desk)).unwrap();
    let quick = [
        "--set=dynamics.settle=4 s",
        "--set=dynamics.duration=2 s",
        "--set=mesh.element_length=20 m",
    ];
    let check = ["--check-dynamics=600m,1200m", "-o", "out"];
    let output = desk.done(&calibrate(&[&ERRORS[..], &quick, &check].concat()));
    let screen = String::from_utf8(output.stdout).unwrap();
    assert!(screen.contains("Checked by the dynamics"), "{screen}");
    let summary = CalibrationSummary::read(&desk.path("out/summary.json")).unwrap();
    let depths: Vec<f64> = summary.dynamics.iter().map(|dynamic| dynamic.bit_depth_m).collect();
    assert_eq!(depths, [[600.0; 5], [1200.0; 5]].concat());
    for reading in &summary.dynamics {
        let dynamic = reading.dynamic.unwrap_or_else(|| panic!("{reading:?}"));
        assert!((reading.measured / reading.predicted - 1.0).abs() < 5e-3, "{reading:?}");
        assert_eq!(dynamic.steady, None);
    }
    let value = |place: usize| summary.estimates[place].value;
    let set = [
        format!("--set=well.hole.0.friction={:?}", value(0)),
        format!("--set=well.hole.1.friction={:?}", value(1)),
        "--set=operation.kind=[\"trip_out\", \"rotate_off_bottom\"]".to_owned(),
        "--set=operation.bit_depth=600 m".to_owned(),
        "--set=model=\"dynamic\"".to_owned(),
    ];
    let set: Vec<&str> = set.iter().map(String::as_str).collect();
    desk.done(&[&["run", "well.toml", "-o", "run"], &quick[..], &set].concat());
    let run = Summary::read(&desk.path("run/summary.json")).unwrap();
    let [out, turned] = [0, 1].map(|place| run.operations[place].scalars);
    for (reading, expected) in [
        ("pick_up", out.hook_load_N + value(2)),
        ("rotating", turned.hook_load_N + value(2)),
        ("torque", turned.surface_torque_N_m),
    ] {
        let dynamics = summary.dynamics.iter().find(|dynamic| dynamic.reading == reading).unwrap();
        // The same run, except for the last digits of its friction.
        let mean = dynamics.dynamic.unwrap().mean;
        assert!((mean / expected - 1.0).abs() < 1e-6, "{reading}: {mean}, {expected}");
    }
    let table = desk.table("out/calibration_dynamic.parquet");
    assert!(table.is_like(&Table::with_columns(CALIBRATION_DYNAMIC)));
    assert_eq!(table.rows(), 10);
    assert!(desk.text("out/report.html").contains("Checked by the dynamics"));

    let none = refused(&desk, &calibrate(&[&ERRORS[..], &["--check-dynamics=650m"]].concat()));
    assert!(none.contains("no reading has the bit at 650 m"), "{none}");
    let bare = desk.run(&calibrate(&["--check-dynamics=650"]));
    assert_eq!(bare.status.code(), Some(2), "{}", transcript(&bare));

    // A calibration without the check removes its files.
    desk.done(&calibrate(&[&ERRORS[..], &["-o", "out", "--overwrite"]].concat()));
    assert!(!desk.path("out/calibration_dynamic.csv").exists());
    assert!(!desk.text("out/report.html").contains("Checked by the dynamics"));
}

/// An interrupted check keeps the calibration, and the message reports it.
#[test]
fn a_check_that_is_interrupted_leaves_the_calibration() {
    use wholestring_case::{Template, load};
    use wholestring_runner::{
        CancellationToken, Existing, Observer, Output, Progress, Task,
        calibrate::{self, CheckDynamics, Fit, NamedCase, Request},
    };

    /// Cancels at the first progress of a dynamic run.
    struct Stops(CancellationToken);
    impl Observer for Stops {
        fn reached(&self, _: &Task<'_>, _: &Progress) {
            self.0.cancel();
        }
    }

    let desk = desk();
    fs::write(desk.path("read.csv"), readings(&desk)).unwrap();
    let file = desk.path("well.toml");
    let (template, case) = (Template::read(&file).unwrap(), load(&file, &[]).unwrap());
    let named =
        [NamedCase { file: "well".into(), template: &template, overrides: &[], case: &case }];
    let request = Request {
        cases: &named,
        content: None,
        data: &desk.path("read.csv"),
        fit: Fit {
            one_factor: false,
            by_section: false,
            friction_around: false,
            block_weight: false,
            bit_torque: false,
            hold: Vec::new(),
            errors: [Some(5e3), Some(3e3), Some(200.0)],
            outlier_beyond: 3.0,
            without_outliers: false,
            band_confidence: 0.9,
            model: wholestring::outcome::ModelKind::Soft,
        },
        check: Some(CheckDynamics { bit_depths_m: Vec::new(), jobs: None }),
        units: None,
        output: Output {
            folder: Some(desk.path("out")),
            existing: Existing::Protect,
            ..Output::default()
        },
        png: false,
    };
    let stops = Stops(CancellationToken::new());
    let outcome = calibrate::run(&request, &stops, &stops.0).unwrap();
    assert!(outcome.interrupted && outcome.summary.dynamics.is_empty());
    let summary = CalibrationSummary::read(&desk.path("out/summary.json")).unwrap();
    assert!(
        summary.warnings.iter().any(|warning| warning.contains("was interrupted")),
        "{summary:?}"
    );
    assert!(desk.path("out/report.html").is_file());
}
