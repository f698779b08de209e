//! Casings that go into each other.

/// Casing from this diameter on, m: 7 in.
const CASING_M: f64 = 0.1778;

/// A bore of this part of the outside diameter and more is casing's, not a collar's.
const THIN: f64 = 0.8;

/// A casing that goes into another has less than this part of its bore: two sizes of one combined string have more.
const GOES_IN: f64 = 0.8;

/// Whether of these tubulars, outside and inside diameters, m, one is casing that goes into another: a casing programme, which
/// is no string.
pub fn nested_casings(diameters_m: &[(f64, f64)]) -> bool {
    let casings: Vec<(f64, f64)> = diameters_m
        .iter()
        .copied()
        .filter(|&(od_m, id_m)| od_m >= CASING_M - 1e-6 && id_m > THIN * od_m)
        .collect();
    casings.iter().any(|&(od_m, _)| casings.iter().any(|&(_, id_m)| od_m < GOES_IN * id_m))
}

#[cfg(test)]
mod tests {
    use super::nested_casings;

    const INCH_M: f64 = 0.0254;

    fn inches(diameters: &[(f64, f64)]) -> bool {
        let metres: Vec<(f64, f64)> =
            diameters.iter().map(|(od, id)| (od * INCH_M, id * INCH_M)).collect();
        nested_casings(&metres)
    }

    #[test]
    fn a_casing_programme_is_told_from_a_string() {
        assert!(inches(&[(9.625, 8.681), (13.375, 12.347), (20.0, 18.73)]));
        assert!(inches(&[(9.625, 8.681), (13.375, 12.347)]));
        // One size, a tapered string of two sizes, a liner on drill pipe, pipe and collars.
        assert!(!inches(&[(13.375, 12.347), (13.375, 12.415)]));
        assert!(!inches(&[(9.625, 8.681), (10.75, 9.85)]));
        assert!(!inches(&[(7.0, 6.184), (5.5, 4.67)]));
        assert!(!inches(&[(8.5, 2.0), (8.0, 2.8125), (5.0, 4.276)]));
    }
}
