//! Coiled tubing: common sizes, walls and grades.

use super::{
    CatalogueEntry, PipeClass, TubularKind,
    entry::{INCH_M, PSI_PA},
};

const SOURCE: &str = "API Spec 5ST (CT-70 to CT-110); CT-120 and CT-130 are makers' grades; \
                      walls are common ones, nominal";

/// Minimum yield strengths, ksi, which name the grades.
const GRADES_KSI: [f64; 7] = [70.0, 80.0, 90.0, 100.0, 110.0, 120.0, 130.0];

/// Outside diameter and walls, in.
const SIZES: [(&str, f64, &[&str]); 9] = [
    ("1", 1.0, &["0.087", "0.109"]),
    ("1-1/4", 1.25, &["0.109", "0.125"]),
    ("1-1/2", 1.5, &["0.109", "0.125", "0.156"]),
    ("1-3/4", 1.75, &["0.125", "0.156", "0.188"]),
    ("2", 2.0, &["0.125", "0.156", "0.190", "0.204"]),
    ("2-3/8", 2.375, &["0.156", "0.190", "0.204"]),
    ("2-5/8", 2.625, &["0.190", "0.204", "0.224"]),
    ("2-7/8", 2.875, &["0.190", "0.204", "0.224"]),
    ("3-1/2", 3.5, &["0.190", "0.204", "0.250"]),
];

/// Name in a reading of the grade of a yield strength in ksi; `None` where there is no such grade.
pub(super) fn grade(ksi: f64) -> Option<String> {
    GRADES_KSI.contains(&ksi).then(|| format!("ct{ksi}"))
}

pub(super) fn entries() -> Vec<CatalogueEntry> {
    let mut entries = Vec::new();
    for (size, od_in, walls) in SIZES {
        for name in walls {
            let Ok(wall_in) = name.parse::<f64>() else { continue };
            entries.extend(GRADES_KSI.iter().map(|ksi| CatalogueEntry {
                designation: format!("CT {size} in x {name} in CT-{ksi}"),
                kind: TubularKind::CoiledTubing,
                class: PipeClass::New,
                od_m: od_in * INCH_M,
                id_m: (od_in - 2.0 * wall_in) * INCH_M,
                joints: None,
                connection: None,
                given_mass_kg_per_m: None,
                yield_strength_Pa: ksi * 1e3 * PSI_PA,
                source: SOURCE.into(),
            }));
        }
    }
    entries
}
