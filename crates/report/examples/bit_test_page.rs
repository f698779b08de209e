//! Writes the page and the pictures of a bit test with made-up numbers to a folder, to check their
//! appearance without running a bit test.

use std::{f64::consts::TAU, fs, path::PathBuf};

use serde_json::json;
use wholestring::rock::{DrillingResponse, TrialOutcome};
use wholestring_report::{BitTest, BottomPicture, bit_test_html, bit_test_plots};
use wholestring_results::{BIT_TEST_VERSION, BitTestPoint, BitTestSummary, Status};

const RADIUS_M: f64 = 0.108;
const STRENGTH_PA: f64 = 60e6;
const RPM: f64 = TAU / 60.0;

fn main() -> std::io::Result<()> {
    let folder = std::env::args_os().nth(1).map(PathBuf::from);
    let folder = folder.expect("a folder to write to");
    fs::create_dir_all(&folder)?;
    let test = test();
    fs::write(folder.join("report.html"), bit_test_html(&test))?;
    for plot in bit_test_plots(&test, "si") {
        let drawing = plot.figure.drawing();
        fs::write(folder.join(format!("{}.svg", plot.name)), drawing.svg())?;
        fs::write(folder.join(format!("{}.png", plot.name)), drawing.png(150.0))?;
    }
    Ok(())
}

/// Three weights at two speeds, by Detournay and Defourny's law; three points are missing.
fn test() -> BitTest {
    let point = |outcome: Option<TrialOutcome>| BitTestPoint {
        point: String::new(),
        status: if outcome.is_some() { Status::Complete } else { Status::Interrupted },
        weight_on_bit_N: 0.0,
        rotary_speed_rad_per_s: 0.0,
        outcome,
    };
    let (mut points, mut bottoms) = (vec![point(None); 3], vec![None; 3]);
    for rotary_speed_rad_per_s in [60.0 * RPM, 120.0 * RPM] {
        for weight_N in [20e3, 40e3, 80e3] {
            let depth_of_cut_m = (weight_N - 8e3) / (0.6 * STRENGTH_PA * RADIUS_M);
            let torque_N_m = 0.5 * RADIUS_M * weight_N * 1.1 + 60.0;
            let work_Pa = torque_N_m * TAU / (depth_of_cut_m * TAU * 0.5 * RADIUS_M * RADIUS_M);
            points.push(point(Some(TrialOutcome {
                weight_on_bit_N: weight_N,
                rotary_speed_rad_per_s,
                rate_of_penetration_m_per_s: depth_of_cut_m * rotary_speed_rad_per_s / TAU,
                rate_of_penetration_error_m_per_s: None,
                depth_of_cut_m,
                torque_N_m,
                torque_error_N_m: None,
                torque_std_N_m: 0.12 * torque_N_m,
                weight_borne_N: weight_N,
                weight_on_bit_std_N: 0.06 * weight_N,
                specific_energy_Pa: Some(work_Pa),
                mechanical_specific_energy_Pa: None,
                bricks_broken: 0,
                kinetic_fraction: 0.0,
                revolutions: 4.0,
                time_s: 4.0,
                averaging_time_s: 0.1,
            })));
            bottoms.push(bottom(depth_of_cut_m));
        }
    }
    let summary = BitTestSummary {
        schema_version: BIT_TEST_VERSION,
        case: "</script><script>window.harmed = 1</script> & <b>bit</b>".into(),
        settings: json!({
            "units": "si",
            "bit_test": {"mass_kg": 1e3, "revolutions": 4, "settle_revolutions": 1},
        }),
        rock_strength_Pa: STRENGTH_PA,
        bit_radius_m: RADIUS_M,
        response: DrillingResponse {
            torque_over_weight_m: Some(0.55 * RADIUS_M),
            torque_over_weight_and_radius: Some(0.55),
            torque_at_no_weight_N_m: Some(60.0),
            bottom_stiffness_N_per_m: None,
            specific_energy_Pa: None,
            specific_energy_over_strength: None,
        },
        checks: Vec::new(),
        points,
    };
    BitTest::new(summary, bottoms, None)
}

/// Five blades have passed over a bottom with a cone in its middle; a piece of it is missing.
fn bottom(depth_of_cut_m: f64) -> Option<BottomPicture> {
    const RINGS: usize = 48;
    const SECTORS: usize = 240;
    let part = |index: usize, count: usize| (index as f64 + 0.5) / count as f64;
    let radii: Vec<f64> = (0..RINGS).map(|k| RADIUS_M * part(k, RINGS)).collect();
    let angles: Vec<f64> = (0..SECTORS).map(|k| TAU * part(k, SECTORS)).collect();
    let depth = |radius: f64, angle: f64| {
        if radius > 0.09 && (1.0..1.3).contains(&angle) {
            return f64::NAN;
        }
        let profile = 0.03 * (1.0 - (2.0 * radius / RADIUS_M - 0.9).powi(2));
        let behind = (5.0 * angle / TAU + 18.0 * radius).rem_euclid(1.0);
        profile + 0.002 * (radius * TAU / 0.013).cos() + depth_of_cut_m * behind
    };
    let depths: Vec<f64> =
        radii.iter().flat_map(|radius| angles.iter().map(|angle| depth(*radius, *angle))).collect();
    BottomPicture::new(&radii, &angles, &depths)
}
