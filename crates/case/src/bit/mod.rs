//! `[bit]`.

mod excitation;
mod face;
mod file;
mod given;
mod misfit;
mod motor;
mod points;

use std::f64::consts::PI;

use wholestring::dynamics::{
    BitLaw, BitSettings, Cutters, DetournayDefournyLaw, Motor, RateLaw, RegenerativeLaw, RockLaw,
    TableLaw,
};
use wholestring::rock::{BitShape, DrillingSpec, bit_face::FaceError};
use wholestring_units::{Dimension, number_text};

use self::{excitation::ExcitationTable, face::FaceTable, motor::MotorTable, points::PointsTable};
pub(crate) use self::{face::settings as face_settings, given::Given};
use wholestring_config::{
    diagnostic::Diagnostic,
    names::any_of,
    number::{Count, Number},
    quantity::Quantity,
    range::Range,
    reader::Reader,
    rule::{Choice, Section},
    source::{Files, Place},
    table::{Field, default, optional, table},
};

/// The laws of the bit, without their numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Law {
    Rate,
    Regenerative,
    DetournayDefourny,
    Table,
    Rock,
}

impl Law {
    const WORDS: &[(&str, Self)] = &[
        ("rate", Self::Rate),
        ("regenerative", Self::Regenerative),
        ("detournay-defourny", Self::DetournayDefourny),
        ("table", Self::Table),
        ("rock", Self::Rock),
    ];

    /// Laws of a rock front.
    const FRONT: &[Self] = &[Self::Rate, Self::DetournayDefourny, Self::Table];

    /// Laws of cutters and wear flats.
    const CUTTERS: &[Self] = &[Self::Regenerative, Self::DetournayDefourny];

    fn word(self) -> &'static str {
        let found = Self::WORDS.iter().find(|(_, law)| *law == self);
        found.map_or("", |(word, _)| word)
    }
}

/// How a bit breaks rock.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Pdc,
    RollerCone,
    Core,
    Inserts,
}

impl Kind {
    const WORDS: &[(&str, Self)] = &[
        ("pdc", Self::Pdc),
        ("roller cone", Self::RollerCone),
        ("core", Self::Core),
        ("inserts", Self::Inserts),
    ];

    /// Inclination of the cutting force where the case does not say: the drag bit of Richard, Germay and Detournay's
    /// examples; of a roller cone `3/(4 · 0.25)`, such that its torque is 0.25 of `2aW/3`.
    fn inclination(self) -> f64 {
        match self {
            Self::RollerCone | Self::Inserts => 3.0,
            Self::Pdc | Self::Core => 0.6,
        }
    }

    /// Friction of the wear flats where the case does not say; teeth that roll rub half as much.
    fn friction(self) -> f64 {
        match self {
            Self::RollerCone | Self::Inserts => 0.3,
            Self::Pdc | Self::Core => 0.6,
        }
    }
}

/// Numbers of the laws where the case does not say: the rock and the cutters of Richard, Germay and
/// Detournay's examples, somewhat worn.
const BLADES: u64 = 4;
const SPECIFIC_ENERGY_PA: f64 = 60e6;
const WEAR_FLAT_M: f64 = 5e-3;
const CONTACT_STRENGTH_PA: f64 = 60e6;
const GEOMETRY: f64 = 1.0;
const FULL_CONTACT_M: f64 = 0.3e-3;
const ROCK_STIFFNESS_N_PER_M: f64 = 1e8;

fn number(to: f64) -> Number {
    Number {
        unit: "",
        range: Range::from_to(0.0, to),
    }
}

fn depth(example: &'static str) -> Quantity {
    Quantity::si(
        Dimension::Diameter,
        Range::from_to(0.0, 0.1).usual(1e-5, 0.02),
        example,
    )
}

