//! Speed and duration of a simulation, in words.

use std::time::Duration;

/// Simulated over real time, rounded for reading.
pub(crate) fn real_time_factor(times: f64) -> String {
    if times >= 100.0 {
        format!("{times:.0} × real time")
    } else if times > 0.0 && times < 0.1 {
        format!("1/{:.0} of real time", 1.0 / times)
    } else {
        format!("{times:.1} × real time")
    }
}

/// A remaining time, rounded to its precision.
pub(crate) fn duration(time: Duration) -> String {
    let seconds = time.as_secs();
    match seconds {
        0..120 => format!("{seconds} s"),
        120..7200 => format!("{} min", (seconds + 30) / 60),
        _ => format!("{:.1} h", seconds as f64 / 3600.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_to_come_is_no_more_exact_than_it_is_known() {
        for (seconds, words) in [
            (0, "0 s"),
            (119, "119 s"),
            (120, "2 min"),
            (3629, "60 min"),
            (7199, "120 min"),
            (9000, "2.5 h"),
        ] {
            assert_eq!(duration(Duration::from_secs(seconds)), words);
        }
    }

    #[test]
    fn slow_runs_have_a_pace_too() {
        for (times, words) in [
            (151.6, "152 × real time"),
            (30.24, "30.2 × real time"),
            (0.42, "0.4 × real time"),
            (1.0 / 125.8, "1/126 of real time"),
            (0.0, "0.0 × real time"),
        ] {
            assert_eq!(real_time_factor(times), words);
        }
    }
}
