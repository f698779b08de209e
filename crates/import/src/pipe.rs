//! Names of pipe, and weights that a component of its diameters may have.

use std::f64::consts::FRAC_PI_4;

use wholestring_units::{Dimension, Unit, number_text};

/// Mass over that of a body of its metal below which the value has another meaning.
const LEAST: f64 = 0.4;

/// Mass over that of a steel body below which a component is not steel.
pub(crate) const LIGHTEST: f64 = 0.9;

/// Allowance for rounding of the mass of a solid bar.
const ROUNDED: f64 = 1.001;

/// Mass per length of the body of a component, kg/m, from its outside, inside and largest diameters.
pub(crate) fn body_mass([od_m, id_m, _]: [f64; 3], density_kg_per_m3: f64) -> f64 {
    density_kg_per_m3 * FRAC_PI_4 * (od_m.powi(2) - id_m.powi(2))
}

/// Mass per length of a solid bar of the largest of these diameters, kg/m.
fn solid_mass([_, _, widest_m]: [f64; 3], density_kg_per_m3: f64) -> f64 {
    body_mass([widest_m, 0.0, widest_m], density_kg_per_m3)
}

/// Hint at the unit in which an impossible mass per length would be that of a steel component:
/// pounds per foot under `kg/m`, or the reverse. Empty if there is none; otherwise it begins with
/// `; `.
pub(crate) fn other_unit(
    (number, unit): (f64, &Unit),
    diameters_m: [f64; 3],
    density_kg_per_m3: f64,
) -> String {
    let body = body_mass(diameters_m, density_kg_per_m3);
    let possible = LIGHTEST * body..=ROUNDED * solid_mass(diameters_m, density_kg_per_m3);
    let others = ["kg/m", "lb/ft"].map(|symbol| Dimension::MassPerLength.find_unit(symbol));
    let other = others
        .into_iter()
        .flatten()
        .find(|other| other.symbol != unit.symbol && possible.contains(&other.to_si(number)));
    other
        .map_or(String::new(), |other| format!("; if {} was meant, correct the unit", other.symbol))
}

/// Checks a mass per length, kg/m, between a part of that of the body and that of a solid bar of its
/// largest diameter; the case has the same upper limit. `shown` writes a mass in the units of the
/// file.
///
/// # Errors
/// The expected mass, in words.
pub(crate) fn mass_in_range(
    mass_kg_per_m: f64,
    diameters_m: [f64; 3],
    density_kg_per_m3: f64,
    shown: impl Fn(f64) -> String,
) -> Result<(), String> {
    let body = body_mass(diameters_m, density_kg_per_m3);
    let solid = solid_mass(diameters_m, density_kg_per_m3);
    if mass_kg_per_m > solid * ROUNDED {
        return Err(format!(
            "at most the {} of a solid bar of {} mm",
            shown(solid),
            number_text((diameters_m[2] * 1e4).round() / 10.0)
        ));
    }
    if mass_kg_per_m < LEAST * body {
        return Err(format!(
            "about the {} of its body or more (is the column the weight per length, and in the \
             right unit?)",
            shown(body)
        ));
    }
    Ok(())
}

/// Whether a component's name is that of pipe, which fills the string to the surface.
pub(crate) fn is_pipe(name: &str) -> bool {
    const WORDS: [&str; 10] =
        ["dp", "hwdp", "pipe", "drillpipe", "tubing", "ct", "coil", "coiled", "casing", "liner"];
    let lower = name.to_lowercase();
    lower.split(|c: char| !c.is_alphanumeric()).any(|word| WORDS.contains(&word))
}
