//! What the integration tests share: steel, simple strings and wells, verification files.
// Every test file uses its own part of this module.
#![allow(dead_code, unreachable_pub)]

use serde_json::Value;
use wholestring::string::Material;

/// A file of `verification/`, parsed.
pub fn verification(name: &str) -> Value {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../verification")
        .join(name);
    let text = std::fs::read_to_string(&path)
        .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// `|obtained - expected| / |expected|`.
pub fn relative_error(obtained: f64, expected: f64) -> f64 {
    (obtained - expected).abs() / expected.abs()
}

/// Steel of 7850 kg/m³, 210 GPa and 80 GPa.
pub fn steel() -> Material {
    Material {
        density_kg_per_m3: 7850.0,
        youngs_modulus_Pa: 210e9,
        shear_modulus_Pa: 80e9,
    }
}
