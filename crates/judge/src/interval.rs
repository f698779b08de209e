//! Stretches of depth on which a quantity exceeds its limit.

/// Stretches closer together than this are reported as one, m: critical loads jump where the hole
/// or the string changes, which splits a stretch into pieces.
const MERGED_M: f64 = 100.0;

/// A stretch of measured depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// Its two ends, m.
    pub md_m: [f64; 2],
    /// Row where the measure is largest.
    pub worst: usize,
}

/// The stretches on which a measure is above one, its crossings put linearly between rows. `md_m`
/// grows.
pub fn beyond_one(md_m: &[f64], measure: &[f64]) -> Vec<Interval> {
    let mut found: Vec<Interval> = Vec::new();
    let mut open: Option<Interval> = None;
    let crossing = |row: usize| {
        let (above, below) = (measure[row - 1], measure[row]);
        let part = (1.0 - above) / (below - above);
        // An infinite measure crosses at the row that is finite.
        let part = if part.is_finite() { part } else { 0.5 };
        md_m[row - 1] + part * (md_m[row] - md_m[row - 1])
    };
    for (row, value) in measure.iter().enumerate() {
        match (&mut open, *value > 1.0) {
            (None, true) => {
                let from_m = if row == 0 { md_m[0] } else { crossing(row) };
                open = Some(Interval { md_m: [from_m, md_m[row]], worst: row });
            }
            (Some(interval), true) => {
                interval.md_m[1] = md_m[row];
                if *value > measure[interval.worst] {
                    interval.worst = row;
                }
            }
            (Some(interval), false) => {
                interval.md_m[1] = crossing(row);
                found.extend(open.take());
            }
            (None, false) => {}
        }
    }
    found.extend(open);
    merged(found, measure)
}

fn merged(found: Vec<Interval>, measure: &[f64]) -> Vec<Interval> {
    let mut merged: Vec<Interval> = Vec::new();
    for next in found {
        match merged.last_mut() {
            Some(last) if next.md_m[0] - last.md_m[1] < MERGED_M => {
                last.md_m[1] = next.md_m[1];
                if measure[next.worst] > measure[last.worst] {
                    last.worst = next.worst;
                }
            }
            _ => merged.push(next),
        }
    }
    merged
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crossings_lie_between_rows() {
        let md_m: Vec<f64> = (0..9).map(|row| 200.0 * f64::from(row)).collect();
        let measure = [0.0, 2.0, 1.5, 0.5, 0.0, 0.0, 0.75, 1.25, 3.0];
        let found = beyond_one(&md_m, &measure);
        assert_eq!(
            found,
            [
                Interval { md_m: [100.0, 500.0], worst: 1 },
                Interval { md_m: [1300.0, 1600.0], worst: 8 }
            ]
        );
        // Stretches that are close together are merged.
        let near: Vec<f64> = md_m.iter().map(|md| 0.1 * md).collect();
        let found = beyond_one(&near, &measure);
        assert_eq!(found, [Interval { md_m: [10.0, 160.0], worst: 8 }]);
        assert_eq!(beyond_one(&md_m, &[1.0; 9]), []);
        assert_eq!(beyond_one(&[], &[]), []);
    }
}
