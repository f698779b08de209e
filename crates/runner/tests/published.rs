//! Weights and torques whose terms keep them out of this repository: read from the folder in
//! `WHOLESTRING_EXTRA_DATA`, skipped if it is unset.

use std::{
    fmt::Write,
    fs,
    path::{Path, PathBuf},
};

use wholestring::outcome::ModelKind;
use wholestring_case::Template;
use wholestring_results::CalibrationSummary;
use wholestring_runner::{
    CancellationToken, Existing, Output, Silent,
    calibrate::{self, Fit, NamedCase, Request},
};

/// The file's text, or `None` with a printed note.
fn published(name: &str) -> Option<String> {
    let Some(folder) = std::env::var_os("WHOLESTRING_EXTRA_DATA") else {
        println!("skipped: WHOLESTRING_EXTRA_DATA names no folder with {name}");
        return None;
    };
    let path = PathBuf::from(folder).join(name);
    Some(fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path:?}: {error}")))
}

/// A median over 10 m of a well during drilling.
struct Row {
    md_m: f64,
    inclination_deg: f64,
    hook_load_kN: f64,
    weight_on_bit_kN: f64,
    torque_kN_m: f64,
    mud_sg: f64,
    hole_mm: f64,
}

/// Rows in which the string rotates and the inclination is known.
fn rows(text: &str) -> Vec<Row> {
    let mut lines = text.lines();
    let head: Vec<&str> = lines.next().expect("a header").split(',').collect();
    let place = |name: &str| head.iter().position(|head| *head == name).expect(name);
    let names = [
        "md_m",
        "inc_deg_from_dTVD_dMD",
        "hookload_kN",
        "wob_kN",
        "surface_torque_kNm",
        "mud_g_cm3",
        "hole_mm",
        "rpm",
    ];
    let places = names.map(place);
    let rows = lines.filter_map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        let [md, inclination, hook, bit, torque, mud, hole, rpm] =
            places.map(|at| cells[at].trim().parse::<f64>().unwrap_or(f64::NAN));
        let is_sound = rpm > 0.0 && inclination > 0.0 && (hook + bit + torque + mud).is_finite();
        is_sound.then_some(Row {
            md_m: md,
            inclination_deg: inclination,
            hook_load_kN: hook,
            weight_on_bit_kN: bit,
            torque_kN_m: torque,
            mud_sg: mud,
            hole_mm: hole,
        })
    });
    rows.collect()
}

/// The 8-1/2 in section. The string is unknown and a usual one is assumed; the azimuth is unknown,
/// so the well is assumed to be plane.
fn case(rows: &[Row]) -> String {
    let mut stations = "[0, 0, 0]".to_owned();
    for row in rows {
        let _ = write!(stations, ", [{}, {}, 0]", row.md_m, row.inclination_deg);
    }
    let deepest_m = rows.last().expect("rows").md_m;
    format!(
        "name = \"15/9-F-9 A, string assumed\"\n\
         [well]\nstations = [{stations}]\npath = \"minimum-curvature\"\n\
         [[well.hole]]\nkind = \"casing\"\nto = \"880 m\"\ncasing = \"9-5/8 in 47 lb/ft\"\nfriction = 0.25\n\
         [[well.hole]]\nkind = \"open\"\nto = \"{deepest_m} m\"\ndiameter = \"8.5 in\"\nfriction = 0.25\n\
         [mud]\ndensity = \"1.2 sg\"\n\
         [[string]]\ncomponent = \"bit\"\nod = \"8.5 in\"\nlength = \"0.3 m\"\n\
         [[string]]\ncomponent = \"drill collars\"\ncatalogue = \"6-1/2 in x 2-13/16 in collar\"\nlength = \"80 m\"\n\
         [[string]]\ncomponent = \"heavy-weight drill pipe\"\ncatalogue = \"HWDP 5 in 49.3 lb/ft\"\nlength = \"100 m\"\n\
         [[string]]\ncomponent = \"drill pipe\"\ncatalogue = \"5 in 19.50 lb/ft S-135\"\nlength = \"to surface\"\n\
         [bit]\ntorque = \"2 kN.m\"\n\
         [operation]\nkind = [\"rotate_off_bottom\", \"drill\"]\nbit_depth = \"{deepest_m} m\"\nrpm = 190\n\
         wob = \"110 kN\"\nrop = \"40 m/h\"\n"
    )
}

