//! Columns of `bit-test.parquet`, and the sources of their values.

use wholestring::{
    outcome::QuantityKind::{
        self, Force, Length, Pressure, RateOfPenetration, Ratio, RotarySpeed, Time, Torque,
    },
    rock::TrialOutcome,
};

use crate::{BitTestPoint, ColumnSpec};

/// A column of numbers, and its value at a point; `None` where there is none.
pub(crate) struct BitTestColumn {
    /// Name, unit and meaning.
    pub(crate) spec: ColumnSpec,
    /// Its value.
    pub(crate) value: fn(&BitTestPoint) -> Option<f64>,
}

/// A column that every point has.
const fn setting(
    name: &'static str,
    kind: QuantityKind,
    meaning: &'static str,
    point: fn(&BitTestPoint) -> Option<f64>,
) -> BitTestColumn {
    BitTestColumn { spec: ColumnSpec::number(name, kind, meaning), value: point }
}

/// Declares the columns that finished points have, each a field of the outcome.
macro_rules! outcomes {
    ($($column:ident => $kind:ident, $meaning:literal $(, null_where $null_where:literal)?;)*) => {
        [$(BitTestColumn {
            spec: ColumnSpec::number(stringify!($column), $kind, $meaning)
                $(.null_where($null_where))?,
            value: |point| {
                let outcome: &TrialOutcome = point.outcome.as_ref()?;
                outcome.$column.number()
            },
        }),*]
    };
}

/// Types of number that an outcome stores.
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

/// Columns of every point: the weight and the speed of the test.
const TRIED: [BitTestColumn; 2] = [
    setting("weight_on_bit_N", Force, "Applied weight on bit", |point| Some(point.weight_on_bit_N)),
    setting("rotary_speed_rad_per_s", RotarySpeed, "Rotary speed of the bit", |point| {
        Some(point.rotary_speed_rad_per_s)
    }),
];

/// Columns of the outcome of a finished point.
const FOUND: [BitTestColumn; 15] = outcomes! {
    rate_of_penetration_m_per_s => RateOfPenetration, "Mean rate of penetration";
    rate_of_penetration_error_m_per_s => RateOfPenetration,
        "Standard error of that mean, from its revolutions; `null` for less than two",
        null_where "there are less than two revolutions";
    depth_of_cut_m => Length, "Mean depth of cut per revolution";
    torque_N_m => Torque, "Mean torque of the bit on the rock";
    torque_error_N_m => Torque,
        "Standard error of that mean, from its revolutions; `null` for less than two",
        null_where "there are less than two revolutions";
    torque_std_N_m => Torque,
        "Standard deviation of the torque, of means over `averaging_time_s`";
    weight_borne_N => Force,
        "Mean weight carried by the rock: the weight on bit less the bit's inertia";
    weight_on_bit_std_N => Force,
        "Standard deviation of the weight carried by the rock, of means over `averaging_time_s`";
    specific_energy_Pa => Pressure,
        "Work of the bit per volume of broken rock; `null` where none broke",
        null_where "no rock broke";
    mechanical_specific_energy_Pa => Pressure,
        "Work of the bit per volume of hole, section times advance; `null` where the bit did not \
         advance",
        null_where "the bit did not advance";
    bricks_broken => Ratio, "Elements of the rock broken by the bit";
    kinetic_fraction => Ratio,
        "Largest kinetic energy of the rock over the work of its deformation";
    revolutions => Ratio, "Counted revolutions";
    time_s => Time, "Counted time";
    averaging_time_s => Time,
        "Averaging time of the means of which standard deviations are computed";
};

/// The columns of numbers, in the order of the file.
pub(crate) fn numbers() -> impl Iterator<Item = &'static BitTestColumn> {
    const { &TRIED }.iter().chain(const { &FOUND })
}

/// Columns of `bit-test.parquet`: the bit alone on its rock, a row for each weight at each speed.
pub const BIT_TEST: &[ColumnSpec] = &{
    let status = ColumnSpec::text("status", "`complete`, `interrupted` or `failed`");
    let message = ColumnSpec::text("message", "Reason of a failure; else empty");
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
