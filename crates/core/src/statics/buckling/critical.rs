//! When a compressed pipe leaves its straight course.

use super::{
    loads::{BucklingLoads, Criterion, CriticalLoads, Shape},
    place::Place,
};

/// Steps after which a zero is found to double precision, bisections included.
const STEPS: usize = 200;

impl Place {
    /// `√(β EI w_n/r)` under a wall load `w_n`, N/m, or the load supported by the pipe's weight in
    /// a vertical hole, whichever is greater, N: the threshold of a compression. Infinite where
    /// there is no clearance.
    pub fn threshold_N(&self, shape: Shape, wall_load_N_per_m: f64) -> f64 {
        if self.clearance_m <= 0.0 {
            return f64::INFINITY;
        }
        let pressed = shape.beta() * self.bending_stiffness_N_m2 * wall_load_N_per_m;
        let pressed_N = (pressed / self.clearance_m).sqrt();
        pressed_N.max(self.vertical_load_N(shape))
    }

    /// The load that the pipe's weight holds in a vertical hole, N.
    pub fn vertical_load_N(&self, shape: Shape) -> f64 {
        shape.vertical() * self.vertical_scale_N()
    }

    /// `(EI w²)^⅓`, N.
    fn vertical_scale_N(&self) -> f64 {
        let weight_N_per_m = self.weight_N_per_m;
        libm::cbrt(self.bending_stiffness_N_m2 * weight_N_per_m * weight_N_per_m)
    }

    /// Whether a compression, N, is beyond the load of a shape, with the wall load that it makes
    /// itself.
    pub fn is_beyond(&self, shape: Shape, compression_N: f64) -> bool {
        compression_N > self.threshold_N(shape, self.wall_load_N_per_m(compression_N))
    }

    /// Every compression at which `F² = β EI w_n(F)/r`, N, from the least up: one, three in a drop
    /// where it may be buckled, pressed straight to the high side and buckled again, none where
    /// nothing presses the pipe against the wall.
    pub fn critical_loads_N(&self, shape: Shape) -> Vec<f64> {
        self.critical_loads(shape, 0.0).all_N().to_vec()
    }

    /// The same, and the least of them that counts, N.
    fn critical_loads(&self, shape: Shape, least_N: f64) -> CriticalLoads {
        let mut found = CriticalLoads::none(least_N);
        let (a, b, c) = (self.weight_across_N_per_m, self.build_rad_per_m, self.turn_rad_per_m);
        let stiff = shape.beta() * self.bending_stiffness_N_m2 / self.clearance_m;
        let curved = libm::hypot(b, c);
        if a <= 0.0 {
            if curved > 0.0 {
                found.push(stiff * curved);
            }
            return found;
        }
        if curved == 0.0 {
            found.push((stiff * a).sqrt());
            return found;
        }
        // `F⁴ − K² w_n²(F)`, its slope and the slope's; the slope is least at `least`, and from
        // `most` on all is positive.
        let square = stiff * stiff;
        let (constant, linear) = (square * a * a, 2.0 * square * a * b);
        let quadratic = square * curved * curved;
        let over = |f: f64| ((f * f - quadratic) * f - linear) * f - constant;
        let slope = |f: f64| (4.0 * f * f - 2.0 * quadratic) * f - linear;
        let bend = |f: f64| 12.0 * f * f - 2.0 * quadratic;
        let least = stiff * curved / 6.0_f64.sqrt();
        let most = 0.5 * (stiff * curved + libm::hypot(stiff * curved, 2.0 * (stiff * a).sqrt()));
        let most = most * (1.0 + 1e-9);
        // The function changes sign between two of its turns at most once.
        let mut between = |low: f64, high: f64| {
            if (over(low) > 0.0) != (over(high) > 0.0) {
                found.push(zero(over, slope, low, high));
            }
        };
        if b < 0.0 && slope(least) < 0.0 {
            let first = zero(slope, bend, 0.0, least);
            let second = zero(slope, bend, least, most.max(stiff * curved));
            between(0.0, first);
            between(first, second);
            between(second, most);
        } else {
            between(0.0, most);
        }
        found
    }

    /// The critical load that a compression, N, is compared with: of a pipe that is beyond one the
    /// greatest that it has passed, else the next that it would pass; never less than in a vertical
    /// hole. Infinite where there is no clearance.
    pub fn critical_load_N(&self, shape: Shape, compression_N: f64) -> f64 {
        self.critical(shape, self.vertical_scale_N()).compared_with_N(compression_N)
    }

    /// The critical loads of a shape; infinite where there is no clearance.
    fn critical(&self, shape: Shape, vertical_scale_N: f64) -> CriticalLoads {
        match self.clearance_m <= 0.0 {
            true => CriticalLoads::none(f64::INFINITY),
            false => self.critical_loads(shape, shape.vertical() * vertical_scale_N),
        }
    }

    /// The critical loads of a criterion, of the sinusoid and of the helix, for whatever
    /// compression.
    pub fn buckling_loads(&self, criterion: Criterion) -> BucklingLoads {
        let seen = self.seen_by(criterion);
        let vertical_scale_N = seen.vertical_scale_N();
        BucklingLoads(criterion.shapes().map(|shape| seen.critical(shape, vertical_scale_N)))
    }

    /// The critical loads of a criterion that a compression, N, is compared with: of the sinusoid
    /// and of the helix. None where there is no clearance.
    pub fn loads_N(&self, criterion: Criterion, compression_N: f64) -> Option<[f64; 2]> {
        self.buckling_loads(criterion).compared_with_N(compression_N)
    }

    /// Whether a pipe under a compression, N, is a helix by a criterion.
    pub fn is_helix(&self, criterion: Criterion, compression_N: f64) -> bool {
        compression_N > 0.0 && self.seen_by(criterion).is_beyond(criterion.helix(), compression_N)
    }

    /// The place as a criterion sees it: straight where the curvature does not count.
    pub fn seen_by(self, criterion: Criterion) -> Self {
        match criterion.counts_curvature() {
            true => self,
            false => Self { build_rad_per_m: 0.0, turn_rad_per_m: 0.0, ..self },
        }
    }
}

/// Zero of a function between two places where its signs differ: by Newton's method from the upper
/// place, by bisection where that leaves the interval.
fn zero(
    function: impl Fn(f64) -> f64,
    slope: impl Fn(f64) -> f64,
    mut low: f64,
    mut high: f64,
) -> f64 {
    let begins_positive = function(low) > 0.0;
    let mut at = high;
    for _ in 0..STEPS {
        let value = function(at);
        if (value > 0.0) == begins_positive {
            low = at;
        } else {
            high = at;
        }
        let newton = at - value / slope(at);
        if (newton - at).abs() <= f64::EPSILON * at || high - low <= f64::EPSILON * high {
            break;
        }
        at = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
    }
    at
}
