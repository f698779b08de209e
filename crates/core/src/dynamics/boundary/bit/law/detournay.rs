//! Detournay and Defourny's law with its three regimes.

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

use super::rules::{CutStart, LawRules};
use crate::dynamics::{
    assemble::{SetupError, check_numbers},
    boundary::bit::{
        cutters::{Cutters, SteadyCut},
        excitation::Excitation,
        front::{FrontCut, FrontRule, Press, check_front},
        rate_segment::RateSegment,
    },
};

/// The law of Detournay and Defourny for drag bits, with the three regimes that Detournay, Richard
/// and Shepherd measured (*International Journal of Rock Mechanics and Mining Sciences* 45, 2008).
///
/// The weight is the sum of the weight for cutting and the weight on the wear flats, `W = ζ a ε d +
/// W_f`, with `W_f = σ a l d/d*` up to the depth of cut `d*`, `W_f = σ a l` from there, and all
/// further weight at the cleaning limit `d†`. Theory: `docs/src/theory/bit.md`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct DetournayDefournyLaw {
    /// Cutters and rock.
    pub cutters: Cutters,
    /// Depth of cut per revolution `d*` from which the wear flats are in full contact, m.
    pub full_contact_depth_m: f64,
    /// Largest depth of cut per revolution `d†` that the mud keeps clean, m; `None` where it keeps
    /// any.
    pub cleaning_limit_m: Option<f64>,
    /// Stiffness of the contact between bit and rock front, N/m.
    pub rock_stiffness_N_per_m: f64,
    /// Excitation of the bit; `None` for a smooth bottom.
    pub excitation: Option<Excitation>,
}

impl DetournayDefournyLaw {
    /// Weight on bit that takes a depth of cut per revolution, N; no weight takes more than the
    /// cleaning limit.
    pub fn weight_on_bit_N(&self, depth_of_cut_m: f64) -> f64 {
        let bearing = self.cutters.wear_flat_weight_N();
        let contact = if depth_of_cut_m < self.full_contact_depth_m {
            depth_of_cut_m / self.full_contact_depth_m
        } else {
            1.0
        };
        self.cutters.cutting_N_per_m() * depth_of_cut_m + bearing * contact
    }

    /// Depth of cut per revolution under a weight on bit, m.
    pub fn depth_of_cut_m(&self, weight_on_bit_N: f64) -> f64 {
        let depth = |s: &RateSegment| s.rate_m_per_s(weight_on_bit_N);
        let mut segments = self.segments(TAU);
        let found = segments.find(|s| weight_on_bit_N <= s.to_N);
        found.as_ref().map_or(f64::NAN, depth)
    }

    /// Torque under a weight on bit, N·m.
    pub fn torque_N_m(&self, weight_on_bit_N: f64) -> f64 {
        let cutting = self.cutters.cutting_N_per_m() * self.depth_of_cut_m(weight_on_bit_N);
        let cutting = cutting.min(weight_on_bit_N);
        self.cutters.torque_N_m(cutting, weight_on_bit_N - cutting)
    }

    /// Steady drilling under a weight on bit, at a speed.
    pub fn steady(&self, weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> SteadyCut {
        let depth_of_cut_m = self.depth_of_cut_m(weight_on_bit_N);
        SteadyCut {
            depth_of_cut_m,
            torque_N_m: self.torque_N_m(weight_on_bit_N),
            rate_of_penetration_m_per_s: depth_of_cut_m * rotary_speed_rad_per_s / TAU,
        }
    }

    /// The rate of penetration against the weight at a speed, regime by regime.
    fn segments(&self, speed_rad_per_s: f64) -> impl Iterator<Item = RateSegment> {
        let revolutions_per_s = speed_rad_per_s.max(0.0) / TAU;
        let full = self.full_contact_depth_m;
        let full_N = self.weight_on_bit_N(full);
        let limit_N = self.cleaning_limit_m.map(|limit| self.weight_on_bit_N(limit));
        let contact = RateSegment {
            from_N: 0.0,
            to_N: full_N,
            from_m_per_s: 0.0,
            slope_m_per_s_per_N: if full_N > 0.0 { revolutions_per_s * full / full_N } else { 0.0 },
        };
        let cutting = RateSegment {
            from_N: full_N,
            to_N: limit_N.unwrap_or(f64::INFINITY),
            from_m_per_s: revolutions_per_s * full,
            slope_m_per_s_per_N: revolutions_per_s / self.cutters.cutting_N_per_m(),
        };
        let choked = self.cleaning_limit_m.zip(limit_N).map(|(limit, limit_N)| RateSegment {
            from_N: limit_N,
            to_N: f64::INFINITY,
            from_m_per_s: revolutions_per_s * limit,
            slope_m_per_s_per_N: 0.0,
        });
        [Some(contact), Some(cutting), choked].into_iter().flatten()
    }
}

impl LawRules for DetournayDefournyLaw {
    type Cut = FrontCut<Self>;

    fn check(&self) -> Result<(), SetupError> {
        self.cutters.check()?;
        let full_m = self.full_contact_depth_m;
        check_numbers(&[], &[("bit.full_contact_depth_m", full_m)])?;
        if let Some(limit) =
            self.cleaning_limit_m.filter(|limit| limit.is_nan() || *limit <= full_m)
        {
            return Err(SetupError::Setting {
                name: "bit.cleaning_limit_m",
                value: limit,
                expected: "more than the depth of full contact",
            });
        }
        check_front(self.rock_stiffness_N_per_m, self.excitation.as_ref())
    }

    fn stiffness_N_per_m(&self) -> f64 {
        self.rock_stiffness_N_per_m
    }

    fn steady_cut(&self, weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> Option<SteadyCut> {
        Some(self.steady(weight_on_bit_N, rotary_speed_rad_per_s))
    }

    fn begin(&self, start: &CutStart<'_>) -> Option<Self::Cut> {
        Some(FrontCut::new(*self, self.rock_stiffness_N_per_m, self.excitation, start))
    }
}

impl FrontRule for DetournayDefournyLaw {
    type Law = Self;

    fn is_of(&self, law: &Self) -> bool {
        self == law
    }

    fn press(&self, press: &Press, turning_rad_per_s: f64) -> (f64, f64) {
        press.on(self.segments(turning_rad_per_s))
    }

    fn cut(&mut self, weight_N: f64, _turning_rad_per_s: f64) -> (f64, f64) {
        (self.torque_N_m(weight_N), self.depth_of_cut_m(weight_N))
    }
}
