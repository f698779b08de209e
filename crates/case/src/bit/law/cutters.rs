//! Cutters and wear flats, for laws of the Detournay and Defourny type.

use wholestring::dynamics::Cutters;
use wholestring_config::prelude::*;

use crate::bit::kind::{Kind, KindKeys};

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
