//! The curve between stations: how the unit tangent turns with measured depth.
//!
//! On a segment of length `h` between the directions `T₀` and `T₁`, `θ` apart, the tangent has the
//! longitude `φ` in their plane and the latitude `β` across it, with the rate `g = (φ', β')`:
//!
//! ```text
//! T(s) = cos β (cos φ T₀ + sin φ e) + sin β n
//! ```
//!
//! Minimum curvature turns at `g = κ = (θ/h, 0)`. The C2 curve changes `g` linearly from the
//! station's curvature to a plateau, and from the plateau to the next station's. Theory, and the
//! proof that it does not overshoot: `docs/src/theory/well.md`.

use nalgebra::Vector3;

use super::{Interpolation, Station, station::angle_between};

/// Share of a segment that each of its two curvature transitions takes; 1/(1 − 1/6) = 1.2.
pub(super) const TRANSITION: f64 = 1.0 / 6.0;

/// Largest turn within one piece, rad. The error of the five-point rule below is then less than
/// 1e-14 of the piece's length, transitions included.
const PIECE_TURN_RAD: f64 = 0.1;

/// Gauss-Legendre rule with five points on [0, 1].
const GAUSS: [(f64, f64); 5] = [
    (0.046910077030668004, 0.11846344252809454),
    (0.23076534494715845, 0.23931433524968324),
    (0.5, 0.28444444444444444),
    (0.76923465505284155, 0.23931433524968324),
    (0.95308992296933200, 0.11846344252809454),
];

/// A stretch of the curve on which longitude and latitude are quadratic in measured depth.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    /// Measured depth of its beginning.
    pub(super) md_m: f64,
    /// Position there.
    position_m: Vector3<f64>,
    /// Frame of longitude and latitude: `T₀`, `e`, `n`.
    frame: [Vector3<f64>; 3],
    /// Coefficients of longitude in `x = md - md_m`.
    longitude: [f64; 3],
    /// Coefficients of latitude in `x`.
    latitude: [f64; 3],
}

impl Piece {
    /// Unit tangent at `x` metres into the piece.
    pub(super) fn tangent(&self, x: f64) -> Vector3<f64> {
        let (sin_phi, cos_phi) = libm::sincos(value(&self.longitude, x));
        let (sin_beta, cos_beta) = libm::sincos(value(&self.latitude, x));
        let [t0, e, n] = &self.frame;
        t0 * (cos_beta * cos_phi) + e * (cos_beta * sin_phi) + n * sin_beta
    }

    /// Unit tangent and curvature vector, the derivative of the tangent, at `x` metres into the
    /// piece.
    pub(super) fn heading(&self, x: f64) -> (Vector3<f64>, Vector3<f64>) {
        let (sin_phi, cos_phi) = libm::sincos(value(&self.longitude, x));
        let (sin_beta, cos_beta) = libm::sincos(value(&self.latitude, x));
        let (phi_rate, beta_rate) = (slope(&self.longitude, x), slope(&self.latitude, x));
        let [t0, e, n] = &self.frame;
        let tangent = t0 * (cos_beta * cos_phi) + e * (cos_beta * sin_phi) + n * sin_beta;
        let curvature_per_m = t0
            * (-phi_rate * cos_beta * sin_phi - beta_rate * sin_beta * cos_phi)
            + e * (phi_rate * cos_beta * cos_phi - beta_rate * sin_beta * sin_phi)
            + n * (beta_rate * cos_beta);
        (tangent, curvature_per_m)
    }

    /// Position at `x` metres into the piece.
    pub(super) fn position_m(&self, x: f64) -> Vector3<f64> {
        let mut mean = Vector3::zeros();
        for (at, weight) in GAUSS {
            mean += self.tangent(at * x) * weight;
        }
        self.position_m + mean * x
    }
}

fn value(coefficients: &[f64; 3], x: f64) -> f64 {
    coefficients[0] + x * (coefficients[1] + x * coefficients[2])
}

fn slope(coefficients: &[f64; 3], x: f64) -> f64 {
    coefficients[1] + 2.0 * x * coefficients[2]
}

/// The great circle from one station's direction to the next one's.
struct Arc {
    length_m: f64,
    turn_rad: f64,
    frame: [Vector3<f64>; 3],
}

impl Arc {
    fn new(from: &Station, to: &Station) -> Self {
        let (t0, t1) = (from.tangent(), to.tangent());
        let turn_rad = angle_between(&t0, &t1);
        // Twice, because a short difference keeps few digits of its direction.
        let across = t1 - t0 * t0.dot(&t1);
        let across = across.try_normalize(0.0).map(|e| e - t0 * t0.dot(&e));
        let e = across.and_then(|e| e.try_normalize(0.5)).unwrap_or_else(|| any_perpendicular(&t0));
        Self { length_m: to.md_m - from.md_m, turn_rad, frame: [t0, e, t0.cross(&e)] }
    }

