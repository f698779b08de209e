//! `[bit_test]`: the bit alone on its rock.

use std::f64::consts::{PI, TAU};

use serde::Serialize;
use wholestring::{
    GRAVITY_M_PER_S2,
    dynamics::{BitSettings, RockLaw},
    operation::Operation,
    rock::DrillingSpec,
};
use wholestring_config::prelude::*;

/// The grid where the case does not say, over the operation's weight on bit and the speed of its
/// bit.
const WEIGHTS: [f64; 5] = [0.25, 0.5, 1.0, 1.5, 2.0];
const SPEEDS: [f64; 3] = [0.5, 1.0, 1.5];

/// Revolutions and the time between looks, s, where the case does not say.
const SETTLE: f64 = 2.0;
const COUNTED: f64 = 4.0;
const STEP_S: f64 = 5e-4;

/// Most weights, and most speeds.
const MAX: usize = 50;

table! {
    /// The bit alone on its rock, for `wholestring bit-test`: every weight at every speed.
    BitTestTable in "[bit_test]" {
        /// Weights on bit. Default: a quarter, a half, one, one and a half and two times the
        /// operation's.
        wob: Vec<Spanned<f64>> = optional(List::or_one(
            Quantity::si(Dimension::Force, Range::positive_to(5e6).usual(1e3, 7e5), "60 kN"),
            "weights on bit",
            MAX,
        ));
        /// Rotary speeds of the bit; bare numbers are in rev/min. Default: a half, one and one and
        /// a half times that of the bit in the operation.
        rpm: Vec<Spanned<f64>> = optional(List::or_one(
            Quantity::si(
                Dimension::RotarySpeed,
                Range::from_to(PI / 30.0, 1000.0 * PI / 30.0),
                "120 rpm",
            )
            .bare("rev/min", PI / 30.0),
            "rotary speeds",
            MAX,
        ));
        /// Revolutions before those that count. Raising it forgets more of the beginning.
        settle_revolutions: f64 = default(number(0.0, 1000.0), SETTLE);
        /// Revolutions that count. Raising it makes the means surer.
        revolutions: f64 = default(number(0.5, 1000.0), COUNTED);
        /// Mass that moves along the hole with the bit. Raising it damps the rate of penetration
        /// and follows the rock more slowly. Default: what weighs as much as the mean of `wob`.
        mass: f64 = optional(Quantity::si(
            Dimension::Mass,
            Range::positive_to(1e6).usual(10.0, 2e5),
            "6 t",
        ));
        /// Time over which forces are averaged before their standard deviations are taken. Raising
        /// it takes swings out of them. Default: `sample_interval` of [dynamics], so that they are
        /// those of a run's samples.
        averaging: f64 = optional(Quantity::si(
            Dimension::Time,
            Range::positive_to(10.0),
            "10 ms",
        ));
        /// Time in which the rock is driven at a time, in shorter steps of its own, and after which
        /// layers of rock that the bit has left are dropped.
        step: f64 = default(
            Quantity::si(Dimension::Time, Range::from_to(1e-5, 2e-3), "0.5 ms"),
            STEP_S,
        );
    }
}

fn number(from: f64, to: f64) -> Number {
    Number { unit: "", range: Range::from_to(from, to) }
}

/// A bit alone on its rock, under every weight at every speed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BitTest {
    /// Bit, rock, elements and contact.
    pub drilling: DrillingSpec,
    /// Weights on bit, N: from small to large, all above zero.
    pub weights_N: Vec<f64>,
    /// Rotary speeds of the bit, rad/s: from slow to fast, all above zero.
    pub rotary_speeds_rad_per_s: Vec<f64>,
    /// Revolutions at each point before those that count.
    pub settle_revolutions: f64,
    /// Revolutions that count.
    pub revolutions: f64,
    /// Mass that moves along the hole with the bit, kg.
    pub mass_kg: f64,
    /// Time over which forces are averaged before their standard deviations are taken, s: no
    /// shorter than the step.
    pub averaging_s: f64,
    /// Time in which bit and rock are driven at a time, s.
    pub step_s: f64,
}

impl BitTest {
    /// Time that the bit drills at all points together, s.
    pub fn time_s(&self) -> f64 {
        let turned_rad = TAU * (self.settle_revolutions + self.revolutions);
        let speeds = self.rotary_speeds_rad_per_s.iter();
        let times = speeds.map(|speed| turned_rad / speed);
        self.weights_N.len() as f64 * times.sum::<f64>()
    }
}

/// What a test takes from the rest of the case.
pub(crate) struct Around<'a> {
    /// What the bit drills.
    pub(crate) drilling: &'a DrillingSpec,
    pub(crate) bit: &'a BitSettings,
    pub(crate) operations: &'a [Operation],
    /// Time between the samples of a run, s.
    pub(crate) sample_interval_s: f64,
}

