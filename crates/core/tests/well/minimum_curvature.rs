//! Minimum curvature against published positions.

use wholestring::well::{Interpolation, Path};
use wholestring_verification::{report_worst, verify};

use crate::surveys::{extra_data, iscwsa, minimum_curvature, station, stations, tie_in};

const FT: f64 = 0.3048;

/// Tolerance: positions are published to 0.005 m, angles to a few digits more.
#[test]
fn iscwsa_standard_wellpaths() {
    for (name, well) in iscwsa() {
        let path =
            Path::new(&stations(&well), Interpolation::MinimumCurvature, tie_in(&well[0])).unwrap();
        let coordinates = well.iter().flat_map(|row| {
            let found = path.at(row.station.md_m).position_m;
            [0, 1, 2].map(|axis| (row.position_m[axis], found[axis]))
        });
        let quantity = format!("{name}: coordinate of a station, m");
        report_worst(coordinates.map(|(expected, computed)| {
            verify("B01", &quantity)
                .absolute(0.006, "positions are published to 0.005 m")
                .row(expected, computed)
        }));
    }
}

/// A quarter circle in one interval ends one radius down and one radius out.
#[test]
fn quarter_circle_in_one_interval() {
    let radius_m = 500.0;
    let length_m = radius_m * std::f64::consts::FRAC_PI_2;
    let path = minimum_curvature(&[station(0.0, 0.0, 90.0), station(length_m, 90.0, 90.0)]);
    let end = path.at(length_m);
    assert!((end.position_m - nalgebra::Vector3::new(0.0, radius_m, radius_m)).amax() < 1e-10);
    let severity = path.dogleg_severity_rad_per_m(100.0);
    assert!((severity * radius_m - 1.0).abs() < 1e-12);
}

/// Published true vertical depth and dogleg severity have a dozen digits.
#[test]
fn deviated_well_9() {
    let Some(rows) = extra_data("B02_wellpathpy_well9.csv") else {
        return;
    };
    let survey: Vec<_> = rows.iter().map(|row| station(row[0] * FT, row[1], row[2])).collect();
    let path = minimum_curvature(&survey);
    for (index, row) in rows.iter().enumerate() {
        let tvd_ft = path.at(survey[index].md_m).position_m.z / FT;
        assert!((tvd_ft - row[3]).abs() < 1e-6, "MD {} ft: {tvd_ft}", row[0]);
        if index > 0 {
            let dogleg_deg = survey[index].dogleg_rad(&survey[index - 1]).to_degrees();
            let severity = dogleg_deg * 100.0 / (row[0] - rows[index - 1][0]);
            assert!((severity - row[4]).abs() < 1e-6, "MD {} ft: {severity}", row[0]);
        }
    }
}

/// Published to 0.01 m and 0.1°: the angles' rounding adds up to some centimetres.
#[test]
fn deviation_survey() {
    let Some(rows) = extra_data("B02_wellpathpy_deviation.csv") else {
        return;
    };
    let survey: Vec<_> = rows.iter().map(|row| station(row[0], row[1], row[2])).collect();
    let tie_in =
        wholestring::well::TieIn { north_m: rows[0][4], east_m: rows[0][5], tvd_m: rows[0][3] };
    let path = Path::new(&survey, Interpolation::MinimumCurvature, tie_in).unwrap();
    for row in &rows {
        let at = path.at(row[0]).position_m;
        let published = nalgebra::Vector3::new(row[4], row[5], row[3]);
        let error = (at - published).amax();
        assert!(error < 0.05, "MD {}: {error} m off", row[0]);
    }
}

#[test]
fn volve_f12() {
    let Some(rows) = extra_data("B03_volve_15_9_F12_survey.csv") else {
        return;
    };
    let survey: Vec<_> = rows.iter().map(|row| station(row[0], row[1], row[2])).collect();
    let path = minimum_curvature(&survey);
    for row in &rows {
        let at = path.at(row[0]).position_m;
        let expected = nalgebra::Vector3::new(row[4], row[5], row[3]);
        assert!((at - expected).amax() < 1e-3, "MD {}: {at:?}", row[0]);
    }
}