table! {
    /// The bit on the rock.
    BitTable in "[bit]" {
        /// "rate" (the operation's rate of penetration in proportion to weight and speed, torque in
        /// proportion to weight), "regenerative" (Richard, Germay and Detournay: weight and torque from
        /// the depth of cut that the blade before has left, which sticks, slips and bounces by itself),
        /// "detournay-defourny" (weight and torque from the depth of cut of a revolution, in three regimes),
        /// "table" (rate and torque as they were measured) or "rock" (the bit's face breaks the solid rock of `[rock]`).
        /// Only the dynamic model lets the bit move; the soft string takes the law's steady torque.
        law: Law = default(
            Choice { noun: "a bit law", words: Law::WORDS },
            Law::Rate,
        );
        /// "pdc", "roller cone", "core" or "inserts" (fixed ones that crush and scrape). The laws of cutters take other
        /// numbers for a roller cone where none are given, cut a ring with a core bit and know no inserts; against solid rock
        /// the bit has the shape of `[bit.face]`, and cones that roll are not modelled.
        kind: Kind = default(
            Choice { noun: "a kind of bit", words: Kind::WORDS },
            Kind::Pdc,
        );
        /// Core bit: diameter of the core that it leaves. Raising it leaves less to cut.
        core_diameter: f64 = optional(Quantity::si(
            Dimension::Diameter,
            Range::positive_to(1.0).usual(0.01, 0.3),
            "4 in",
        ));
        /// Rate law: torque of the bit at the operation's weight on bit. Where an operation drills or
        /// slides and it is not given, the bit is taken to turn freely, and a warning says so.
        torque: f64 = optional(Quantity::si(
            Dimension::Torque,
            Range::from_to(0.0, 1e6).usual(50.0, 1e5),
            "3.1 kN.m",
        ));
        /// All laws but the regenerative and "rock": stiffness of the contact between bit and rock front. Raising it makes the weight on
        /// bit answer harder to axial motion. Only the dynamic model uses it.
        rock_stiffness: f64 = default(
            Quantity::si(Dimension::Stiffness, Range::from_to(1e4, 1e12).usual(1e6, 1e11), "1e8 N/m"),
            ROCK_STIFFNESS_N_PER_M,
        );
        /// All laws but the regenerative and "rock": what shakes the bit.
        excitation: ExcitationTable = optional(Section::<ExcitationTable>::RULE);
        /// Regenerative law: number of blades. Raising it stiffens the rock and shortens the delay.
        blades: u64 = default(Count { from: 1, to: 50 }, BLADES);
        /// Laws of cutters (regenerative, Detournay-Defourny): work that cutting takes per volume of rock. Raising it lowers the rate of
        /// penetration and stiffens the rock.
        intrinsic_specific_energy: f64 = default(
            Quantity::si(Dimension::Pressure, Range::from_to(1e5, 1e10).usual(1e6, 2e9), "60 MPa"),
            SPECIFIC_ENERGY_PA,
        );
        /// Laws of cutters: the cutting force along the hole over that around. Raising it takes more
        /// weight for the same torque. Default: 0.6, of a roller cone 3.
        cutter_inclination: f64 = optional(
            Number { unit: "", range: Range::from_to(0.01, 10.0) },
        );
        /// Laws of cutters: length of the wear flats of all blades together. Raising it lets more
        /// weight rest on them, which cuts nothing and damps axial motion.
        wear_flat: f64 = default(
            Quantity::si(Dimension::Diameter, Range::from_to(0.0, 0.1).usual(1e-5, 0.05), "5 mm"),
            WEAR_FLAT_M,
        );
        /// Laws of cutters: strength of the contact between wear flats and rock. Raising it does what
        /// longer wear flats do.
        contact_strength: f64 = default(
            Quantity::si(Dimension::Pressure, Range::from_to(0.0, 1e10).usual(1e6, 2e9), "60 MPa"),
            CONTACT_STRENGTH_PA,
        );
        /// Laws of cutters: where the wear flats lie; 1 for evenly over the radius, 4/3 for evenly over
        /// the face. Raising it raises their torque.
        bit_geometry: f64 = default(number(2.0), GEOMETRY);
        /// Laws of cutters: friction of the wear flats on rock. Raising it raises their torque. Default: 0.6, of a
        /// roller cone 0.3.
        friction: f64 = optional(number(2.0));
        /// Detournay-Defourny: depth of cut per revolution from which the wear flats are in full contact.
        /// Raising it lets a light weight cut more.
        full_contact_depth: f64 = default(depth("0.3 mm"), FULL_CONTACT_M);
        /// Detournay-Defourny: largest depth of cut per revolution that the mud keeps clean; what weight is beyond
        /// rubs and does not cut. Raising it lets the bit drill faster. Default: none.
        cleaning_limit: f64 = optional(Quantity::si(
            Dimension::Diameter,
            Range::positive_to(0.1).usual(1e-4, 0.03),
            "8 mm",
        ));
        /// The law "rock" and a bit test: the shape of the bit.
        face: FaceTable = optional(Section::<FaceTable>::RULE);
        /// The law "table": what was measured.
        table: PointsTable = optional(Section::<PointsTable>::RULE);
        /// Speed at which a mud motor turns the bit against the string, whatever the torque; a bare number is in
        /// rev/min. "slide" needs it, or `[bit.motor]`, where the bit's angle counts: in all laws but the rate law, and with
        /// an excitation.
        motor_speed: f64 = optional(
            Quantity::si(
                Dimension::RotarySpeed,
                Range::from_to(0.0, 1000.0 * PI / 30.0).usual(10.0 * PI / 30.0, 600.0 * PI / 30.0),
                "120 rpm",
            )
            .bare("rev/min", PI / 30.0),
        );
        /// A mud motor that turns with the flow and yields to the torque.
        motor: MotorTable = optional(Section::<MotorTable>::RULE);
        /// Side cutting: what the bit cuts sideways per side force over what it cuts ahead per weight. Raising it
        /// lets a side force move the bit off the hole's axis faster. Only the dynamic model uses it.
        steerability: f64 = default(number(1.0), 0.0);
        /// Lateral stiffness that holds the bit to the hole's axis, instead of contact and friction
        /// with the wall: the bit fills its hole. Raising it holds the bit closer. On solid rock it stands for what the wall
        /// is finer than bricks; with 0 the bricks alone hold the bit. Only the dynamic model
        /// uses it.
        lateral_stiffness: f64 = default(
            Quantity::si(Dimension::Stiffness, Range::from_to(0.0, 1e12).usual(1e4, 1e10), "1e7 N/m"),
            BitSettings::default().lateral_stiffness_N_per_m,
        );
    }
}

