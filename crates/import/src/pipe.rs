//! Names of pipe, weights that a component of its diameters may have, and grades of steel.

use std::f64::consts::FRAC_PI_4;

use wholestring::well::casing;
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

// Grades of steel.

/// Grades and their minimum yield strength, psi: API Spec 5DP, and two on which makers agree (Z,
/// V).
const GRADES: [(&str, f64); 6] = [
    ("E75", 75_000.0),
    ("X95", 95_000.0),
    ("G105", 105_000.0),
    ("S135", 135_000.0),
    ("Z140", 140_000.0),
    ("V150", 150_000.0),
];

/// Psi, Pa.
const PSI_PA: f64 = 6_894.757_293_168_361;

/// Minimum yield strength of a grade of drill pipe, or of casing in the notation of API Spec 5CT,
/// psi: `S-135`, `G105`, `s 135`, `L-80`, `P110`.
pub(crate) fn yield_psi(grade: &str) -> Option<f64> {
    let plain = |text: &str| -> String {
        text.chars().filter(|c| c.is_alphanumeric()).take(16).collect::<String>().to_uppercase()
    };
    let name = plain(grade);
    let name = name.strip_prefix("GRADE").unwrap_or(&name);
    // A letter alone is a grade of drill pipe.
    let name = match name {
        "E" => "E75",
        "X" => "X95",
        "G" => "G105",
        "S" => "S135",
        name => name,
    };
    let pipe = GRADES.iter().find(|(grade, _)| *grade == name).map(|(_, psi)| *psi);
    let name = kind_of_grade(name).unwrap_or(name);
    pipe.or_else(|| {
        let mut grades = casing::grades().filter(|grade| !grade.name.is_empty());
        let casing = grades.find(|grade| plain(grade.name) == name);
        let casing = casing.map(|casing| (casing.yield_strength_Pa / PSI_PA).round());
        casing.or_else(|| chromium_psi(name))
    })
}

/// The grade of API Spec 5CT of which a name is a type: `N-80Q`, `N80 Type 1`, `L80-13Cr`. Types of a
/// grade have its yield strength.
fn kind_of_grade(name: &str) -> Option<&str> {
    ["TYPE1", "TYPEQ", "Q", "9CR", "13CR"].iter().find_map(|kind| {
        let grade = name.strip_suffix(kind)?;
        (grade.len() == 3).then_some(grade)
    })
}

/// Minimum yield strength, psi, of steel with 13 % chromium, whose name ends with it in ksi:
/// `13Cr-95`.
fn chromium_psi(name: &str) -> Option<f64> {
    let ksi: f64 = name.strip_prefix("13CR")?.parse().ok()?;
    (80.0..=125.0).contains(&ksi).then_some(ksi * 1000.0)
}

/// The grade that a pipe name contains as a word: `DP 5 in S-135`.
pub(crate) fn grade_in_name(name: &str) -> Option<&str> {
    let words = name.split([' ', ',', '(', ')', '/', ';']);
    words.into_iter().find(|word| word.len() > 2 && yield_psi(word).is_some())
}

#[cfg(test)]
mod tests {
    use super::{grade_in_name, yield_psi};

    #[test]
    fn grades_are_known_however_they_are_written() {
        for grade in ["S-135", "S135", "s 135", "(S-135)"] {
            assert_eq!(yield_psi(grade), Some(135_000.0), "{grade}");
        }
        assert_eq!(yield_psi("4145H"), None);
        // Grades of API Spec 5CT: the number is the minimum yield strength in ksi.
        for (grade, ksi) in [
            ("H-40", 40.0),
            ("J55", 55.0),
            ("K-55", 55.0),
            ("N-80", 80.0),
            ("L-80", 80.0),
            ("C-90", 90.0),
            ("T-95", 95.0),
            ("P-110", 110.0),
            ("q 125", 125.0),
            ("N80 Type 1", 80.0),
            ("N-80Q", 80.0),
            ("L80-13Cr", 80.0),
            ("13Cr-95", 95.0),
            ("Grade S135", 135.0),
            ("E", 75.0),
            ("G", 105.0),
            ("X", 95.0),
        ] {
            assert_eq!(yield_psi(grade), Some(ksi * 1000.0), "{grade}");
        }
        assert_eq!(grade_in_name("DP 5 1/2in 21.90# S-135 HT55"), Some("S-135"));
        assert_eq!(grade_in_name("Jar 6 1/2"), None);
    }
}
