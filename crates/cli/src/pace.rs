//! How fast a simulation is, in words.

/// Simulated over real time, as a reader has it at a glance.
pub(crate) fn pace(times: f64) -> String {
    if times >= 100.0 {
        format!("{times:.0} × real time")
    } else if times > 0.0 && times < 0.1 {
        format!("1/{:.0} of real time", 1.0 / times)
    } else {
        format!("{times:.1} × real time")
    }
}

#[cfg(test)]
mod tests {
    use super::pace;

    #[test]
    fn slow_runs_have_a_pace_too() {
        for (times, words) in [
            (151.6, "152 × real time"),
            (30.24, "30.2 × real time"),
            (0.42, "0.4 × real time"),
            (1.0 / 125.8, "1/126 of real time"),
            (0.0, "0.0 × real time"),
        ] {
            assert_eq!(pace(times), words);
        }
    }
}
