//! The map of contact holds every contact of every sample.

use super::*;
use crate::dynamics::MeshSettings;

/// Over each row's samples, the total force on the stretches is the mean of the whole string's side
/// force: the same sums in another order. Rows end where the window begins, however many samples
/// they have by then.
#[test]
fn rows_of_the_map_hold_what_the_samples_hold() {
    let model = model(0.25);
    // Two nodes a stretch and four samples a row.
    let mut settings = DynamicsSettings {
        mesh: MeshSettings::uniform(1.0),
        sample_interval_s: 0.002,
        duration_s: 1.0,
        ..Default::default()
    };
    // The window begins with the second sample of a row.
    let initial = new_run(&model, &REAM, &settings);
    settings.settle_s = 281.5 * initial.sample_interval_s();
    let mut simulation = new_run(&model, &REAM, &settings);
    simulation.advance(simulation.end_time_s()).unwrap();
    let outcome = simulation.outcome();
    let (map, series) = (&outcome.contact, &outcome.series);
    let nodes = &simulation.mesh.nodes;
    let half = |i: usize, k: usize| 0.5 * (nodes[i].from_bit_m + nodes[k].from_bit_m);
    let last = nodes.len() - 1;
    let lengths_m: Vec<f64> = (0..nodes.len())
        .step_by(2)
        .map(|i| half(i.saturating_sub(1), i) - half((i + 1).min(last), (i + 2).min(last)))
        .collect();
    let total: f64 = lengths_m.iter().sum();
    assert!((total / DEPTH_M - 1.0).abs() < 1e-12, "{total} m");
    let rows = map.time_s.len() / lengths_m.len();
    assert_eq!(rows * lengths_m.len(), map.time_s.len());
    assert!((150..=201).contains(&rows), "{rows} rows");
    let mut begin_s = 0.0;
    let mut parts = 0;
    for (row, intervals) in map.contact_force_N_per_m.chunks(lengths_m.len()).enumerate() {
        let end_s = map.time_s[row * lengths_m.len()];
        let within = |time: &f64| *time > begin_s + 1e-9 && *time <= end_s + 1e-9;
        let samples: Vec<f64> = series
            .time_s
            .iter()
            .zip(&series.side_force_total_N)
            .filter(|(time, _)| within(time))
            .map(|(_, force)| *force)
            .collect();
        assert!((1..=4).contains(&samples.len()), "{} samples", samples.len());
        parts += usize::from(samples.len() < 4);
        let expected = samples.iter().sum::<f64>() / samples.len() as f64;
        let found: f64 = intervals.iter().zip(&lengths_m).map(|(f, l)| f * l).sum();
        // Each row is a difference of sums over the window: their rounding grows with it.
        assert!((found / expected - 1.0).abs() < 1e-9, "{found} N for {expected} N at {end_s} s");
        begin_s = end_s;
    }
    assert_eq!(parts, 1, "the row before the window is cut short");
    let sides = map.side_force_N_per_m.iter().zip(&map.contact_force_N_per_m);
    for (side, contact) in sides {
        assert!(side.abs() <= contact * (1.0 + 1e-9) + 1e-6, "{side} of {contact}");
    }
}
