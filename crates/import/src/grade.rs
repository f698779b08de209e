//! Grades of steel.

use wholestring::well::casing;

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
        text.chars().filter(|c| c.is_alphanumeric()).take(8).collect::<String>().to_uppercase()
    };
    let name = plain(grade);
    let pipe = GRADES.iter().find(|(grade, _)| *grade == name).map(|(_, psi)| *psi);
    pipe.or_else(|| {
        let mut grades = casing::grades().filter(|grade| !grade.name.is_empty());
        let casing = grades.find(|grade| plain(grade.name) == name)?;
        Some((casing.yield_strength_Pa / PSI_PA).round())
    })
}

/// The grade that a pipe name contains as a word: `DP 5 in S-135`.
pub(crate) fn in_name(name: &str) -> Option<&str> {
    let words = name.split([' ', ',', '(', ')', '/', ';']);
    words.into_iter().find(|word| word.len() > 2 && yield_psi(word).is_some())
}

#[cfg(test)]
mod tests {
    use super::{in_name, yield_psi};

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
        ] {
            assert_eq!(yield_psi(grade), Some(ksi * 1000.0), "{grade}");
        }
        assert_eq!(in_name("DP 5 1/2in 21.90# S-135 HT55"), Some("S-135"));
        assert_eq!(in_name("Jar 6 1/2"), None);
    }
}
