//! Columns of `bit-test.parquet`, and where their values are.

use wholestring::{
    outcome::QuantityKind::{
        self, Force, Length, Pressure, RateOfPenetration, Ratio, RotarySpeed, Time, Torque,
    },
    rock::TrialOutcome,
};

use crate::{BitTestPoint, ColumnSpec};

/// A column of numbers, and its value at a point; none where there is none.
pub(crate) struct BitTestColumn {
    /// What it is.
    pub(crate) spec: ColumnSpec,
    /// Its value.
    pub(crate) of: fn(&BitTestPoint) -> Option<f64>,
}

/// A column that every point has.
const fn given(
    name: &'static str,
    kind: QuantityKind,
    meaning: &'static str,
    of: fn(&BitTestPoint) -> Option<f64>,
) -> BitTestColumn {
    BitTestColumn { spec: ColumnSpec::number(name, kind, meaning), of }
}

/// Declares the columns that finished points have, each a field of what came of it.
macro_rules! outcomes {
    ($($column:ident => $kind:ident, $meaning:literal $(, null_where $null_where:literal)?;)*) => {
        [$(BitTestColumn {
            spec: ColumnSpec::number(stringify!($column), $kind, $meaning)
                $(.null_where($null_where))?,
            of: |point| {
                let of: &TrialOutcome = point.outcome.as_ref()?;
                of.$column.number()
            },
        }),*]
    };
}

/// What an outcome keeps a number as.
trait Number {
    fn number(&self) -> Option<f64>;
}

impl Number for f64 {
    fn number(&self) -> Option<f64> {
        Some(*self)
    }
}

impl Number for u64 {
    fn number(&self) -> Option<f64> {
        Some(*self as f64)
    }
}

impl Number for Option<f64> {
    fn number(&self) -> Option<f64> {
        *self
    }
}

/// What every point has: the weight and the speed at which it was tried.
const TRIED: [BitTestColumn; 2] = [
    given("weight_on_bit_N", Force, "Weight that was put on the bit", |point| {
        Some(point.weight_on_bit_N)
    }),
    given("rotary_speed_rad_per_s", RotarySpeed, "Rotary speed of the bit", |point| {
        Some(point.rotary_speed_rad_per_s)
    }),
];

/// What came of a point that is finished.
const FOUND: [BitTestColumn; 15] = outcomes! {
    rate_of_penetration_m_per_s => RateOfPenetration, "Mean rate of penetration";
    rate_of_penetration_error_m_per_s => RateOfPenetration,
        "Standard error of that mean, from its revolutions; `null` of less than two",
        null_where "there are less than two revolutions";
    depth_of_cut_m => Length, "Mean depth of cut per revolution";
    torque_N_m => Torque, "Mean torque of the bit on the rock";
    torque_error_N_m => Torque,
        "Standard error of that mean, from its revolutions; `null` of less than two",
        null_where "there are less than two revolutions";
    torque_std_N_m => Torque,
        "Standard deviation of the torque, of means over `averaging_time_s`";
    weight_borne_N => Force,
        "Mean weight that the rock bore: that on the bit but for what sped it up";
    weight_on_bit_std_N => Force,
        "Standard deviation of the weight that the rock bore, of means over `averaging_time_s`";
    specific_energy_Pa => Pressure,
        "Work of the bit per volume of rock that it broke; `null` where it broke nothing",
        null_where "it broke nothing";
    mechanical_specific_energy_Pa => Pressure,
        "Work of the bit per volume of hole, section times way; `null` where it did not get on",
        null_where "it did not get on";
    bricks_broken => Ratio, "Elements of the rock that it broke";
    kinetic_fraction => Ratio,
        "Largest kinetic energy of the rock over the work of its deformation";
    revolutions => Ratio, "Revolutions that were counted";
    time_s => Time, "Time that was counted";
    averaging_time_s => Time, "Time of the means that standard deviations are taken of";
};

/// The columns of numbers, in the order of the file.
pub(crate) fn numbers() -> impl Iterator<Item = &'static BitTestColumn> {
    const { &TRIED }.iter().chain(const { &FOUND })
}

/// Columns of `bit-test.parquet`: the bit alone on its rock, a row for each weight at each speed.
pub const BIT_TEST: &[ColumnSpec] = &{
    let status = ColumnSpec::text("status", "`complete`, `interrupted` or `failed`");
    let message = ColumnSpec::text("message", "Why it failed; empty where it did not");
    let mut all = [status; TRIED.len() + FOUND.len() + 3];
    all[0] = ColumnSpec::text("point", "Name of the point, and of its folder: `wob=60kN,rpm=120`");
    let mut place = 0;
    while place < TRIED.len() + FOUND.len() {
        all[1 + place] = match place < TRIED.len() {
            true => TRIED[place].spec,
            false => FOUND[place - TRIED.len()].spec,
        };
        place += 1;
    }
    all[2 + place] = message.null_where("it did not fail");
    all
};
