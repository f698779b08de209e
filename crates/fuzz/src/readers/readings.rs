//! Weights and torques read at the surface.

use wholestring_judge::{ReadingCheck, Severity};
use wholestring_tabular::read_readings;
use wholestring_units::UnitSet;

use super::reader::{New, Reader};

/// The readers of this file.
pub(super) const READERS: &[(&str, New)] = &[("readings-csv", csv)];

const WORDS: &[&str] = &[
    ",",
    ";",
    "\t",
    "\n",
    "\"",
    "(",
    ")",
    "Bit depth (m)",
    "MD",
    "Pick-up (kN)",
    "PU",
    "Slack-off",
    "Rotating (klbf)",
    "Torque (kN.m)",
    "ft-lbf",
    "Mud (sg)",
    "Case",
    "kN",
    "1,500.0",
    "0",
    "-999.25",
    "NaN",
    "-",
    "—",
    "#",
    "1.500,5",
    "°",
    "\u{a0}",
];

fn csv() -> Reader {
    let seeds: [&[u8]; 3] = [
        b"Bit depth (m),Pick-up (kN),Slack-off (kN),Rotating (kN),Torque (kN.m)\n800,536,504,525,0.15\n\
          900,567,508,532,1.88\n",
        b"MD;PU;SO;Torque on bottom;Mud;Case\nft;klbf;klbf;ft-lbf;ppg;\n1000;100,5;80;2500;9;curve\n\
          2000;150;-;3000;9,1;tangent\n",
        include_bytes!("../../../../verification/S4_field_data.csv"),
    ];
    Reader::text("readings-csv", seeds, WORDS, |input| match read_readings(input, "a.csv") {
        Ok(read) => {
            assert!(!read.readings.is_empty());
            for reading in &read.readings {
                assert!(reading.bit_depth_m > 0.0 && reading.bit_depth_m.is_finite());
                let weights = [reading.pick_up_N, reading.slack_off_N, reading.rotating_N];
                assert!(weights.into_iter().flatten().all(f64::is_finite));
            }
            let (left, checks) = read.measured(UnitSet::Field);
            let is_error = |check: &ReadingCheck| check.check.severity == Severity::Error;
            for reading in &left.readings {
                let weights = [reading.pick_up_N, reading.slack_off_N, reading.rotating_N];
                let is_load = |load: &f64| *load > 0.0;
                assert!(weights.iter().flatten().all(is_load) || checks.iter().any(is_error));
            }
            assert!(checks.iter().all(|check| !check.check.sentence.is_empty()));
            true
        }
        Err(error) => {
            assert!(!error.to_string().is_empty());
            if let Some(span) = error.span() {
                assert!(error.text().is_some_and(|text| text.get(span).is_some()));
            }
            false
        }
    })
}
