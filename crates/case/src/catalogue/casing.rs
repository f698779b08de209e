//! `[[casing]]` of a user's own catalogue.

use std::f64::consts::PI;

use wholestring::well::casing::{Casing, CasingGrade, drift_m};
use wholestring_config::prelude::*;

use crate::string::component::{diameter, mass_per_length, yield_strength};

/// Density of steel, kg/m³.
const STEEL_KG_PER_M3: f64 = 7850.0;

table! {
    /// A casing of the user's own.
    OwnCasingTable in "[[casing]]" {
        /// Name that `casing` under [[well.hole]] refers to.
        name: String = required(Text);
        /// Outside diameter.
        od: f64 = required(diameter("244.5 mm"));
        /// Inside diameter, less than od: the string moves in it.
        id: f64 = required(diameter("224.4 mm"));
        /// Diameter of the mandrel that passes every joint, not more than id. Default: the value of
        /// API Spec 5CT for its size.
        drift: f64 = optional(diameter("220.4 mm"));
        /// Mass per length in air, couplings included. Default: the body's, of steel.
        mass_per_length: f64 = optional(mass_per_length());
        /// Minimum yield strength, for burst and collapse of worn casing. Default: unknown.
        yield_strength: f64 = optional(yield_strength());
    }
}

impl OwnCasingTable {
    pub(super) fn build(&self, reader: &mut Reader) -> Option<Casing> {
        let (od, id) = (self.od.at()?, self.id.at()?);
        if id.value >= od.value {
            return Diagnostic::error(
                "the inside diameter is not smaller than the outside diameter",
            )
            .at(
                id.place,
                format!("expected less than {}", reader.shown(Dimension::Diameter, od.value)),
            )
            .at(od.place, "the outside diameter")
            .refuse(reader);
        }
        let drift = self.drift.optional()?;
        if let Some(drift) = drift
            && drift.value > id.value
        {
            return Diagnostic::error("the drift mandrel does not pass the casing")
                .at(
                    drift.place,
                    format!("expected {} or less", reader.shown(Dimension::Diameter, id.value)),
                )
                .at(id.place, "the inside diameter")
                .refuse(reader);
        }
        let body_kg_per_m = 0.25 * PI * (od.value.powi(2) - id.value.powi(2)) * STEEL_KG_PER_M3;
        // The name contains the grade.
        let grade =
            |yields: &Spanned<f64>| CasingGrade { name: "", yield_strength_Pa: yields.value };
        Some(Casing {
            designation: self.name.get()?.clone(),
            od_m: od.value,
            id_m: id.value,
            drift_m: drift.map_or_else(|| drift_m(od.value, id.value), |at| at.value),
            mass_per_length_kg_per_m: self
                .mass_per_length
                .optional()?
                .map_or(body_kg_per_m, |at| at.value),
            grade: self.yield_strength.optional()?.map(grade),
        })
    }
}