fn place<T>(field: &Field<T>) -> Option<Place> {
    field.given().map(|at| at.place)
}

/// What other tables tell of the bit, if they are sound.
pub(crate) struct Around<'a> {
    /// Radius of the lowest component, m.
    pub(crate) radius_m: Option<f64>,
    /// What the pumps deliver, m³/s.
    pub(crate) flow_m3_per_s: Option<f64>,
    /// What it is to drill, if that is solid rock.
    pub(crate) drilling: Option<&'a DrillingSpec>,
    /// Whether it is tested, whatever its law.
    pub(crate) is_tested: bool,
    pub(crate) files: &'a dyn Files,
}

impl BitTable {
    /// The bit.
    pub(crate) fn build(&self, around: &Around<'_>, reader: &mut Reader) -> Option<BitSettings> {
        self.warn_of_idle_keys(around.is_tested, reader);
        let law = *self.law.get()?;
        let points = match law {
            Law::Table => Some(self.points(around.files, reader)?),
            _ => None,
        };
        let excitation = self.excitation.get()?.build(points.as_ref(), reader)?;
        let rock_stiffness_N_per_m = *self.rock_stiffness.get()?;
        let law = match (law, points) {
            (Law::Table, Some(table)) => BitLaw::Table(TableLaw {
                table,
                rock_stiffness_N_per_m,
                excitation,
            }),
            (Law::Regenerative, _) => BitLaw::Regenerative(RegenerativeLaw {
                cutters: self.cutters(around.radius_m?, reader)?,
                blades: u32::try_from(*self.blades.get()?).ok()?,
            }),
            (Law::DetournayDefourny, _) => BitLaw::DetournayDefourny(DetournayDefournyLaw {
                cutters: self.cutters(around.radius_m?, reader)?,
                full_contact_depth_m: *self.full_contact_depth.get()?,
                cleaning_limit_m: self.cleaning_limit_m(reader)?,
                rock_stiffness_N_per_m,
                excitation,
            }),
            (Law::Rock, _) => BitLaw::Rock(Box::new(RockLaw {
                drilling: around.drilling?.clone(),
            })),
            _ => BitLaw::Rate(RateLaw {
                rock_stiffness_N_per_m,
                excitation,
            }),
        };
        Some(BitSettings {
            law,
            lateral_stiffness_N_per_m: *self.lateral_stiffness.get()?,
            steerability: *self.steerability.get()?,
            motor: self.drive(around.flow_m3_per_s, reader)?,
        })
    }

