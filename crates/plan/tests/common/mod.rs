//! Verification files and their units, shared by the tests.
// Every test file uses its own part of this module.
#![allow(dead_code, unused_imports)]

use serde_json::Value;
use wholestring::string::{Component, Material};
pub use wholestring_verification::file as verification;

pub const INCH_M: f64 = 0.0254;
pub const POUND_FORCE_N: f64 = 0.45359237 * 9.80665;
pub const FOOT_POUND_N_M: f64 = 0.3048 * POUND_FORCE_N;

/// Returns a number of such a file.
#[track_caller]
pub fn number(object: &Value, key: &str) -> f64 {
    object[key].as_f64().unwrap_or_else(|| panic!("no number {key} in {object}"))
}

/// Steel of 7850 kg/m³, 210 GPa and 80 GPa.
pub fn steel() -> Material {
    Material {
        density_kg_per_m3: 7850.0,
        youngs_modulus_Pa: 210e9,
        shear_modulus_Pa: 80e9,
        ..Material::STEEL
    }
}

/// A pipe of a yield strength, Pa.
pub fn pipe(od_m: f64, id_m: f64, yield_strength_Pa: f64) -> Component {
    Component {
        yield_strength_Pa: Some(yield_strength_Pa),
        ..Component::uniform("pipe", od_m, id_m, 1.0, steel())
    }
}

#[track_caller]
pub fn assert_close(what: &str, obtained: f64, expected: f64, tolerance: f64) {
    let error = (obtained - expected).abs() / expected.abs();
    assert!(error <= tolerance, "{what}: {obtained} for {expected}, {error:.2e} apart");
}
