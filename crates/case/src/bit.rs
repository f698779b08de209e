//! `[bit]`.

use std::f64::consts::PI;

use wholestring::dynamics::{Band, BitLaw, BitSettings, Excitation, RateLaw, RegenerativeLaw};
use wholestring_units::Dimension;

use crate::{
    diagnostic::Diagnostic,
    quantity::Quantity,
    range::{Count, Number, Range},
    reader::Reader,
    rule::{Choice, Section},
    source::Place,
    table::{Field, default, optional, table},
};

/// The laws of the bit, without their numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Law {
    Rate,
    Regenerative,
}

impl Law {
    const WORDS: &[(&str, Self)] = &[("rate", Self::Rate), ("regenerative", Self::Regenerative)];

    fn word(self) -> &'static str {
        let found = Self::WORDS.iter().find(|(_, law)| *law == self);
        found.map_or("", |(word, _)| word)
    }
}

/// Numbers of the laws where the case does not say: the rock and the cutters of Richard, Germay and
/// Detournay's examples, somewhat worn; three lobes of a tricone bit; noise up to eight waves per revolution.
const BLADES: u64 = 4;
const SPECIFIC_ENERGY_PA: f64 = 60e6;
const INCLINATION: f64 = 0.6;
const WEAR_FLAT_M: f64 = 5e-3;
const CONTACT_STRENGTH_PA: f64 = 60e6;
const GEOMETRY: f64 = 1.0;
const FRICTION: f64 = 0.6;
const LOBES: u64 = 3;
const WAVES: f64 = 8.0;

fn number(to: f64) -> Number {
    Number {
        unit: "",
        range: Range::from_to(0.0, to),
    }
}

fn rock_stiffness() -> f64 {
    match BitSettings::default().law {
        BitLaw::Rate(law) => law.rock_stiffness_N_per_m,
        BitLaw::Regenerative(_) => 0.0,
    }
}

table! {
    /// What shakes the bit of the rate law. Without any of it the bottom is smooth.
    ExcitationTable in "[bit.excitation]" {
        /// Lobes of the bottom pattern per revolution. Raising it raises the frequency.
        lobes: u64 = default(Count { from: 1, to: 100 }, LOBES);
        /// Amplitude of the lobes: half of what lies between crest and trough. Raising it raises the
        /// swing of the weight on bit at so many times the rotary speed, until the bit bounces.
        amplitude: f64 = default(displacement(), 0.0);
        /// Roughness of the bottom, rms. Raising it raises the noise of the weight on bit, until the
        /// bit bounces.
        roughness: f64 = default(displacement(), 0.0);
        /// Fluctuation of the bit's torque, rms, as a fraction of the torque. Raising it raises the
        /// noise of the torque.
        torque_fluctuation: f64 = default(number(1.0), 0.0);
        /// Waves per revolution at which the power density of roughness and torque fluctuation has
        /// fallen to half. Raising it makes the noise finer.
        waves: f64 = default(
            Number { unit: "", range: Range::positive_to(1000.0) },
            WAVES,
        );
        /// The same as a frequency, for noise that goes by time and not by the bit's angle.
        frequency: f64 = optional(Quantity::si(
            Dimension::Frequency,
            Range::positive_to(1000.0),
            "20 Hz",
        ));
    }
}

fn displacement() -> Quantity {
    Quantity::si(Dimension::Diameter, Range::from_to(0.0, 0.1), "1 mm")
}

