//! A law that was measured.

use serde::{Deserialize, Serialize};

use super::rules::{CutStart, LawRules};
use crate::dynamics::{
    assemble::SetupError,
    boundary::bit::{
        cutters::SteadyCut,
        excitation::{Excitation, Shake, Shaker, Spread},
        front::{FrontCut, FrontRule, Press, check_front},
        table::{BitTable, Counter, TableUse},
    },
};

/// The table and its settings.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TableLaw {
    /// Measured values.
    pub table: BitTable,
    /// Stiffness of the contact between bit and rock front, N/m.
    pub rock_stiffness_N_per_m: f64,
    /// Excitation of the bit; `None` for a smooth bottom. A spread in the table replaces
    /// `roughness_m` and `torque_fluctuation`.
    pub excitation: Option<Excitation>,
}

impl TableLaw {
    /// The noise under a weight at a speed: of the torque, the standard deviation over the mean; of
    /// the front, the displacement that changes the weight on a fixed bit by the standard
    /// deviation.
    fn spread(&self, weight_N: f64, speed_rad_per_s: f64) -> Spread {
        let excitation = self.excitation.as_ref();
        let mut spread = excitation
            .map_or(Spread { roughness_m: 0.0, torque_fluctuation: 0.0 }, Excitation::spread);
        if let Some(std_N) = self.table.weight_std_N(weight_N, speed_rad_per_s) {
            spread.roughness_m = std_N / self.rock_stiffness_N_per_m;
        }
        if let Some(fluctuation) = self.table.torque_fluctuation(weight_N, speed_rad_per_s) {
            spread.torque_fluctuation = fluctuation;
        }
        spread
    }
}

impl LawRules for TableLaw {
    type Cut = FrontCut<Measured>;

    fn check(&self) -> Result<(), SetupError> {
        check_front(self.rock_stiffness_N_per_m, self.excitation.as_ref())
    }

    fn stiffness_N_per_m(&self) -> f64 {
        self.rock_stiffness_N_per_m
    }

    fn steady_cut(&self, weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> Option<SteadyCut> {
        Some(self.table.steady(weight_on_bit_N, rotary_speed_rad_per_s))
    }

    fn begin(&self, start: &CutStart<'_>) -> Option<Self::Cut> {
        let law = Measured { law: self.clone(), used: Counter::new() };
        Some(FrontCut::new(law, self.rock_stiffness_N_per_m, self.excitation, start))
    }
}

/// The law in a run, and where the bit was in its table.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Measured {
    law: TableLaw,
    used: Counter,
}

impl FrontRule for Measured {
    type Law = TableLaw;

    fn is_of(&self, law: &TableLaw) -> bool {
        self.law == *law
    }

    fn press(&self, press: &Press, turning_rad_per_s: f64) -> (f64, f64) {
        press.on(self.law.table.segments(turning_rad_per_s))
    }

    fn cut(&mut self, weight_N: f64, turning_rad_per_s: f64) -> (f64, f64) {
        self.used.count(&self.law.table, weight_N, turning_rad_per_s);
        let cut = self.law.table.steady(weight_N, turning_rad_per_s);
        (cut.torque_N_m, cut.depth_of_cut_m)
    }

    /// Noise as the table spreads.
    fn shake(
        &self,
        shaker: Option<&Shaker>,
        weight_N: f64,
        turning_rad_per_s: f64,
        turn_rad: f64,
        dt: f64,
    ) -> Shake {
        let Some(shaker) = shaker else {
            return Shake::default();
        };
        shaker.next_of(self.law.spread(weight_N, turning_rad_per_s), turn_rad, dt)
    }

    fn table_use(&self) -> Option<TableUse> {
        self.used.table_use(&self.law.table)
    }

    fn restart(&mut self) {
        self.used = Counter::new();
    }
}
