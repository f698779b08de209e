//! `[steel]`.

use wholestring::string::Material;
use wholestring_config::prelude::*;

pub(crate) fn density() -> Quantity {
    Quantity::si(
        Dimension::Density,
        Range::from_to(1000.0, 25_000.0).usual(2500.0, 9000.0),
        "7860 kg/m3",
    )
}

pub(crate) fn modulus(example: &'static str) -> Quantity {
    Quantity::si(Dimension::Stress, Range::from_to(1e9, 1e12).usual(1e10, 3e11), example)
}

/// Default density of the string's metal, kg/m³.
pub const STEEL_DENSITY_KG_PER_M3: f64 = Material::STEEL.density_kg_per_m3;

table! {
    /// The metal of the string, for components that do not give their own.
    SteelTable in "[steel]" {
        /// Density.
        density: f64 = default(density(), STEEL_DENSITY_KG_PER_M3);
        /// Young's modulus.
        youngs_modulus: f64 = default(modulus("210 GPa"), Material::STEEL.youngs_modulus_Pa);
        /// Shear modulus, independent of Young's modulus.
        shear_modulus: f64 = default(modulus("76.923 GPa"), Material::STEEL.shear_modulus_Pa);
    }
}

impl SteelTable {
    pub(crate) fn build(&self, reader: &mut Reader) -> Option<Material> {
        let material = Material {
            density_kg_per_m3: *self.density.get()?,
            youngs_modulus_Pa: *self.youngs_modulus.get()?,
            shear_modulus_Pa: *self.shear_modulus.get()?,
            ..Material::STEEL
        };
        let entry = self.shear_modulus.given().or(self.youngs_modulus.given());
        if let Some(entry) = entry {
            check_moduli(&material, entry.place, reader);
        }
        Some(material)
    }
}

/// Warns of moduli that are inconsistent, because then one of the two was probably forgotten.
pub(crate) fn check_moduli(material: &Material, place: Span, reader: &mut Reader) {
    let poisson = material.youngs_modulus_Pa / (2.0 * material.shear_modulus_Pa) - 1.0;
    if !(0.0..=0.5).contains(&poisson) {
        Diagnostic::warning(format!(
            "the moduli of {} and {} make a Poisson's ratio of {}",
            reader.shown(Dimension::Stress, material.youngs_modulus_Pa),
            reader.shown(Dimension::Stress, material.shear_modulus_Pa),
            number_text((poisson * 100.0).round() / 100.0)
        ))
        .at(place, "Young's and shear modulus are given separately")
        .help("metals have 0.2 to 0.4; G = E/(2 (1 + ratio)); more than 0.5 counts as 0.5")
        .report(reader);
    }
}
