//! The interface of the keys of a law, and the keys that several laws share.

use wholestring::{
    dynamics::{BitLaw, BitSettings, BitTable as Points, Cutters, Excitation},
    operation::Operation,
};
use wholestring_config::{
    diagnostic::Diagnostic, prelude::*, reader::Reader, rule::Spanned, source::Span,
};

use crate::bit::{
    excitation::ExcitationTable,
    given::{Around, Given},
    kind::{Kind, KindKeys},
};

/// The keys of a law: the law that they give, and its effect on the operation's set points.
pub(crate) trait LawKeys {
    /// Builds the law; `place` is where it was chosen.
    fn build(&self, place: Span, around: &Around<'_>, reader: &mut Reader) -> Option<BitLaw>;

    /// The reason why `rop` has no effect, of a law that computes torque and rate of penetration
    /// from weight and speed; `None` where they are the operation's.
    fn finds_rate(&self) -> Option<&'static str>;

    /// Torque at the operation's weight on bit, N.m, of a law that does not compute it; the inner
    /// `None` follows a mistake.
    fn torque_N_m(&self) -> Option<Option<f64>> {
        Some(None)
    }

    /// Warns of a weight on bit of which the law uses little.
    fn warn_of_weight(&self, _law: &BitLaw, _wob: &Spanned<f64>, _reader: &mut Reader) {}

    /// Refuses an operation that the law does not support.
    fn check_operation(
        &self,
        _bit: &BitSettings,
        _operation: &Operation,
        _given: &Given<'_>,
        _reader: &mut Reader,
    ) -> Option<()> {
        Some(())
    }

    /// Warns of set points that the law does not use.
    fn warn_of_set_points(&self, law: &BitLaw, set_points: &Given<'_>, reader: &mut Reader) {
        if let Some((finds, rop)) = self.finds_rate().zip(set_points.rop) {
            reader.report(Diagnostic::idle("rop", rop.place, finds));
        }
        if let Some(wob) = set_points.wob {
            self.warn_of_weight(law, wob, reader);
        }
    }
}

// Cutters and wear flats, for laws of the Detournay and Defourny type.

/// Defaults: the rock and the cutters of Richard, Germay and Detournay's examples, somewhat worn.
const SPECIFIC_ENERGY_PA: f64 = 60e6;
const WEAR_FLAT_M: f64 = 5e-3;
const CONTACT_STRENGTH_PA: f64 = 60e6;
const GEOMETRY: f64 = 1.0;

keys! {
    /// Cutters and wear flats.
    CuttersKeys {
        ..kind: KindKeys;
        /// Work of cutting per volume of rock. Raising it lowers the rate of penetration and
        /// stiffens the rock.
        intrinsic_specific_energy: f64 = default(
            Quantity::si(Dimension::Stress, Range::from_to(1e5, 1e10).usual(1e6, 2e9), "60 MPa"),
            SPECIFIC_ENERGY_PA,
        );
        /// Ratio of the axial to the tangential cutting force. Raising it requires more weight for
        /// the same torque. Default: 0.6, of a roller cone 3.
        cutter_inclination: f64 = optional(
            Number { unit: "", range: Range::from_to(0.01, 10.0) },
        );
        /// Length of the wear flats of all blades together. Raising it puts more weight on the
        /// flats, which does not cut and which damps axial motion.
        wear_flat: f64 = default(
            Quantity::si(Dimension::Diameter, Range::from_to(0.0, 0.1).usual(1e-5, 0.05), "5 mm"),
            WEAR_FLAT_M,
        );
        /// Strength of the contact between wear flats and rock. Raising it has the same effect as
        /// longer wear flats.
        contact_strength: f64 = default(
            Quantity::si(Dimension::Stress, Range::from_to(0.0, 1e10).usual(1e6, 2e9), "60 MPa"),
            CONTACT_STRENGTH_PA,
        );
        /// Distribution of the wear flats; 1 for evenly over the radius, 4/3 for evenly over the
        /// face. Raising it raises their torque.
        bit_geometry: f64 = default(Number::up_to(2.0), GEOMETRY);
        /// Friction of the wear flats on rock. Raising it raises their torque. Default: 0.6, of a
        /// roller cone 0.3.
        friction: f64 = optional(Number::up_to(2.0));
    }
}

impl CuttersKeys {
    /// Returns the cutters of a bit, `radius_m` wide at the gauge.
    pub(super) fn build(&self, radius_m: f64, reader: &mut Reader) -> Option<Cutters> {
        let kind = self.kind.kind.at()?;
        if kind.value == Kind::Inserts {
            return Diagnostic::error("the laws of cutters know no inserts")
                .at(kind.place, "expected \"pdc\", \"roller cone\" or \"core\"")
                .help("law = \"rock\" supports inserts")
                .refuse(reader);
        }
        let or = |field: &Field<f64>, default: f64| {
            Some(field.optional()?.map_or(default, |at| at.value))
        };
        Some(Cutters {
            radius_m,
            core_radius_m: self.kind.core_radius_m(radius_m, reader)?,
            intrinsic_specific_energy_Pa: *self.intrinsic_specific_energy.get()?,
            cutter_inclination: or(&self.cutter_inclination, kind.value.inclination())?,
            wear_flat_m: *self.wear_flat.get()?,
            contact_strength_Pa: *self.contact_strength.get()?,
            bit_geometry: *self.bit_geometry.get()?,
            friction: or(&self.friction, kind.value.friction())?,
        })
    }
}

// The rock front of the laws whose only state of the bottom is its depth.

/// Default.
const ROCK_STIFFNESS_N_PER_M: f64 = 1e8;

keys! {
    /// A rock front.
    FrontKeys {
        /// Stiffness of the contact between bit and rock front. Raising it raises the change of the
        /// weight on bit with axial motion. Only the dynamic model uses it.
        rock_stiffness: f64 = default(
            Quantity::si(Dimension::Stiffness, Range::from_to(1e4, 1e12).usual(1e6, 1e11), "1e8 N/m"),
            ROCK_STIFFNESS_N_PER_M,
        );
        /// Excitation of the bit.
        excitation: ExcitationTable = optional(Section::<ExcitationTable>::RULE);
    }
}

impl FrontKeys {
    /// Returns stiffness, N/m, and excitation; a measured table of the bit may give the standard
    /// deviations of the excitation.
    pub(crate) fn build(
        &self,
        points: Option<&Points>,
        reader: &mut Reader,
    ) -> Option<(f64, Option<Excitation>)> {
        let excitation = self.excitation.get()?.build(points, reader)?;
        Some((*self.rock_stiffness.get()?, excitation))
    }
}
