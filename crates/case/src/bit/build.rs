//! The bit of the engine, from the keys.

use wholestring::{
    dynamics::{
        BitLaw, BitSettings, Cutters, DetournayDefournyLaw, Motor, RateLaw, RegenerativeLaw,
        RockLaw, TableLaw,
    },
    rock::{BitShape, DrillingSpec},
};
use wholestring_units::number_text;

use wholestring_config::{
    diagnostic::Diagnostic, names::any_of, reader::Reader, rule::Table, source::Files, table::Field,
};

use super::{
    kind::Kind,
    law::{Law, ROCK, SHAPED},
    table::BitTable,
};

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
            (Law::Table, Some(table)) => {
                BitLaw::Table(TableLaw { table, rock_stiffness_N_per_m, excitation })
            }
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
            (Law::Rock, _) => {
                BitLaw::Rock(Box::new(RockLaw { drilling: around.drilling?.clone() }))
            }
            _ => BitLaw::Rate(RateLaw { rock_stiffness_N_per_m, excitation }),
        };
        Some(BitSettings {
            law,
            lateral_stiffness_N_per_m: *self.lateral_stiffness.get()?,
            steerability: *self.steerability.get()?,
            motor: self.drive(around.flow_m3_per_s, reader)?,
            // A program's own.
            excitation: None,
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
                    .help(
                        "\"inserts\" holds their teeth still: these crush and scrape, and their \
                           torque is not that of rolling",
                    )
                    .help("the laws \"detournay-defourny\" and \"table\" take a roller cone"),
            );
            return None;
        }
        let core_radius_m = self.core_radius_m(radius_m, reader)?;
        let face = self.face.get()?;
        face.shape(kind.value, 2.0 * radius_m, 2.0 * core_radius_m, reader)
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
                reader.report(Diagnostic::error("the core is as wide as the bit, or wider").at(
                    core.place,
                    format!("expected less than {} m", number_text(2.0 * radius_m)),
                ));
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
                Diagnostic::error("the bit is choked before its wear flats are in contact")
                    .at(limit.place, format!("expected more than {} m", number_text(full.value)));
            if let Some(full) = self.full_contact_depth.given() {
                diagnostic = diagnostic.at(full.place, "full contact");
            }
            reader.report(diagnostic);
            return None;
        }
        Some(Some(limit.value))
    }

    fn warn_of_idle_keys(&self, is_tested: bool, reader: &mut Reader) {
        let Some(law) = self.law.at() else { return };
        let word = law.value.word();
        for key in self.written() {
            if key.is_used_with(word) || (is_tested && key.is_used_with(ROCK)) {
                continue;
            }
            let name = key.name;
            let mut diagnostic = Diagnostic::warning(format!("`{name}` has no effect here"))
                .at(key.place, format!("used with law = {}", any_of(key.used_with)));
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
        let cuts = is_tested || SHAPED.contains(&word);
        if !cuts || self.kind.get() != Some(&Kind::Core) {
            reader.report(
                Diagnostic::warning("`core_diameter` has no effect here")
                    .at(core.place, "used with kind = \"core\" and a law of cutters or rock"),
            );
        }
    }
}