    fn points(
        &self,
        files: &dyn Files,
        reader: &mut Reader,
    ) -> Option<wholestring::dynamics::BitTable> {
        let Some(given) = self.table.given() else {
            if !matches!(self.table, Field::Bad) {
                let law = self.law.at()?;
                reader.report(
                    Diagnostic::error("the law \"table\" needs a table")
                        .at(law.place, "[bit.table] is missing")
                        .help("such as [bit.table] with file = \"bit.csv\""),
                );
            }
            return None;
        };
        given.value.build(given.place, files, reader)
    }

    /// The motor, in the one way or the other.
    fn drive(&self, flow_m3_per_s: Option<f64>, reader: &mut Reader) -> Option<Motor> {
        let speed = self.motor_speed.optional()?;
        match (self.motor.given(), speed) {
            (Some(motor), Some(speed)) => {
                reader.report(
                    Diagnostic::error("the motor is given twice")
                        .at(speed.place, "by a speed that nothing changes")
                        .at(motor.place, "by its curve")
                        .help("keep one of `motor_speed` and [bit.motor]"),
                );
                None
            }
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

    /// Whether what the pumps deliver turns a motor.
    pub(crate) fn takes_flow(&self) -> bool {
        self.motor.given().is_some()
    }

    fn cutters(&self, radius_m: f64, reader: &mut Reader) -> Option<Cutters> {
        let kind = self.kind.at()?;
        if kind.value == Kind::Inserts {
            reader.report(
                Diagnostic::error("the laws of cutters know no inserts")
                    .at(kind.place, "expected \"pdc\", \"roller cone\" or \"core\"")
                    .help("law = \"rock\" takes inserts"),
            );
            return None;
        }
        if (kind.value, self.law.get()?) == (Kind::RollerCone, &Law::Regenerative) {
            reader.report(
                Diagnostic::error(
                    "the regenerative law is that of blades, which a roller cone has not",
                )
                .at(kind.place, "expected \"pdc\" or \"core\"")
                .help("law = \"detournay-defourny\" takes a roller cone"),
            );
            return None;
        }
        let or = |field: &Field<f64>, default: f64| {
            Some(field.optional()?.map_or(default, |at| at.value))
        };
        Some(Cutters {
            radius_m,
            core_radius_m: self.core_radius_m(radius_m, reader)?,
            intrinsic_specific_energy_Pa: *self.intrinsic_specific_energy.get()?,
            cutter_inclination: or(&self.cutter_inclination, kind.value.inclination())?,
            wear_flat_m: *self.wear_flat.get()?,
            contact_strength_Pa: *self.contact_strength.get()?,
            bit_geometry: *self.bit_geometry.get()?,
            friction: or(&self.friction, kind.value.friction())?,
        })
    }

    /// The numbers of the bit's face, `radius_m` wide at the gauge.
    pub(crate) fn shape(&self, radius_m: f64, reader: &mut Reader) -> Option<BitShape> {
        let kind = self.kind.at()?;
        if kind.value == Kind::RollerCone {
            reader.report(
                Diagnostic::error("against solid rock, cones that roll are not modelled")
                    .at(kind.place, "expected \"pdc\", \"core\" or \"inserts\"")
                    .help("\"inserts\" holds their teeth still: these crush and scrape, and their torque is not that of rolling")
                    .help("the laws \"detournay-defourny\" and \"table\" take a roller cone"),
            );
            return None;
        }
        let core_radius_m = self.core_radius_m(radius_m, reader)?;
        let face = self.face.get()?;
        face.shape(kind.value, 2.0 * radius_m, 2.0 * core_radius_m, reader)
    }

    /// The mistake that leaves the bit without a face; `od` is where its diameter stands.
    pub(crate) fn misfit(&self, error: &FaceError, od: Place) -> Diagnostic {
        misfit::misfit(error, self, od)
    }

    fn core_radius_m(&self, radius_m: f64, reader: &mut Reader) -> Option<f64> {
        let kind = self.kind.at()?;
        match (kind.value, self.core_diameter.optional()?) {
            (Kind::Core, None) => {
                reader.report(
                    Diagnostic::error("a core bit needs the diameter of its core")
                        .at(kind.place, "`core_diameter` is missing in [bit]")
                        .help("such as core_diameter = \"4 in\""),
                );
                None
            }
            (Kind::Core, Some(core)) if core.value >= 2.0 * radius_m => {
                reader.report(
                    Diagnostic::error("the core is as wide as the bit, or wider").at(
                        core.place,
                        format!("expected less than {} m", number_text(2.0 * radius_m)),
                    ),
                );
                None
            }
            (Kind::Core, Some(core)) => Some(0.5 * core.value),
            _ => Some(0.0),
        }
    }

    fn cleaning_limit_m(&self, reader: &mut Reader) -> Option<Option<f64>> {
        let Some(limit) = self.cleaning_limit.optional()? else {
            return Some(None);
        };
        let full = self.full_contact_depth.at()?;
        if limit.value <= full.value {
            let mut diagnostic =
                Diagnostic::error("the bit is choked before its wear flats are in contact").at(
                    limit.place,
                    format!("expected more than {} m", number_text(full.value)),
                );
            if let Some(full) = self.full_contact_depth.given() {
                diagnostic = diagnostic.at(full.place, "full contact");
            }
            reader.report(diagnostic);
            return None;
        }
        Some(Some(limit.value))
    }

    fn warn_of_idle_keys(&self, is_tested: bool, reader: &mut Reader) {
        const SHAPED: &[Law] = &[Law::Regenerative, Law::DetournayDefourny, Law::Rock];
        const DETOURNAY: &[Law] = &[Law::DetournayDefourny];
        const REGENERATIVE: &[Law] = &[Law::Regenerative];
        let Some(law) = self.law.at() else { return };
        let belongs = [
            (place(&self.kind), "kind", SHAPED),
            (place(&self.face), "face", &[Law::Rock]),
            (place(&self.torque), "torque", &[Law::Rate]),
            (place(&self.rock_stiffness), "rock_stiffness", Law::FRONT),
            (place(&self.excitation), "excitation", Law::FRONT),
            (place(&self.blades), "blades", REGENERATIVE),
            (
                place(&self.intrinsic_specific_energy),
                "intrinsic_specific_energy",
                Law::CUTTERS,
            ),
            (
                place(&self.cutter_inclination),
                "cutter_inclination",
                Law::CUTTERS,
            ),
            (place(&self.wear_flat), "wear_flat", Law::CUTTERS),
            (
                place(&self.contact_strength),
                "contact_strength",
                Law::CUTTERS,
            ),
            (place(&self.bit_geometry), "bit_geometry", Law::CUTTERS),
            (place(&self.friction), "friction", Law::CUTTERS),
            (
                place(&self.full_contact_depth),
                "full_contact_depth",
                DETOURNAY,
            ),
            (place(&self.cleaning_limit), "cleaning_limit", DETOURNAY),
            (place(&self.table), "table", &[Law::Table]),
        ];
        for (place, name, owners) in belongs {
            let tested = is_tested && owners.contains(&Law::Rock);
            let Some(place) = place.filter(|_| !tested && !owners.contains(&law.value)) else {
                continue;
            };
            let words: Vec<&str> = owners.iter().map(|owner| owner.word()).collect();
            let mut diagnostic = Diagnostic::warning(format!("`{name}` has no effect here"))
                .at(place, format!("used with law = {}", any_of(&words)));
            diagnostic = match self.law.given() {
                Some(law) => diagnostic.at(law.place, "the law of the bit"),
                None => diagnostic.help("the law of the bit is \"rate\" where none is given"),
            };
            if name == "face" {
                diagnostic = diagnostic.help("a bit test, [bit_test], uses it with any law");
            }
            reader.report(diagnostic);
        }
        let Some(core) = self.core_diameter.given() else {
            return;
        };
        let cuts = is_tested || SHAPED.contains(&law.value);
        if !cuts || self.kind.get() != Some(&Kind::Core) {
            reader.report(
                Diagnostic::warning("`core_diameter` has no effect here").at(
                    core.place,
                    "used with kind = \"core\" and a law of cutters or rock",
                ),
            );
        }
    }
}
