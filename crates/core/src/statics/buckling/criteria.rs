//! When a compressed pipe leaves its straight course.

use std::f64::consts::SQRT_2;

use super::Place;

/// A shape that a compressed pipe may take, and whose load it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Criterion {
    /// The sinusoid: Dawson and Paslay, in a vertical hole Lubinski's first order.
    Sinusoidal,
    /// The helix: Chen, Lin and Cheatham.
    Helical,
    /// The finished helix: Wu and Juvkam-Wold.
    FullHelical,
}

impl Criterion {
    /// `β` of `F² = β EI w_n/r`.
    pub fn beta(self) -> f64 {
        let root = match self {
            Self::Sinusoidal => 2.0,
            Self::Helical => 2.0 * SQRT_2,
            Self::FullHelical => 2.0 * (2.0 * SQRT_2 - 1.0),
        };
        root * root
    }

    /// Load over `(EI w²)^⅓` at the lower end of a long string in a vertical hole.
    fn vertical(self) -> f64 {
        match self {
            Self::Sinusoidal => 1.94,
            Self::Helical | Self::FullHelical => 5.55,
        }
    }
}

/// Halvings of an interval until nothing is left of it in double precision.
const HALVINGS: usize = 200;

impl Place {
    /// `√(β EI w_n/r)` under a wall load `w_n`, N/m, or what the pipe's weight holds in a vertical
    /// hole, whichever is more, N: the load that a compression is compared with. Infinite where
    /// there is no clearance.
    pub fn threshold_N(&self, criterion: Criterion, wall_load_N_per_m: f64) -> f64 {
        if self.clearance_m <= 0.0 {
            return f64::INFINITY;
        }
        let pressed = criterion.beta() * self.bending_stiffness_N_m2 * wall_load_N_per_m;
        let pressed_N = (pressed / self.clearance_m).sqrt();
        pressed_N.max(self.vertical_load_N(criterion))
    }

    /// The load that the pipe's weight holds in a vertical hole, N.
    pub fn vertical_load_N(&self, criterion: Criterion) -> f64 {
        let weight_N_per_m = self.weight_N_per_m;
        criterion.vertical()
            * (self.bending_stiffness_N_m2 * weight_N_per_m * weight_N_per_m).cbrt()
    }

    /// Whether a compression, N, is beyond the criterion's load, with the wall load that it makes
    /// itself.
    pub fn is_beyond(&self, criterion: Criterion, compression_N: f64) -> bool {
        compression_N > self.threshold_N(criterion, self.wall_load_N_per_m(compression_N))
    }

    /// Every compression at which `F² = β EI w_n(F)/r`, N, from the least up: one, three in a drop
    /// where it may be buckled, pressed straight to the high side and buckled again, none where
    /// nothing presses the pipe against the wall.
    pub fn critical_loads_N(&self, criterion: Criterion) -> Vec<f64> {
        let (a, b, c) = (self.weight_across_N_per_m, self.build_rad_per_m, self.turn_rad_per_m);
        let stiff = criterion.beta() * self.bending_stiffness_N_m2 / self.clearance_m;
        let curved = b.hypot(c);
        if a <= 0.0 {
            return Vec::from_iter((curved > 0.0).then_some(stiff * curved));
        }
        // `F⁴ − K² w_n²(F)`, its slope and where that is least; from `most` on it is positive.
        let over = |f: f64| f.powi(4) - (stiff * (a + b * f).hypot(c * f)).powi(2);
        let slope = |f: f64| 4.0 * f.powi(3) - 2.0 * stiff * stiff * (curved * curved * f + a * b);
        let least = stiff * curved / 6.0_f64.sqrt();
        let most = 0.5 * (stiff * curved + (stiff * curved).hypot(2.0 * (stiff * a).sqrt()));
        let most = most * (1.0 + 1e-9);
        let mut ends = vec![0.0];
        if b < 0.0 && slope(least) < 0.0 {
            ends.push(zero(slope, 0.0, least));
            ends.push(zero(slope, least, most.max(stiff * curved)));
        }
        ends.push(most);
        ends.windows(2)
            .filter(|pair| (over(pair[0]) > 0.0) != (over(pair[1]) > 0.0))
            .map(|pair| zero(over, pair[0], pair[1]))
            .collect()
    }

    /// The critical load that a compression, N, is compared with: the greatest that it has passed,
    /// or the least where it has passed none; never less than in a vertical hole.
    pub fn critical_load_N(&self, criterion: Criterion, compression_N: f64) -> f64 {
        if self.clearance_m <= 0.0 {
            return f64::INFINITY;
        }
        let loads_N = self.critical_loads_N(criterion);
        let passed = loads_N.iter().rfind(|load| **load <= compression_N);
        let load_N = passed.or(loads_N.first()).copied().unwrap_or(0.0);
        load_N.max(self.vertical_load_N(criterion))
    }
}

/// Where a function changes sign between two places where its signs differ.
fn zero(of: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let begins_positive = of(low) > 0.0;
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if (of(middle) > 0.0) == begins_positive {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}
