//! Casing by its size, weight and grade, as API Spec 5CT lists it.
//!
//! Only dimensions are stored, as facts with the standard that they come from: casing is named by
//! its outside diameter, while the string moves in the inside one.

use crate::string::catalogue::parts::{Part, parts};

const INCH_M: f64 = 0.0254;
const PSI_PA: f64 = 6894.757293168361;
const POUND_PER_FOOT_KG_PER_M: f64 = 0.453_592_37 / 0.3048;

/// Source of the dimensions.
pub const SOURCE: &str =
    "API Spec 5CT (outside diameter, nominal weight, wall, drift mandrel, grades)";

/// Grades and their minimum yield strength, psi: of API Spec 5CT, the old C-95, and two makers'
/// grades of high collapse resistance, which yield as L-80 and P-110.
const GRADES: [(&str, f64); 15] = [
    ("H-40", 40e3),
    ("J-55", 55e3),
    ("K-55", 55e3),
    ("M-65", 65e3),
    ("N-80", 80e3),
    ("L-80", 80e3),
    ("HCL-80", 80e3),
    ("C-90", 90e3),
    ("R-95", 95e3),
    ("T-95", 95e3),
    ("C-95", 95e3),
    ("C-110", 110e3),
    ("P-110", 110e3),
    ("HCP-110", 110e3),
    ("Q-125", 125e3),
];

/// Two outside diameters closer than this are the same, in: "9.63 in" is 9-5/8 in.
const DIAMETER_TOLERANCE_IN: f64 = 0.006;
/// Two nominal weights closer than this are the same, lb/ft; those of one size differ by 1 or more.
const WEIGHT_TOLERANCE_LB_PER_FT: f64 = 0.3;
/// Number of entries that an error lists.
const NEAREST: usize = 4;

/// A size of casing, and its nominal weights in lb/ft with their walls in inches.
struct Size {
    name: &'static str,
    od_in: f64,
    weights: &'static [(f64, f64)],
}

#[rustfmt::skip]
const SIZES: [Size; 15] = [
    Size { name: "4-1/2", od_in: 4.5, weights: &[
        (9.5, 0.205), (10.5, 0.224), (11.6, 0.250), (13.5, 0.290), (15.1, 0.337)] },
    Size { name: "5", od_in: 5.0, weights: &[
        (11.5, 0.220), (13.0, 0.253), (15.0, 0.296), (18.0, 0.362), (21.4, 0.437), (23.2, 0.478),
        (24.1, 0.500)] },
    Size { name: "5-1/2", od_in: 5.5, weights: &[
        (14.0, 0.244), (15.5, 0.275), (17.0, 0.304), (20.0, 0.361), (23.0, 0.415)] },
    Size { name: "6-5/8", od_in: 6.625, weights: &[
        (20.0, 0.288), (24.0, 0.352), (28.0, 0.417), (32.0, 0.475)] },
    Size { name: "7", od_in: 7.0, weights: &[
        (17.0, 0.231), (20.0, 0.272), (23.0, 0.317), (26.0, 0.362), (29.0, 0.408), (32.0, 0.453),
        (35.0, 0.498), (38.0, 0.540)] },
    Size { name: "7-5/8", od_in: 7.625, weights: &[
        (24.0, 0.300), (26.4, 0.328), (29.7, 0.375), (33.7, 0.430), (39.0, 0.500), (42.8, 0.562),
        (45.3, 0.595), (47.1, 0.625)] },
    Size { name: "8-5/8", od_in: 8.625, weights: &[
        (24.0, 0.264), (28.0, 0.304), (32.0, 0.352), (36.0, 0.400), (40.0, 0.450), (44.0, 0.500),
        (49.0, 0.557)] },
    Size { name: "9-5/8", od_in: 9.625, weights: &[
        (32.3, 0.312), (36.0, 0.352), (40.0, 0.395), (43.5, 0.435), (47.0, 0.472), (53.5, 0.545),
        (58.4, 0.595)] },
    Size { name: "9-7/8", od_in: 9.875, weights: &[(62.8, 0.625)] },
    Size { name: "10-3/4", od_in: 10.75, weights: &[
        (32.75, 0.279), (40.5, 0.350), (45.5, 0.400), (51.0, 0.450), (55.5, 0.495), (60.7, 0.545),
        (65.7, 0.595)] },
    Size { name: "11-3/4", od_in: 11.75, weights: &[
        (42.0, 0.333), (47.0, 0.375), (54.0, 0.435), (60.0, 0.489), (65.0, 0.534), (71.0, 0.582)] },
    Size { name: "13-3/8", od_in: 13.375, weights: &[
        (48.0, 0.330), (54.5, 0.380), (61.0, 0.430), (68.0, 0.480), (72.0, 0.514)] },
    Size { name: "16", od_in: 16.0, weights: &[
        (65.0, 0.375), (75.0, 0.438), (84.0, 0.495), (109.0, 0.656)] },
    Size { name: "18-5/8", od_in: 18.625, weights: &[(87.5, 0.435)] },
    Size { name: "20", od_in: 20.0, weights: &[(94.0, 0.438), (106.5, 0.500), (133.0, 0.635)] },
];

