//! Names of pipe, and weights that a component of its diameters may have.

use std::f64::consts::FRAC_PI_4;

use wholestring_units::number_text;

/// Mass over that of a body of its metal below which the value has another meaning.
const LEAST: f64 = 0.4;

/// Allowance for rounding of the mass of a solid bar.
const ROUNDED: f64 = 1.001;

/// Checks a mass per length, kg/m, between a part of that of the body and that of a solid bar of its
/// largest diameter; the case has the same upper limit. `shown` writes a mass in the units of the
/// file.
///
/// # Errors
/// The expected mass, in words.
pub(crate) fn mass_in_range(
    mass_kg_per_m: f64,
    [od_m, id_m, widest_m]: [f64; 3],
    density_kg_per_m3: f64,
    shown: impl Fn(f64) -> String,
) -> Result<(), String> {
    let ring = |od_m: f64, id_m: f64| density_kg_per_m3 * FRAC_PI_4 * (od_m.powi(2) - id_m.powi(2));
    let (body, solid) = (ring(od_m, id_m), ring(widest_m, 0.0));
    if mass_kg_per_m > solid * ROUNDED {
        return Err(format!(
            "at most the {} of a solid bar of {} mm",
            shown(solid),
            number_text((widest_m * 1e4).round() / 10.0)
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
