//! The bit of the engine, from the keys.

use std::f64::consts::PI;

use wholestring::{
    dynamics::{BitSettings, Motor},
    rock::BitShape,
};
use wholestring_config::prelude::*;

use super::{
    given::Around,
    kind::Kind,
    law::{LawKeys, Laws, ROCK},
    motor::MotorTable,
};

table! {
    /// The bit on the rock.
    BitTable in "[bit]" {
        ..laws: Laws;
        /// Speed at which a mud motor turns the bit relative to the string, whatever the torque; a
        /// bare number is in rev/min. "slide" needs it, or `[bit.motor]`, where the bit's angle
        /// counts: in all laws but the rate law, and with an excitation.
        motor_speed: f64 = optional(
            Quantity::si(
                Dimension::RotarySpeed,
                Range::from_to(0.0, 1000.0 * PI / 30.0).usual(10.0 * PI / 30.0, 600.0 * PI / 30.0),
                "120 rpm",
            )
            .bare("rev/min", PI / 30.0),
        );
        /// A mud motor whose speed depends on flow and torque.
        motor: MotorTable = optional(Section::<MotorTable>::RULE);
        /// Side cutting: sideways cut of the bit per side force over its axial cut per weight.
        /// Raising it lets a side force move the bit off the hole's axis faster. Only the dynamic
        /// model uses it.
        steerability: f64 = default(Number::up_to(1.0), 0.0);
        /// Lateral stiffness that holds the bit to the hole's axis, in place of contact and
        /// friction with the wall, because the bit fills its hole. Raising it holds the bit closer.
        /// On solid rock it represents wall detail finer than the elements; with 0 the elements
        /// alone hold the bit. The soft string does not use it.
        lateral_stiffness: f64 = default(
            Quantity::si(Dimension::Stiffness, Range::from_to(0.0, 1e12).usual(1e4, 1e10), "1e7 N/m"),
            BitSettings::default().lateral_stiffness_N_per_m,
        );
    }
}

impl BitTable {
    /// Returns the bit.
    pub(crate) fn build(&self, around: &Around<'_>, reader: &mut Reader) -> Option<BitSettings> {
        self.warn_of_idle_keys(around.is_tested, reader);
        let (keys, law) = (self.law_keys()?, self.laws.law.at()?);
        if !Laws::users_of("excitation").contains(&self.laws.word()?) {
            // The front has no effect here, but its keys must not contradict each other.
            self.laws.rate.front.build(None, reader)?;
        }
        Some(BitSettings {
            law: keys.build(law.place, around, reader)?,
            lateral_stiffness_N_per_m: *self.lateral_stiffness.get()?,
            steerability: *self.steerability.get()?,
            motor: self.drive(around.flow_m3_per_s, reader)?,
            // Set by programs only.
            excitation: None,
        })
    }

    /// Returns the keys of the law that was chosen.
    pub(crate) fn law_keys(&self) -> Option<&dyn LawKeys> {
        self.laws.chosen()
    }

    /// Returns the motor, from either of the two ways to give it.
    fn drive(&self, flow_m3_per_s: Option<f64>, reader: &mut Reader) -> Option<Motor> {
        let speed = self.motor_speed.optional()?;
        match (self.motor.given(), speed) {
            (Some(motor), Some(speed)) => Diagnostic::error("the motor is given twice")
                .at(speed.place, "by a constant speed")
                .at(motor.place, "by its curve")
                .help("keep one of `motor_speed` and [bit.motor]")
                .refuse(reader),
            (Some(motor), None) => {
                let motor = motor.value.build(motor.place, flow_m3_per_s, reader)?;
                Some(Motor::Displacement(motor))
            }
            (None, speed) if !matches!(self.motor, Field::Bad) => {
                Some(Motor::Speed(speed.map_or(0.0, |at| at.value)))
            }
            _ => None,
        }
    }

    /// Whether a motor is given, in either way.
    pub(crate) fn has_motor(&self) -> bool {
        self.motor_speed.given().is_some() || self.motor.given().is_some()
    }

    /// Whether the flow of the pumps turns a motor.
    pub(crate) fn takes_flow(&self) -> bool {
        self.motor.given().is_some()
    }

    /// Returns the numbers of the bit's face, `radius_m` wide at the gauge.
    pub(crate) fn shape(&self, radius_m: f64, reader: &mut Reader) -> Option<BitShape> {
        self.laws.rock.shape(radius_m, reader)
    }

    fn warn_of_idle_keys(&self, is_tested: bool, reader: &mut Reader) {
        let Some(word) = self.laws.word() else { return };
        let is_used = |words: &[&str]| {
            words.is_empty() || words.contains(&word) || (is_tested && words.contains(&ROCK))
        };
        for key in self.written() {
            // The kind of bit gives a more specific message for the core's diameter.
            if is_used(&key.used_with) || key.name == "core_diameter" {
                continue;
            }
            let why = format!("used with law = {}", any_of(&key.used_with));
            let mut diagnostic = Diagnostic::idle(key.name, key.place, why).chosen(
                "the law of the bit",
                self.laws.law.place(),
                "rate",
            );
            if key.name == "face" {
                diagnostic = diagnostic.help("a bit test, [bit_test], uses it with any law");
            }
            reader.report(diagnostic);
        }
        let Some(core) = self.laws.kind.core_diameter.given() else {
            return;
        };
        let cuts = is_used(&Laws::users_of("core_diameter"));
        if !cuts || self.laws.kind.kind.get() != Some(&Kind::Core) {
            let why = "used with kind = \"core\" and a law of cutters or rock";
            reader.report(Diagnostic::idle("core_diameter", core.place, why));
        }
    }
}