/// Steel grade of casing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CasingGrade {
    /// Name: `L-80`; empty where the casing's own name includes it.
    pub name: &'static str,
    /// Minimum yield strength, Pa.
    pub yield_strength_Pa: f64,
}

/// Every grade, the weakest first.
pub fn grades() -> impl Iterator<Item = CasingGrade> {
    GRADES.iter().map(|&(name, psi)| CasingGrade { name, yield_strength_Pa: psi * PSI_PA })
}

/// The grade of those letters and that number, `l` and 80.
fn grade(letters: &str, number: f64) -> Option<CasingGrade> {
    grades().find(|grade| {
        grade.name.split_once('-').is_some_and(|(own, yields)| {
            own.eq_ignore_ascii_case(letters) && yields.parse() == Ok(number)
        })
    })
}

/// Casing of one size and weight.
#[derive(Debug, Clone, PartialEq)]
pub struct Casing {
    /// Name: `9-5/8 in 40.0 lb/ft`.
    pub designation: String,
    /// Outside diameter of the pipe, m.
    pub od_m: f64,
    /// Inside diameter, m: the outside one less two walls.
    pub id_m: f64,
    /// Diameter of the mandrel that passes every joint, m.
    pub drift_m: f64,
    /// Nominal mass per length with thread and coupling, kg/m.
    pub mass_per_length_kg_per_m: f64,
    /// Grade, where the designation includes it.
    pub grade: Option<CasingGrade>,
}

/// Why a designation names no casing.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("there is no casing `{designation}`; the nearest are {}", .nearest.join(", "))]
pub struct UnknownCasing {
    /// The requested designation.
    pub designation: String,
    /// Designations of the nearest entries, the nearest first.
    pub nearest: Vec<String>,
}

/// Difference between the inside diameter and the drift mandrel, in: 1/8 below a size of 9-5/8,
/// 5/32 up to 13-3/8, 3/16 above (API Spec 5CT).
fn drift_allowance_in(od_in: f64) -> f64 {
    if od_in < 9.625 {
        1.0 / 8.0
    } else if od_in <= 13.375 {
        5.0 / 32.0
    } else {
        3.0 / 16.0
    }
}

/// Diameter of the mandrel that API Spec 5CT passes through casing of these diameters, m; of hardly
/// any bore none is less than nothing.
pub fn drift_m(od_m: f64, id_m: f64) -> f64 {
    (id_m - drift_allowance_in(od_m / INCH_M) * INCH_M).max(0.0)
}

fn casing(size: &Size, weight_lb_per_ft: f64, wall_in: f64) -> Casing {
    let id_in = size.od_in - 2.0 * wall_in;
    // 32.75 lb/ft is the only weight of two decimals.
    let decimals = if (weight_lb_per_ft * 10.0).fract() == 0.0 { 1 } else { 2 };
    Casing {
        designation: format!("{} in {weight_lb_per_ft:.decimals$} lb/ft", size.name),
        od_m: size.od_in * INCH_M,
        id_m: id_in * INCH_M,
        drift_m: drift_m(size.od_in * INCH_M, id_in * INCH_M),
        mass_per_length_kg_per_m: weight_lb_per_ft * POUND_PER_FOOT_KG_PER_M,
        grade: None,
    }
}

/// All casing, by size and weight, without a grade.
pub fn entries() -> Vec<Casing> {
    let of_size = |size: &'static Size| {
        let weights = size.weights.iter();
        weights.map(|&(weight, wall)| casing(size, weight, wall))
    };
    SIZES.iter().flat_map(of_size).collect()
}

/// The casing of this outside diameter, by weight; none where it is no size of casing.
pub fn of_outside_diameter(od_m: f64) -> Vec<Casing> {
    let mut entries = entries();
    entries.retain(|casing| (casing.od_m - od_m).abs() < DIAMETER_TOLERANCE_IN * INCH_M);
    entries
}