table! {
    /// The bit on the rock.
    BitTable in "[bit]" {
        /// "rate" (the operation's rate of penetration in proportion to weight and speed, torque in
        /// proportion to weight) or "regenerative" (Richard, Germay and Detournay: weight and torque from
        /// the depth of cut that the blade before has left, which sticks, slips and bounces by itself).
        /// Only the dynamic model lets the bit move; the soft string takes the law's steady torque.
        law: Law = default(
            Choice { noun: "a bit law", words: Law::WORDS },
            Law::Rate,
        );
        /// Rate law: torque of the bit at the operation's weight on bit. Where an operation drills or
        /// slides and it is not given, the bit is taken to turn freely, and a warning says so.
        torque: f64 = optional(Quantity::si(
            Dimension::Torque,
            Range::from_to(0.0, 1e6),
            "3.1 kN.m",
        ));
        /// Rate law: stiffness of the contact between bit and rock front. Raising it makes the weight on
        /// bit answer harder to axial motion. Only the dynamic model uses it.
        rock_stiffness: f64 = default(
            Quantity::si(Dimension::Stiffness, Range::from_to(1e4, 1e12), "1e8 N/m"),
            rock_stiffness(),
        );
        /// Rate law: what shakes the bit.
        excitation: ExcitationTable = optional(Section::<ExcitationTable>::RULE);
        /// Regenerative law: number of blades. Raising it stiffens the rock and shortens the delay.
        blades: u64 = default(Count { from: 1, to: 50 }, BLADES);
        /// Regenerative law: work that cutting takes per volume of rock. Raising it lowers the rate of
        /// penetration and stiffens the rock.
        intrinsic_specific_energy: f64 = default(
            Quantity::si(Dimension::Pressure, Range::from_to(1e5, 1e10), "60 MPa"),
            SPECIFIC_ENERGY_PA,
        );
        /// Regenerative law: the cutting force along the hole over that around. Raising it takes more
        /// weight for the same torque.
        cutter_inclination: f64 = default(
            Number { unit: "", range: Range::from_to(0.01, 10.0) },
            INCLINATION,
        );
        /// Regenerative law: length of the wear flats of all blades together. Raising it lets more
        /// weight rest on them, which cuts nothing and damps axial motion.
        wear_flat: f64 = default(
            Quantity::si(Dimension::Diameter, Range::from_to(0.0, 0.1), "5 mm"),
            WEAR_FLAT_M,
        );
        /// Regenerative law: strength of the contact between wear flats and rock. Raising it does what
        /// longer wear flats do.
        contact_strength: f64 = default(
            Quantity::si(Dimension::Pressure, Range::from_to(0.0, 1e10), "60 MPa"),
            CONTACT_STRENGTH_PA,
        );
        /// Regenerative law: where the wear flats lie; 1 for evenly over the radius, 4/3 for evenly over
        /// the face. Raising it raises their torque.
        bit_geometry: f64 = default(number(2.0), GEOMETRY);
        /// Regenerative law: friction of the wear flats on rock. Raising it raises their torque.
        friction: f64 = default(number(2.0), FRICTION);
        /// Speed at which a mud motor turns the bit against the string; a bare number is in rev/min.
        /// "slide" needs it where the bit's angle counts: in the regenerative law, and with an excitation.
        motor_speed: f64 = optional(
            Quantity::si(
                Dimension::RotarySpeed,
                Range::from_to(0.0, 1000.0 * PI / 30.0),
                "120 rpm",
            )
            .bare("rev/min", PI / 30.0),
        );
        /// Lateral stiffness that holds the bit to the hole's axis, instead of contact and friction
        /// with the wall: the bit fills its hole. Raising it holds the bit closer. Only the dynamic model
        /// uses it.
        lateral_stiffness: f64 = default(
            Quantity::si(Dimension::Stiffness, Range::from_to(0.0, 1e12), "1e7 N/m"),
            BitSettings::default().lateral_stiffness_N_per_m,
        );
    }
}

fn place<T>(field: &Field<T>) -> Option<Place> {
    field.given().map(|at| at.place)
}

