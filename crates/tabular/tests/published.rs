//! Published surveys whose terms exclude them from this repository: read from the folder in
//! `WHOLESTRING_EXTRA_DATA`, skipped if it is unset.

use std::path::PathBuf;

use wholestring_tabular::{ImportedSurvey, read};

/// The file's text, or `None` with a message.
fn published(name: &str) -> Option<String> {
    let Some(folder) = std::env::var_os("WHOLESTRING_EXTRA_DATA") else {
        println!("skipped: WHOLESTRING_EXTRA_DATA names no folder with {name}");
        return None;
    };
    let path = PathBuf::from(folder).join(name);
    Some(std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path:?}: {error}")))
}

/// Compares every number of the file's first six columns, in the units that the test states, with
/// the import. Columns: measured depth, inclination, azimuth, and the columns of true vertical
/// depth, north and east.
fn assert_imported(text: &str, name: &str, depth_m: f64, tie_in: [(usize, f64); 3]) {
    let survey: ImportedSurvey =
        read(text.as_bytes(), name).unwrap_or_else(|error| panic!("{error}"));
    let rows: Vec<Vec<f64>> = text
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.trim().parse().unwrap()).collect())
        .collect();
    assert_eq!(survey.stations.len(), rows.len());
    // Two roundings on either side.
    let near = |a: f64, b: f64| (a - b).abs() <= 4.0 * f64::EPSILON * b.abs();
    for (station, row) in survey.stations.iter().zip(&rows) {
        assert!(near(station.md_m, row[0] * depth_m), "{row:?}");
        assert!(near(station.inclination_rad, row[1].to_radians()), "{row:?}");
        assert!(near(station.azimuth_rad, row[2].to_radians()), "{row:?}");
    }
    let [tvd_m, north_m, east_m] = tie_in.map(|(column, unit_m)| rows[0][column] * unit_m);
    let found = survey.tie_in.unwrap();
    assert!(near(found.tvd_m, tvd_m) && near(found.north_m, north_m) && near(found.east_m, east_m));
}

/// wellpathpy's `deviation` and `well9` (github.com/Zabamund/wellpathpy, LGPL).
#[test]
fn wellpathpy_surveys() {
    if let Some(text) = published("B02_wellpathpy_deviation.csv") {
        assert_imported(&text, "deviation.csv", 1.0, [(3, 1.0), (4, 1.0), (5, 1.0)]);
    }
    if let Some(text) = published("B02_wellpathpy_well9.csv") {
        assert_imported(&text, "well9.csv", 0.3048, [(3, 0.3048), (5, 1.0), (6, 1.0)]);
    }
}

/// Volve 15/9-F-12 (Equinor Volve open data).
#[test]
fn volve_survey() {
    if let Some(text) = published("B03_volve_15_9_F12_survey.csv") {
        assert_imported(&text, "volve.csv", 1.0, [(3, 1.0), (4, 1.0), (5, 1.0)]);
    }
}
