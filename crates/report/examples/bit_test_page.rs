//! Writes the page and the pictures of a bit test with made-up numbers to a folder, to check their
//! appearance without running a bit test.

use std::{collections::BTreeMap, f64::consts::TAU, fs, path::PathBuf};

use wholestring_report::{
    BitTest, BitTestPoint, BottomPicture, Cell, DisplayUnit, Fact, PageHead, bit_test_html,
    bit_test_plots,
};

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

/// Three weights at two speeds, by Detournay and Defourny's law.
fn test() -> BitTest {
    let mut points = Vec::new();
    for rotary_rad_per_s in [60.0 * RPM, 120.0 * RPM] {
        for weight_N in [20e3, 40e3, 80e3] {
            let depth_of_cut_m = (weight_N - 8e3) / (0.6 * STRENGTH_PA * RADIUS_M);
            let torque_N_m = 0.5 * RADIUS_M * weight_N * 1.1 + 60.0;
            let work_Pa = torque_N_m * TAU / (depth_of_cut_m * TAU * 0.5 * RADIUS_M * RADIUS_M);
            points.push(BitTestPoint {
                weight_N,
                weight_std_N: 0.06 * weight_N,
                rotary_rad_per_s,
                rate_m_per_s: depth_of_cut_m * rotary_rad_per_s / TAU,
                torque_N_m,
                torque_std_N_m: 0.12 * torque_N_m,
                depth_of_cut_m,
                specific_energy_Pa: work_Pa,
                bottom: bottom(depth_of_cut_m),
            });
        }
    }
    let fact = |label: &str, value: f64, dimension: &str| Fact {
        label: label.into(),
        value: Cell::quantity(value, dimension),
    };
    BitTest {
        head: PageHead {
            program: "wholestring".into(),
            title: "</script><script>window.harmed = 1</script> & <b>bit</b>".into(),
            units: "si".into(),
            dimensions: dimensions(),
            facts: vec![
                fact("Bit", 2.0 * RADIUS_M, "diameter"),
                fact("Strength of the rock", STRENGTH_PA, "specific energy"),
            ],
        },
        strength_Pa: STRENGTH_PA,
        radius_m: RADIUS_M,
        torque_by_weight: Some([0.55 * RADIUS_M, 60.0]),
        points,
        message: Some("interrupted: 6 of 9 points".into()),
        page_tables: Vec::new(),
    }
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

fn dimensions() -> BTreeMap<String, [DisplayUnit; 3]> {
    let unit = |(symbol, factor): (&str, f64)| DisplayUnit { symbol: symbol.into(), factor };
    [
        ("force", [("kN", 1e3), ("t", 9806.65), ("klbf", 4448.2216)]),
        ("torque", [("kN·m", 1e3), ("kN·m", 1e3), ("ft·lbf", 1.355818)]),
        ("diameter", [("mm", 1e-3), ("mm", 1e-3), ("in", 0.0254)]),
        (
            "rate of penetration",
            [("m/h", 1.0 / 3600.0), ("m/h", 1.0 / 3600.0), ("ft/h", 0.3048 / 3600.0)],
        ),
        ("rotary speed", [("rpm", RPM); 3]),
        ("specific energy", [("MPa", 1e6), ("MPa", 1e6), ("psi", 6894.757)]),
        ("angle", [("°", TAU / 360.0); 3]),
        ("ratio", [("", 1.0); 3]),
    ]
    .map(|(name, units)| (name.to_owned(), units.map(unit)))
    .into()
}