fn fit(bit_torque: bool) -> Fit {
    Fit {
        one_factor: true,
        by_section: false,
        friction_around: false,
        block_weight: true,
        bit_torque,
        hold: Vec::new(),
        errors: [None; 3],
        outlier_beyond: 3.0,
        without_outliers: false,
        band_confidence: 0.9,
        model: ModelKind::Soft,
    }
}

fn calibrated(folder: &Path, name: &str, fit: Fit) -> CalibrationSummary {
    let file = folder.join("case.toml");
    let template = Template::read(&file).expect("a case");
    let case = template.case(&[]).unwrap_or_else(|report| panic!("{report}"));
    let named =
        [NamedCase { file: "case".into(), template: &template, overrides: &[], case: &case }];
    let request = Request {
        cases: &named,
        content: None,
        data: &folder.join("readings.csv"),
        fit,
        check: None,
        units: None,
        output: Output {
            folder: Some(folder.join(name)),
            existing: Existing::Overwrite,
            ..Output::default()
        },
        png: false,
    };
    let found = calibrate::run(&request, &Silent, &CancellationToken::new());
    found.unwrap_or_else(|error| panic!("{error}")).summary
}

/// Volve 15/9-F-9 A (Equinor Volve open data): hook load plus weight on bit as the rotating weight,
/// and the torque on bottom, predicted against measured; the folder of the pictures is printed. The
/// string is unknown, so the fitted block weight contains its error: a demonstration of the
/// calibration from such records.
#[test]
fn volve_weights_and_torques() {
    let Some(text) = published("A07_field_volve_F9A.csv") else { return };
    let rows = rows(&text);
    let section: Vec<&Row> = rows.iter().filter(|row| row.hole_mm < 300.0).collect();
    assert!(section.len() > 20, "{} rows", section.len());
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("A07");
    fs::create_dir_all(&folder).expect("a folder");
    fs::write(folder.join("case.toml"), case(&rows)).expect("a file");
    let mut readings = "Bit depth (m),Rotating (kN),Torque on bottom (kN.m),Mud (sg)\n".to_owned();
    for row in &section {
        let rotating_kN = row.hook_load_kN + row.weight_on_bit_kN;
        let _ =
            writeln!(readings, "{},{rotating_kN:.1},{},{}", row.md_m, row.torque_kN_m, row.mud_sg);
    }
    fs::write(folder.join("readings.csv"), readings).expect("a file");
    let held = calibrated(&folder, "bit torque held", fit(false));
    let free = calibrated(&folder, "bit torque found", fit(true));
    for (name, summary) in [("held", &held), ("found", &free)] {
        println!(
            "bit torque {name}: {} of {} within the band",
            summary.within_band, summary.readings
        );
        for found in &summary.estimates {
            println!("  {} = {:.4e} +- {:?}", found.parameter, found.value, found.standard_error);
        }
        for error in &summary.errors {
            println!("  error of {}: {:.4e}", error.readings, error.standard_error);
        }
        println!("  correlations {:?}\n  warnings {:?}", summary.correlation, summary.warnings);
    }
    println!("drawn in {}", folder.display());
    let friction = |summary: &CalibrationSummary| {
        let found = summary.estimates.iter().find(|found| found.parameter == "friction");
        let found = found.expect("a factor");
        (found.value, found.standard_error.expect("an error"))
    };
    let error = |summary: &CalibrationSummary, is_torque: bool| {
        let errors = summary.errors.iter().find(|error| error.is_torque == is_torque);
        errors.expect("an error").standard_error
    };
    // Results with a plausible string: weights to a hundredth and torques to a twentieth, which is
    // the scatter of medians over 10 m with a weight indicator that is not zeroed and a weight on
    // bit that is; friction as is common in an 8-1/2 in hole; 80 % of the readings in the band of
    // 90 %.
    assert!(error(&held, false) < 10e3 && error(&held, true) < 0.6e3, "{:?}", held.errors);
    let (factor, known_to) = friction(&held);
    assert!((0.2..0.6).contains(&factor) && known_to < 0.02, "{factor} +- {known_to}");
    assert!(5 * held.within_band >= 4 * held.readings, "{} in the band", held.within_band);
    // Over 300 m, torques on bottom do not separate friction from the torque on bit: a warning
    // reports it, and the interval shows it.
    let warned = free
        .warnings
        .iter()
        .any(|warning| warning.contains("do not separate the friction factor from the bit"));
    assert!(warned && friction(&free).1 > 5.0 * known_to, "{:?}", free.warnings);
}
