//! Near-vertical stretches of the path, where the high side needs a convention.

use std::f64::consts::{PI, TAU};

use super::curve::Piece;

/// Below this sine of the inclination (0.057°) the high side's bearing is a matter of convention.
const NEAR_VERTICAL: f64 = 1e-3;

/// Stretches nearer to each other than this are one, m.
const TOUCHING_M: f64 = 1e-6;

/// The near-vertical stretches of a path, from the top down, each with the bearing of its high
/// side.
#[derive(Debug, Clone)]
pub(super) struct NearVertical {
    intervals: Vec<Interval>,
}

#[derive(Debug, Clone)]
struct Interval {
    from_md_m: f64,
    to_md_m: f64,
    /// Bearing at the top, and by how much it turns to the bottom.
    bearing_rad: f64,
    turn_rad: f64,
}

impl NearVertical {
    /// Finds them on a path that ends at `last_md_m`.
    pub(super) fn find(pieces: &[Piece], last_md_m: f64) -> Self {
        let mut spans: Vec<(f64, f64)> = Vec::new();
        for (index, piece) in pieces.iter().enumerate() {
            let end_md_m = pieces.get(index + 1).map_or(last_md_m, |next| next.md_m);
            let Some((from, to)) = span(piece, end_md_m - piece.md_m) else {
                continue;
            };
            let (from, to) = (piece.md_m + from, piece.md_m + to);
            match spans.last_mut() {
                Some(last) if from - last.1 < TOUCHING_M => last.1 = to,
                _ => spans.push((from, to)),
            }
        }
        let first_md_m = pieces[0].md_m;
        let bearing = |md_m: f64| {
            let index = pieces.partition_point(|piece| piece.md_m <= md_m) - 1;
            let t = pieces[index].tangent(md_m - pieces[index].md_m);
            // The high side's horizontal part; it points against the azimuth in a hole going up.
            libm::atan2(t.z * t.y, t.z * t.x)
        };
        let intervals = spans
            .into_iter()
            .map(|(from, to)| {
                let above = (from - first_md_m > TOUCHING_M).then(|| bearing(from));
                let below = (last_md_m - to > TOUCHING_M).then(|| bearing(to));
                let top = above.or(below).unwrap_or(0.0);
                let turn = wrapped(below.unwrap_or(top) - top);
                Interval {
                    from_md_m: above.map_or(f64::NEG_INFINITY, |_| from),
                    to_md_m: below.map_or(f64::INFINITY, |_| to),
                    bearing_rad: top,
                    turn_rad: turn,
                }
            })
            .collect();
        Self { intervals }
    }

    /// Bearing of the high side at a measured depth in one of the stretches.
    pub(super) fn bearing_rad(&self, md_m: f64) -> Option<f64> {
        let index = self.intervals.partition_point(|interval| interval.to_md_m < md_m);
        let interval = self.intervals.get(index)?;
        if md_m < interval.from_md_m {
            return None;
        }
        if interval.turn_rad == 0.0 {
            return Some(interval.bearing_rad);
        }
        let share = (md_m - interval.from_md_m) / (interval.to_md_m - interval.from_md_m);
        Some(interval.bearing_rad + share * interval.turn_rad)
    }
}

/// An angle's equal between -π and π.
fn wrapped(angle: f64) -> f64 {
    let rest = angle.rem_euclid(TAU);
    if rest > PI { rest - TAU } else { rest }
}

/// The near-vertical part of a piece, as distances from its beginning.
fn span(piece: &Piece, length_m: f64) -> Option<(f64, f64)> {
    let sine = |x: f64| {
        let t = piece.tangent(x);
        libm::hypot(t.x, t.y)
    };
    let lowest = lowest(sine, length_m);
    if sine(lowest) > NEAR_VERTICAL {
        return None;
    }
    let edge = |outside: f64| {
        if sine(outside) <= NEAR_VERTICAL {
            return outside;
        }
        let (mut inside, mut outside) = (lowest, outside);
        for _ in 0..60 {
            let middle = 0.5 * (inside + outside);
            if sine(middle) <= NEAR_VERTICAL {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        inside
    };
    Some((edge(0.0), edge(length_m)))
}

/// Minimum of a function with one valley on [0, length]: at the ends, or by golden section. A piece
/// turns by a tenth of a radian at most, so its inclination has one valley.
fn lowest(function: impl Fn(f64) -> f64, length: f64) -> f64 {
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut low, mut high) = (0.0, length);
    for _ in 0..40 {
        let (left, right) = (high - golden * (high - low), low + golden * (high - low));
        if function(left) < function(right) {
            high = right;
        } else {
            low = left;
        }
    }
    [0.0, length].into_iter().fold(0.5 * (low + high), |best, end| {
        if function(end) < function(best) { end } else { best }
    })
}