/// The test: of a case that requires one, or whose operation says enough for one.
pub(crate) fn build(
    table: &Spanned<BitTestTable>,
    requested: bool,
    around: &Around<'_>,
    reader: &mut Reader,
) -> Option<Option<BitTest>> {
    let drills = around.operations.iter().find(|one| one.kind.on_bottom());
    let weight_N = drills.map(|operation| operation.weight_on_bit_N);
    let speed = drills.map(|operation| around.bit.drilling_speed_rad_per_s(operation));
    let (of, whole) = (&table.value, table.place);
    let weights = of.wob.optional()?;
    let speeds = of.rpm.optional()?;
    let weights = sorted(weights, weight_N, &WEIGHTS, "kN", 1e3, reader)?;
    let speeds = sorted(speeds, speed, &SPEEDS, "rev/min", PI / 30.0, reader)?;
    let missing = [
        (weights.is_empty(), "wob", "wob = [\"40 kN\", \"80 kN\"]"),
        (speeds.is_empty(), "rpm", "rpm = [60, 120]"),
    ];
    if let Some((_, name, example)) = missing.into_iter().find(|(missing, ..)| *missing) {
        if !requested {
            return Some(None);
        }
        return Diagnostic::error(format!("[bit_test] lacks `{name}`"))
            .at(whole, "no operation of the case puts the bit on bottom and turns it")
            .help(format!("such as {example}"))
            .refuse(reader);
    }
    let mean_N = weights.iter().sum::<f64>() / weights.len() as f64;
    let mass = of.mass.optional()?;
    let (averaging, step) = (of.averaging.optional()?, of.step.at()?);
    if let Some(averaging) = averaging.filter(|at| at.value < step.value) {
        return Diagnostic::error("forces are averaged over less than a step")
            .at(averaging.place, format!("expected at least {} s", number_text(step.value)))
            .refuse(reader);
    }
    let averaging_s = averaging.map_or(around.sample_interval_s, |at| at.value);
    let test = BitTest {
        drilling: around.drilling.clone(),
        weights_N: weights,
        rotary_speeds_rad_per_s: speeds,
        settle_revolutions: *of.settle_revolutions.get()?,
        revolutions: *of.revolutions.get()?,
        mass_kg: mass.map_or(mean_N / GRAVITY_M_PER_S2, |at| at.value),
        averaging_s: averaging_s.max(step.value),
        step_s: step.value,
    };
    let Some(mistake) = too_light(&test, mass.map_or(whole, |at| at.place)) else {
        return Some(Some(test));
    };
    if !requested {
        return Some(None);
    }
    mistake.refuse(reader)
}

/// The list of the case, or factors on the operation's number; empty where neither is.
fn sorted(
    given: Option<&Spanned<Vec<Spanned<f64>>>>,
    around: Option<f64>,
    factors: &[f64],
    unit: &str,
    worth: f64,
    reader: &mut Reader,
) -> Option<Vec<f64>> {
    let Some(given) = given else {
        let around = around.filter(|number| *number > 0.0);
        return Some(around.map_or_else(Vec::new, |number| {
            factors.iter().map(|factor| factor * number).collect()
        }));
    };
    let mut list = given.value.clone();
    list.sort_by(|a, b| a.value.total_cmp(&b.value));
    for pair in list.windows(2) {
        if pair[0].value == pair[1].value {
            let shown = number_text((pair[0].value / worth * 1e3).round() * 1e-3);
            let [first, second] = if pair[0].place.start < pair[1].place.start {
                [&pair[0], &pair[1]]
            } else {
                [&pair[1], &pair[0]]
            };
            return Diagnostic::error(format!("{shown} {unit} is listed twice"))
                .at(second.place, "again here")
                .at(first.place, "first here")
                .refuse(reader);
        }
    }
    Some(list.into_iter().map(|at| at.value).collect())
}

/// The mistake of a bit that is no heavier than what it touches.
fn too_light(test: &BitTest, place: Span) -> Option<Diagnostic> {
    let law = RockLaw { drilling: test.drilling.clone() };
    let [min_kg, _] = law.touched();
    if test.mass_kg > min_kg {
        return None;
    }
    let [mass, least] = [test.mass_kg, min_kg].map(|kg| number_text((kg * 10.0).round() * 0.1));
    let diagnostic = Diagnostic::error("the bit is too light for the elements that it touches")
        .at(place, format!("{mass} kg move with it: expected more than {least} kg"))
        .help(
            "raise mass, or lower density_factor or element_size under [rock]: their density is \
               scaled",
        );
    Some(diagnostic)
}

/// Where the table stands, if it does.
pub(crate) fn place(table: &Field<BitTestTable>) -> Option<Span> {
    table.given().map(|at| at.place)
}
