//! Nominal weights of drill pipe: names of a wall, without tool joints.

use super::{CatalogueEntry, TubularKind, entries, inches::POUND_PER_FOOT_KG_PER_M};
use crate::string::Material;

/// Diameters this close are those of one pipe, m; weights this close are one, lb/ft.
const SAME_DIAMETER_M: f64 = 3e-4;
const SAME_LB_PER_FT: f64 = 0.06;

/// A nominal weight that is this near to the weight with tool joints is not distinguished from it.
const ALIKE: f64 = 0.02;

impl CatalogueEntry {
    /// Nominal mass per length of drill pipe, kg/m, which its designation has and which leaves tool joints out; `None` of
    /// other tubulars, and where the designation has none.
    pub fn nominal_mass_kg_per_m(&self) -> Option<f64> {
        if self.kind != TubularKind::DrillPipe {
            return None;
        }
        let (before, _) = self.designation.split_once(" lb/ft")?;
        let pounds: f64 = before.rsplit_once(' ')?.1.parse().ok()?;
        Some(pounds * POUND_PER_FOOT_KG_PER_M)
    }
}

/// The pipe of which a mass per length, kg/m, is the nominal one, where that differs from its
/// weight with tool joints: a known entry, or else drill pipe of these diameters, m.
pub fn nominal_pipe(
    entry: Option<&CatalogueEntry>,
    od_m: f64,
    id_m: f64,
    mass_kg_per_m: f64,
) -> Option<CatalogueEntry> {
    let is_nominal = |pipe: &CatalogueEntry| {
        let steel = Material::STEEL.density_kg_per_m3;
        pipe.nominal_mass_kg_per_m().is_some_and(|nominal| {
            (nominal - mass_kg_per_m).abs() < SAME_LB_PER_FT * POUND_PER_FOOT_KG_PER_M
                && pipe.mass_per_length_kg_per_m(steel) > (1.0 + ALIKE) * nominal
        })
    };
    if let Some(entry) = entry {
        return Some(entry.clone()).filter(is_nominal);
    }
    let same = |pipe: &CatalogueEntry| {
        (pipe.od_m - od_m).abs() < SAME_DIAMETER_M && (pipe.id_m - id_m).abs() < SAME_DIAMETER_M
    };
    entries().into_iter().find(|pipe| same(pipe) && is_nominal(pipe))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::string::catalogue::find;

    /// Names of pipe hold their nominal weights; with tool joints 5 in 19.50 lb/ft weighs 21.9 to 22.6 lb/ft (API RP 7G).
    #[test]
    fn a_nominal_weight_is_told_from_the_weight() {
        let entry = find("5 in 19.50 lb/ft S-135").expect("an entry");
        let nominal = 19.5 * POUND_PER_FOOT_KG_PER_M;
        assert_eq!(nominal_pipe(Some(&entry), 0.0, 0.0, nominal), Some(entry.clone()));
        assert_eq!(nominal_pipe(Some(&entry), 0.0, 0.0, 22.0 * POUND_PER_FOOT_KG_PER_M), None);
        let found = nominal_pipe(None, 0.127, 0.108_610, nominal).expect("the same pipe");
        assert!(found.designation.starts_with("5 in 19.50 lb/ft"), "{}", found.designation);
        assert_eq!(nominal_pipe(None, 0.127, 0.070, nominal), None);
        // The weight of heavy-weight pipe counts its joints.
        let heavy = find("HWDP 5 in 49.3 lb/ft").expect("an entry");
        assert_eq!(heavy.nominal_mass_kg_per_m(), None);
    }
}
