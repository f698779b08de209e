//! The regenerative law: the depth of cut depends on the surface that the bit's previous passage
//! has left.

use serde::{Deserialize, Serialize};

use super::rules::{CutStart, CutState, LawRules};
use crate::{
    damage::Damaged,
    dynamics::{
        assemble::{SetupError, check_numbers},
        boundary::bit::{
            bottom::Bottom,
            cutters::{Cutters, SteadyCut},
            motor::Drive,
            step::{Approach, RockReaction},
        },
    },
};

/// The law of Richard, Germay and Detournay for drag bits (*Journal of Sound and Vibration* 305,
/// 2007), on the cutting law of Detournay and Defourny (1992).
///
/// `n` blades cut `d_n` each: the depth of the bit less that of the surface which the preceding
/// blade has left. With `d = n d_n`, `W = ζ a ε d + W_f` and `T = ½ a² ε d + ½ μ γ a W_f`. Theory:
/// `docs/src/theory/bit.md`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct RegenerativeLaw {
    /// Cutters and rock.
    pub cutters: Cutters,
    /// Blades `n`.
    pub blades: u32,
}

impl RegenerativeLaw {
    /// Weight that cutting takes per depth of cut of one blade, `n ζ a ε`, N/m.
    pub fn stiffness_N_per_m(&self) -> f64 {
        f64::from(self.blades) * self.cutters.cutting_N_per_m()
    }

    /// Steady drilling under a weight on bit, at a speed: `W = ζ a ε d + σ a l`. Under a weight
    /// that the wear flats carry alone it turns without cutting.
    pub fn steady(&self, weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> SteadyCut {
        let bearing = self.cutters.wear_flat_weight_N().min(weight_on_bit_N);
        let cutting = weight_on_bit_N - bearing;
        let depth_of_cut_m = cutting / self.cutters.cutting_N_per_m();
        SteadyCut {
            depth_of_cut_m,
            torque_N_m: self.cutters.torque_N_m(cutting, bearing),
            rate_of_penetration_m_per_s: depth_of_cut_m * rotary_speed_rad_per_s
                / std::f64::consts::TAU,
        }
    }
}

impl LawRules for RegenerativeLaw {
    type Cut = RegenerativeCut;

    fn check(&self) -> Result<(), SetupError> {
        check_numbers(&[("bit.blades", f64::from(self.blades))], &[])?;
        self.cutters.check()
    }

    fn stiffness_N_per_m(&self) -> f64 {
        Self::stiffness_N_per_m(self)
    }

    fn steady_cut(&self, weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> Option<SteadyCut> {
        Some(self.steady(weight_on_bit_N, rotary_speed_rad_per_s))
    }

    fn begin(&self, start: &CutStart<'_>) -> Option<Self::Cut> {
        let weight = start.operation.weight_on_bit_now_N();
        let depth_of_cut = self.steady(weight, 0.0).depth_of_cut_m;
        let of_a_blade_m = depth_of_cut / f64::from(self.blades);
        Some(RegenerativeCut {
            law: *self,
            bottom: Bottom::new(self.blades, start.depth_m, of_a_blade_m),
            depth_m: start.depth_m,
            back_rad: 0.0,
        })
    }
}

/// The rock under a bit that follows the law.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct RegenerativeCut {
    law: RegenerativeLaw,
    bottom: Bottom,
    /// Depth of the bit at the end of the step before, m.
    depth_m: f64,
    /// Angle by which the bit is behind the position that it has cut to, rad.
    back_rad: f64,
}

impl CutState for RegenerativeCut {
    type Law = RegenerativeLaw;

    /// The bottom must be whole.
    fn check(&self, _law: &RegenerativeLaw) -> Result<(), Damaged> {
        self.bottom.check()
    }

    fn meet(&mut self, at: &Approach, drive: &mut Drive) -> Option<RockReaction> {
        let law = &self.law;
        let mobility = at.axial_mobility_s_per_kg;
        // A torque bends the angle by dt², and the rock ahead slopes by a thousandth: the turn can
        // be foretold, the depth cannot.
        let turn = at.dt * (at.spin_before_rad_per_s + drive.speed_rad_per_s()) - self.back_rad;
        let over = at.depth_m - self.bottom.ahead_m(turn);
        let (mut weight, mut depth_of_cut) = (0.0, 0.0);
        if over > 0.0 {
            let k = law.stiffness_N_per_m();
            let yielding = 1.0 + k * at.dt * mobility;
            // W = k d and W = k d + W_f, with the depth of cut d that W itself leaves.
            let going_up = k * over / yielding;
            let going_down = (k * over + law.cutters.wear_flat_weight_N()) / yielding;
            // Between the two limits the wear flats carry the force that stops the bit; nothing
            // pulls it into the rock.
            let stops = at.velocity_m_per_s / mobility;
            weight = stops.max(going_up).min(going_down).min(over / (at.dt * mobility));
            depth_of_cut = (over - at.dt * mobility * weight).max(0.0);
        }
        let cutting = (law.stiffness_N_per_m() * depth_of_cut).min(weight);
        let bearing = weight - cutting;

        // A bit that has been turned back cuts nothing until it is where it was.
        let rubbing = law.cutters.torque_N_m(0.0, bearing);
        let forward =
            if self.back_rad == 0.0 { law.cutters.torque_N_m(cutting, bearing) } else { rubbing };
        let turned = drive.turn(at.spin_rad_per_s, at.turning_mobility, forward, rubbing);

        let depth_m = at.depth_m - at.dt * mobility * weight;
        let turn = at.dt * turned.bit_rad_per_s - self.back_rad;
        let mut depth_of_turn_m = 0.0;
        if turn > 0.0 {
            self.bottom.cut(turn, self.depth_m, depth_m);
            depth_of_turn_m = f64::from(law.blades) * depth_of_cut * turn / std::f64::consts::TAU;
        }
        // Turned back: nothing is cut until this angle is made good.
        self.back_rad = (-turn).max(0.0);
        self.depth_m = depth_m;
        Some(RockReaction {
            weight_N: weight,
            torque_N_m: turned.torque_N_m,
            spin_rad_per_s: turned.string_rad_per_s,
            depth_of_cut_m: f64::from(law.blades) * depth_of_cut,
            rate_m_per_s: depth_of_turn_m / at.dt,
        })
    }
}
