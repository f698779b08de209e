//! Duration of a calibration of the well of S4, 25 depths and 100 readings, on one core: `cargo
//! bench -p wholestring-plan --bench calibration`.

#[path = "../tests/oracle/mod.rs"]
#[allow(dead_code)]
mod oracle;
#[path = "../tests/well_of_s4/mod.rs"]
mod well_of_s4;

use std::time::Instant;

use oracle::Oracle;
use well_of_s4::{assembly, readings, settings};
use wholestring_plan::calibration::{SoftPredictions, calibrate};

fn main() {
    let oracle = Oracle::read();
    let assemblies = [assembly(&oracle)];
    let model = SoftPredictions::new(&assemblies);
    let readings = readings(&Oracle::data());
    let depths: Vec<(usize, f64)> = (0..30).map(|k| (0, 800.0 + 120.0 * f64::from(k))).collect();
    for _ in 0..5 {
        let begun = Instant::now();
        let found = calibrate(&model, &readings, &[], &depths, &settings()).expect("a fit");
        println!("{:.3} s, {} strings", begun.elapsed().as_secs_f64(), found.strings);
    }
}