impl BitTable {
    /// The bit, whose radius is that of the lowest component, if that one is sound.
    pub(crate) fn build(&self, radius_m: Option<f64>, reader: &mut Reader) -> Option<BitSettings> {
        self.warn_of_idle_keys(reader);
        let excitation = self.excitation.get()?.build(reader)?;
        let law = match self.law.get()? {
            Law::Rate => BitLaw::Rate(RateLaw {
                rock_stiffness_N_per_m: *self.rock_stiffness.get()?,
                excitation,
            }),
            Law::Regenerative => BitLaw::Regenerative(RegenerativeLaw {
                radius_m: radius_m?,
                blades: u32::try_from(*self.blades.get()?).ok()?,
                intrinsic_specific_energy_Pa: *self.intrinsic_specific_energy.get()?,
                cutter_inclination: *self.cutter_inclination.get()?,
                wear_flat_m: *self.wear_flat.get()?,
                contact_strength_Pa: *self.contact_strength.get()?,
                bit_geometry: *self.bit_geometry.get()?,
                friction: *self.friction.get()?,
            }),
        };
        Some(BitSettings {
            law,
            lateral_stiffness_N_per_m: *self.lateral_stiffness.get()?,
            motor_speed_rad_per_s: self.motor_speed.optional()?.map_or(0.0, |at| at.value),
        })
    }

    fn warn_of_idle_keys(&self, reader: &mut Reader) {
        let Some(law) = self.law.at() else { return };
        let belongs = [
            (place(&self.torque), "torque", Law::Rate),
            (place(&self.rock_stiffness), "rock_stiffness", Law::Rate),
            (place(&self.excitation), "excitation", Law::Rate),
            (place(&self.blades), "blades", Law::Regenerative),
            (
                place(&self.intrinsic_specific_energy),
                "intrinsic_specific_energy",
                Law::Regenerative,
            ),
            (
                place(&self.cutter_inclination),
                "cutter_inclination",
                Law::Regenerative,
            ),
            (place(&self.wear_flat), "wear_flat", Law::Regenerative),
            (
                place(&self.contact_strength),
                "contact_strength",
                Law::Regenerative,
            ),
            (place(&self.bit_geometry), "bit_geometry", Law::Regenerative),
            (place(&self.friction), "friction", Law::Regenerative),
        ];
        for (place, name, owner) in belongs {
            let Some(place) = place.filter(|_| owner != law.value) else {
                continue;
            };
            let mut diagnostic = Diagnostic::warning(format!("`{name}` has no effect here"))
                .at(place, format!("used with law = \"{}\"", owner.word()));
            diagnostic = match self.law.given() {
                Some(law) => diagnostic.at(law.place, "the law of the bit"),
                None => diagnostic.help("the law of the bit is \"rate\" where none is given"),
            };
            reader.report(diagnostic);
        }
    }
}

impl ExcitationTable {
    /// The excitation, if anything shakes.
    fn build(&self, reader: &mut Reader) -> Option<Option<Excitation>> {
        let frequency = self.frequency.optional()?;
        if let (Some(frequency), Some(waves)) = (frequency, self.waves.given()) {
            reader.report(
                Diagnostic::error("the noise goes by time or by the bit's angle, not by both")
                    .at(frequency.place, "by time")
                    .at(waves.place, "by the bit's angle")
                    .help("give one of `frequency` and `waves`"),
            );
            return None;
        }
        let excitation = Excitation {
            lobes: u32::try_from(*self.lobes.get()?).ok()?,
            amplitude_m: *self.amplitude.get()?,
            roughness_m: *self.roughness.get()?,
            torque_fluctuation: *self.torque_fluctuation.get()?,
            band: match frequency {
                Some(frequency) => Band::PerSecond(frequency.value),
                None => Band::PerRevolution(*self.waves.get()?),
            },
        };
        let lobed = excitation.amplitude_m > 0.0;
        let noisy = excitation.roughness_m > 0.0 || excitation.torque_fluctuation > 0.0;
        let noise = "used with `roughness` or `torque_fluctuation`";
        for (place, name, used, with) in [
            (place(&self.lobes), "lobes", lobed, "used with `amplitude`"),
            (place(&self.waves), "waves", noisy, noise),
            (place(&self.frequency), "frequency", noisy, noise),
        ] {
            if let Some(place) = place.filter(|_| !used) {
                let message = format!("`{name}` has no effect here");
                reader.report(Diagnostic::warning(message).at(place, with));
            }
        }
        Some((lobed || noisy).then_some(excitation))
    }
}
