//! `[bit_test]`: bit and rock without the string.

use std::f64::consts::{PI, TAU};

use serde::Serialize;
use wholestring::{
    GRAVITY_M_PER_S2,
    dynamics::{BitSettings, RockLaw},
    operation::Operation,
    rock::DrillingSpec,
};
use wholestring_config::prelude::*;

/// Default grid, over the operation's weight on bit and the speed of its bit.
const WEIGHTS: [f64; 5] = [0.25, 0.5, 1.0, 1.5, 2.0];
const SPEEDS: [f64; 3] = [0.5, 1.0, 1.5];

/// Default revolutions, and the default time between samples, s.
const SETTLE: f64 = 2.0;
const COUNTED: f64 = 4.0;
const STEP_S: f64 = 5e-4;

/// Maximum number of weights, and of speeds.
const MAX: usize = 50;

table! {
    /// A test of bit and rock without the string, for `wholestring bit-test`: every weight at every
    /// speed.
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
        /// Revolutions before those that are averaged. Raising it reduces the influence of the
        /// start.
        settle_revolutions: f64 = default(number(0.0, 1000.0), SETTLE);
        /// Revolutions that are averaged. Raising it reduces the scatter of the means.
        revolutions: f64 = default(number(0.5, 1000.0), COUNTED);
        /// Mass that moves along the hole with the bit. Raising it damps the rate of penetration
        /// and follows the rock more slowly. Default: the mass whose weight is the mean of `wob`.
        mass: f64 = optional(Quantity::si(
            Dimension::Mass,
            Range::positive_to(1e6).usual(10.0, 2e5),
            "6 t",
        ));
        /// Time over which forces are averaged before their standard deviations are computed.
        /// Raising it smooths out swings. Default: `sample_interval` of [dynamics], so that they
        /// are those of a run's samples.
        averaging: f64 = optional(Quantity::si(
            Dimension::Time,
            Range::positive_to(10.0),
            "10 ms",
        ));
        /// Time step of bit and rock, within which the rock takes shorter steps of its own, and
        /// after which layers of rock that the bit has left are dropped.
        step: f64 = default(
            Quantity::si(Dimension::Time, Range::from_to(1e-5, 2e-3), "0.5 ms"),
            STEP_S,
        );
    }
}

fn number(from: f64, to: f64) -> Number {
    Number { unit: "", range: Range::from_to(from, to) }
}

/// A test of bit and rock without the string, under every weight at every speed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BitTest {
    /// Bit, rock, elements and contact.
    pub drilling: DrillingSpec,
    /// Weights on bit, N: from small to large, all above zero.
    pub weights_N: Vec<f64>,
    /// Rotary speeds of the bit, rad/s: from slow to fast, all above zero.
    pub rotary_speeds_rad_per_s: Vec<f64>,
    /// Revolutions at each point before those that are averaged.
    pub settle_revolutions: f64,
    /// Revolutions that are averaged.
    pub revolutions: f64,
    /// Mass that moves along the hole with the bit, kg.
    pub mass_kg: f64,
    /// Time over which forces are averaged before their standard deviations are computed, s: no
    /// shorter than the step.
    pub averaging_s: f64,
    /// Time step of bit and rock, s.
    pub step_s: f64,
}

impl BitTest {
    /// Total drilling time of all points, s.
    pub fn time_s(&self) -> f64 {
        let turned_rad = TAU * (self.settle_revolutions + self.revolutions);
        let speeds = self.rotary_speeds_rad_per_s.iter();
        let times = speeds.map(|speed| turned_rad / speed);
        self.weights_N.len() as f64 * times.sum::<f64>()
    }
}

/// Inputs of a test from the rest of the case.
pub(crate) struct Around<'a> {
    /// The rock under the bit.
    pub(crate) drilling: &'a DrillingSpec,
    pub(crate) bit: &'a BitSettings,
    pub(crate) operations: &'a [Operation],
    /// Time between the samples of a run, s.
    pub(crate) sample_interval_s: f64,
}

/// Builds the test, of a case that requires one, or whose operation gives enough for one.
pub(crate) fn build(
    table: &Spanned<BitTestTable>,
    requested: bool,
    around: &Around<'_>,
    reader: &mut Reader,
) -> Option<Option<BitTest>> {
    let drills = around.operations.iter().find(|one| one.kind.on_bottom());
    let weight_N = drills.map(|operation| operation.weight_on_bit_N);
    let speed = drills.map(|operation| around.bit.drilling_speed_rad_per_s(operation));
    let (keys, whole) = (&table.value, table.place);
    let weights = keys.wob.optional()?;
    let speeds = keys.rpm.optional()?;
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
    let mass = keys.mass.optional()?;
    let (averaging, step) = (keys.averaging.optional()?, keys.step.at()?);
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
        settle_revolutions: *keys.settle_revolutions.get()?,
        revolutions: *keys.revolutions.get()?,
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

/// Returns the list of the case, or factors on the operation's number; empty where neither is
/// given.
fn sorted(
    entry: Option<&Spanned<Vec<Spanned<f64>>>>,
    around: Option<f64>,
    factors: &[f64],
    unit: &str,
    worth: f64,
    reader: &mut Reader,
) -> Option<Vec<f64>> {
    let Some(entry) = entry else {
        let around = around.filter(|number| *number > 0.0);
        return Some(around.map_or_else(Vec::new, |number| {
            factors.iter().map(|factor| factor * number).collect()
        }));
    };
    let mut list = entry.value.clone();
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

/// The mistake of a bit that is no heavier than the rock elements that it touches.
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

/// Place of the table, if the case has it.
pub(crate) fn place(table: &Field<BitTestTable>) -> Option<Span> {
    table.given().map(|at| at.place)
}
