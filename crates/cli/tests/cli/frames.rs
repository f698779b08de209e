//! Frames and spectra of a run.

use crate::{
    desk::{Desk, args},
    run::{FILES, SOFT, files},
};
use wholestring_results::Table;

fn numbers(table: &Table, name: &str) -> Vec<f64> {
    table.numbers(name).expect(name).iter().copied().flatten().collect()
}

/// Frames ten times a second over the two seconds of each operation, and a spectrum of the window:
/// the frames agree with the table of time, the spectrum with the statistics. A later run without
/// them removes both.
#[test]
fn frames_and_spectra() {
    let desk = Desk::new();
    desk.done(&args(
        "run slant.toml -o out --set 'records.frames=10 Hz' \
         --set 'records.channels=[\"rotation\", \"force\"]' --set records.spectra=hook_load \
         --set 'records.node_spectra=[\"rotary_speed\", \"tension\"]' \
         --set 'records.node_spectra_at=[\"0 m\", \"150 m\"]' \
         --set 'records.spectrum_segment=1 s' --set model=dynamic \
         --set mesh.element_length=3.2m",
    ));

    let frames = desk.table("out/frames.parquet");
    let nodes = desk.table("out/nodes.parquet").rows() / 2;
    let time = desk.table("out/time.parquet");
    // A sample is a whole number of steps, 0.6 ms each, and a frame ten samples.
    let taken = time.rows() / 2 / 10;
    assert!((19..=20).contains(&taken), "{taken}");
    assert_eq!(frames.rows(), 2 * taken * nodes);
    let names: Vec<&str> = frames.columns().iter().map(|c| c.name.as_str()).collect();
    let expected = [
        "operation",
        "time_s",
        "node",
        "md_m",
        "rotary_speed_rad_per_s",
        "twist_rad",
        "tension_N",
        "torque_N_m",
    ];
    assert_eq!(names, expected);
    let (times, twists) = (numbers(&time, "time_s"), numbers(&time, "twist_rad"));
    let (frame_times, frame_twists) = (numbers(&frames, "time_s"), numbers(&frames, "twist_rad"));
    // The last operation, whose rows are the last, rotates the string.
    let last = frames.rows() - nodes;
    let row = times.iter().rposition(|t| *t == frame_times[last]).unwrap();
    assert!(twists[row] != 0.0);
    assert!((frame_twists[last] / twists[row] - 1.0).abs() < 1e-6, "single precision");

    // One segment over the whole window: because Hann's window weighs its middle, the variance is
    // only approximate.
    let spectra = desk.table("out/spectra.parquet");
    let frequencies = numbers(&spectra, "frequency_Hz");
    assert!((frequencies[1] - 1.0).abs() < 0.03, "{}", frequencies[1]);
    // For either operation, a scalar and two signals at two nodes.
    let rows = spectra.rows() / 10;
    let density = numbers(&spectra, "density");
    let variance: f64 = density[..rows].iter().sum::<f64>() * frequencies[1];
    let md_m = numbers(&spectra, "md_m");
    assert_eq!(md_m.len(), 8 * rows, "a scalar has no depth");
    for (spectrum, depth_m) in [0.0, 0.0, 150.0, 150.0].into_iter().enumerate() {
        let found = md_m[spectrum * rows];
        assert!((found - depth_m).abs() < 2.5, "{found} for {depth_m} m");
    }
    let summary = desk.summary("out");
    let std = summary.operations[0].statistics.as_ref().unwrap()["hook_load_N"].std;
    assert!((0.2..5.0).contains(&(variance.sqrt() / std)), "{variance} for {std}²");

    let anew = ["run", "slant.toml", "-o", "out", "--overwrite"];
    desk.done(&[&anew[..], &SOFT].concat());
    assert_eq!(files(&desk, "out"), FILES.map(String::from).into());
}