    fn rate_per_m(&self) -> f64 {
        self.turn_rad / self.length_m
    }

    /// Direction of turning at the end of the segment.
    fn turning_to(&self) -> Vector3<f64> {
        let (sin, cos) = libm::sincos(self.turn_rad);
        self.frame[1] * cos - self.frame[0] * sin
    }
}

fn any_perpendicular(t: &Vector3<f64>) -> Vector3<f64> {
    let axis = Vector3::ith(t.iamin(), 1.0);
    (axis - t * t.dot(&axis)).normalize()
}

/// Pieces of the curve through `stations` (at least two, measured depths increasing, no reversal),
/// beginning at `start_m`.
pub(super) fn pieces(
    stations: &[Station],
    interpolation: Interpolation,
    start_m: Vector3<f64>,
) -> Vec<Piece> {
    let arcs: Vec<Arc> = stations.windows(2).map(|pair| Arc::new(&pair[0], &pair[1])).collect();
    let mut pieces = Vec::with_capacity(3 * arcs.len());
    let mut position_m = start_m;
    for (index, (arc, station)) in arcs.iter().zip(stations).enumerate() {
        let (h, rate) = (arc.length_m, arc.rate_per_m());
        // (length, rates of longitude and latitude at the beginning and at the end)
        let segments = match interpolation {
            Interpolation::MinimumCurvature => vec![(h, [rate, 0.0], [rate, 0.0])],
            Interpolation::Spline => {
                let above = index.checked_sub(1).map(|above| &arcs[above]);
                let k0 = station_curvature(above, Some(arc));
                let k1 = station_curvature(Some(arc), arcs.get(index + 1));
                let n = &arc.frame[2];
                let start = [k0.dot(&arc.frame[1]), k0.dot(n)];
                let end = [k1.dot(&arc.turning_to()), k1.dot(n)];
                // p = (κ − r (k₀ + k₁)/2)/(1 − r): the segment ends in the next direction.
                let plateau = [0, 1].map(|i| {
                    let mean = if i == 0 { rate } else { 0.0 };
                    (mean - TRANSITION * 0.5 * (start[i] + end[i])) / (1.0 - TRANSITION)
                });
                vec![
                    (h * TRANSITION, start, plateau),
                    (h * (1.0 - 2.0 * TRANSITION), plateau, plateau),
                    (h * TRANSITION, plateau, end),
                ]
            }
        };
        let mut md_m = station.md_m;
        let (mut phi, mut beta) = (0.0, 0.0);
        for (length_m, from, to) in segments {
            let turn = length_m * libm::hypot(from[0], from[1]).max(libm::hypot(to[0], to[1]));
            let count = (turn / PIECE_TURN_RAD).ceil().max(1.0);
            let step_m = length_m / count;
            let (phi_bend, beta_bend) =
                (0.5 * (to[0] - from[0]) / length_m, 0.5 * (to[1] - from[1]) / length_m);
            for part in 0..count as usize {
                let x0 = part as f64 * step_m;
                let piece = Piece {
                    md_m: md_m + x0,
                    position_m,
                    frame: arc.frame,
                    longitude: [
                        phi + x0 * (from[0] + x0 * phi_bend),
                        from[0] + 2.0 * x0 * phi_bend,
                        phi_bend,
                    ],
                    latitude: [
                        beta + x0 * (from[1] + x0 * beta_bend),
                        from[1] + 2.0 * x0 * beta_bend,
                        beta_bend,
                    ],
                };
                position_m = piece.position_m(step_m);
                pieces.push(piece);
            }
            md_m += length_m;
            phi += 0.5 * length_m * (from[0] + to[0]);
            beta += 0.5 * length_m * (from[1] + to[1]);
        }
    }
    pieces
}

/// Curvature vector at the station between two segments, 1/m: the harmonic mean of theirs as
/// vectors, `k = (|b| a + |a| b)/(|a| + |b|)`; zero at the ends of the survey.
fn station_curvature(above: Option<&Arc>, below: Option<&Arc>) -> Vector3<f64> {
    let (Some(above), Some(below)) = (above, below) else {
        return Vector3::zeros();
    };
    let (a, b) = (above.rate_per_m(), below.rate_per_m());
    if a == 0.0 || b == 0.0 {
        return Vector3::zeros();
    }
    (above.turning_to() + below.frame[1]) * (a / (a + b) * b)
}