/// The casing of a designation.
///
/// Accepted are `9-5/8 in 40 lb/ft` and the usual other spellings, a grade and a connection among
/// them: `9 5/8" 47# L-80 casing`, `13.375 in 68 ppf K55 BTC`. The grade is kept in addition to the
/// designation.
///
/// ```
/// use wholestring::well::casing;
///
/// let pipe = casing::find("9 5/8\" 40# N-80")?;
/// assert_eq!(pipe.designation, "9-5/8 in 40.0 lb/ft");
/// assert!((pipe.id_m / 0.0254 - 8.835).abs() < 1e-9);
/// assert_eq!(pipe.grade.map(|grade| grade.name), Some("N-80"));
///
/// let error = casing::find("9-5/8 in 41 lb/ft").unwrap_err();
/// assert_eq!(error.nearest[0], "9-5/8 in 40.0 lb/ft");
/// # Ok::<(), casing::UnknownCasing>(())
/// ```
///
/// # Errors
/// Where no entry has this size and weight, with the nearest entries.
pub fn find(designation: &str) -> Result<Casing, UnknownCasing> {
    let mut entries = entries();
    // Text longer than any spelling of a tubular is not read.
    let requested = (designation.len() <= 120).then(|| Reading::of(designation)).flatten();
    let distance = |casing: &Casing| -> (f64, f64) {
        let Some(Reading { od_in, weight, .. }) = requested else {
            return (0.0, 0.0);
        };
        let own = casing.mass_per_length_kg_per_m / POUND_PER_FOOT_KG_PER_M;
        let apart = weight.map_or(f64::INFINITY, |weight: f64| (own - weight).abs());
        ((casing.od_m / INCH_M - od_in).abs(), apart)
    };
    let same = |casing: &Casing| {
        let (size, weight) = distance(casing);
        requested.is_some() && size < DIAMETER_TOLERANCE_IN && weight < WEIGHT_TOLERANCE_LB_PER_FT
    };
    if let Some(found) = entries.iter().find(|casing| same(casing)) {
        let grade = requested.and_then(|requested| requested.grade);
        return Ok(Casing { grade, ..found.clone() });
    }
    if requested.is_some() {
        entries.sort_by(|a, b| {
            let (a, b) = (distance(a), distance(b));
            a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
        });
    } else {
        // The sizes that are run most.
        let common = ["9-5/8 in", "13-3/8 in", "7 in"];
        entries.sort_by_key(|casing| {
            let place = common.iter().position(|size| casing.designation.starts_with(size));
            place.unwrap_or(common.len())
        });
    }
    Err(UnknownCasing {
        designation: designation.to_owned(),
        nearest: entries.into_iter().take(NEAREST).map(|casing| casing.designation).collect(),
    })
}

/// Parts of a designation.
#[derive(Clone, Copy)]
struct Reading {
    od_in: f64,
    /// lb/ft.
    weight: Option<f64>,
    grade: Option<CasingGrade>,
}

impl Reading {
    /// `None` where a word is not understood.
    fn of(designation: &str) -> Option<Self> {
        let mut numbers = Vec::new();
        let mut found = None;
        let mut parts = parts(designation).into_iter().peekable();
        while let Some(part) = parts.next() {
            match part {
                Part::Number(number) => numbers.push(number),
                Part::Word(word) => match word.as_str() {
                    "in" | "inch" | "inches" | "od" | "lb" | "lbs" | "lbm" | "ft" | "ppf"
                    | "per" | "casing" | "csg" | "liner" | "lnr" | "grade" | "btc" | "ltc"
                    | "stc" | "lc" | "sc" | "bc" => {}
                    letters => match parts.next() {
                        Some(Part::Number(number)) if found.is_none() => {
                            found = Some(grade(letters, number)?);
                        }
                        _ => return None,
                    },
                },
            }
        }
        match numbers[..] {
            [od_in] => Some(Self { od_in, weight: None, grade: found }),
            [od_in, weight] => Some(Self { od_in, weight: Some(weight), grade: found }),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The plain end of steel weighs `10.69 (D - t) t` lb/ft (API Bulletin 5C3); thread and
    /// coupling add to it. All entries are 0 to 4.9 % above it. A misprint of 0.02 in in a wall
    /// moves it by 4 to 9 %.
    #[test]
    fn walls_weigh_what_their_names_say() {
        for casing in entries() {
            let (od_in, id_in) = (casing.od_m / INCH_M, casing.id_m / INCH_M);
            let wall_in = (od_in - id_in) / 2.0;
            let plain_end = 10.69 * (od_in - wall_in) * wall_in;
            let nominal = casing.mass_per_length_kg_per_m / POUND_PER_FOOT_KG_PER_M;
            let more = nominal / plain_end - 1.0;
            assert!((0.0..0.05).contains(&more), "{}: {plain_end}", casing.designation);
        }
    }

    /// Inside and drift diameters that API Spec 5CT prints, in; it rounds them to 0.001.
    #[test]
    fn inside_and_drift_diameters_are_the_standards() {
        for (name, id_in, drift_in) in [
            ("4-1/2 in 11.6 lb/ft", 4.000, 3.875),
            ("5 in 18.0 lb/ft", 4.276, 4.151),
            ("5-1/2 in 17.0 lb/ft", 4.892, 4.767),
            ("6-5/8 in 24.0 lb/ft", 5.921, 5.796),
            ("7 in 29.0 lb/ft", 6.184, 6.059),
            ("7-5/8 in 29.7 lb/ft", 6.875, 6.750),
            ("8-5/8 in 32.0 lb/ft", 7.921, 7.796),
            ("9-5/8 in 40.0 lb/ft", 8.835, 8.679),
            ("9-5/8 in 47.0 lb/ft", 8.681, 8.525),
            ("10-3/4 in 45.5 lb/ft", 9.950, 9.794),
            ("11-3/4 in 60.0 lb/ft", 10.772, 10.616),
            ("13-3/8 in 68.0 lb/ft", 12.415, 12.259),
            ("16 in 75.0 lb/ft", 15.124, 14.936),
            ("18-5/8 in 87.5 lb/ft", 17.755, 17.567),
            ("20 in 94.0 lb/ft", 19.124, 18.936),
        ] {
            let casing = find(name).expect(name);
            assert_eq!(casing.designation, name);
            assert!((casing.id_m / INCH_M - id_in).abs() < 6e-4, "{name}");
            assert!((casing.drift_m / INCH_M - drift_in).abs() < 6e-4, "{name}");
        }
    }

    #[test]
    fn every_entry_is_found_by_its_own_name_and_by_no_other() {
        for casing in entries() {
            assert_eq!(find(&casing.designation).as_ref(), Ok(&casing));
            assert!(of_outside_diameter(casing.od_m).contains(&casing));
        }
    }

    #[test]
    fn usual_spellings_are_understood() {
        for spelling in [
            "9-5/8 in 40 lb/ft",
            "9 5/8\" 40# L-80",
            "9.625 in 40 ppf K55 BTC casing",
            "csg 9-5/8 40 lbs/ft N80",
        ] {
            let found = find(spelling).map(|casing| casing.designation);
            assert_eq!(found.as_deref(), Ok("9-5/8 in 40.0 lb/ft"), "{spelling}");
        }
    }

    /// The grades are named by their yields.
    #[test]
    fn grades_are_kept() {
        for grade in grades() {
            let name = format!("9-5/8 in 40 lb/ft {}", grade.name);
            assert_eq!(find(&name).map(|casing| casing.grade), Ok(Some(grade)), "{name}");
            let ksi: f64 = grade.name.split_once('-').expect("named so").1.parse().expect("ksi");
            assert!((grade.yield_strength_Pa / PSI_PA / 1e3 - ksi).abs() < 1e-9, "{}", grade.name);
        }
        assert_eq!(find("9-5/8 in 40 lb/ft").expect("casing").grade, None);
        assert!(find("9-5/8 in 40 lb/ft L-85").is_err());
        assert!(find("9-5/8 in 40 lb/ft L-80 N-80").is_err());
    }

    #[test]
    fn unknown_ones_name_the_nearest() {
        let nearest = |designation: &str| find(designation).expect_err(designation).nearest;
        assert_eq!(nearest("9-5/8 in")[0], "9-5/8 in 32.3 lb/ft");
        assert_eq!(nearest("13-3/8 in 70 lb/ft")[0], "13-3/8 in 68.0 lb/ft");
        for nonsense in ["", "casing", "9-5/8", "5 5 5", "nine", "½", "1e400 in"] {
            assert_eq!(nearest(nonsense).len(), NEAREST, "{nonsense}");
        }
        assert_eq!(nearest(&"5 ".repeat(100_000)).len(), NEAREST);
    }
}
