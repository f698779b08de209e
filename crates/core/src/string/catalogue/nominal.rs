//! Nominal weights of drill pipe: names of a wall, without tool joints.

use super::{CatalogueEntry, TubularKind, entries, entry::POUND_PER_FOOT_KG_PER_M};
use crate::string::Material;

/// Diameters this close are those of one pipe, m.
const SAME_DIAMETER_M: f64 = 3e-4;

/// A weight within this part of the nominal one is that: engineers write 19.4 or 29 kg/m for
/// 19.50 lb/ft. Tool joints add a multiple of it.
const ROUNDED: f64 = 0.01;

/// Rounding of light pipe, lb/ft.
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

    /// Whether a mass per length, kg/m, is the nominal one of this drill pipe, rounded or not, and
    /// can be distinguished from its weight with tool joints.
    pub fn is_nominal_mass(&self, mass_kg_per_m: f64) -> bool {
        let Some(nominal) = self.nominal_mass_kg_per_m() else { return false };
        let with_joints = self.mass_per_length_kg_per_m(Material::STEEL.density_kg_per_m3);
        let rounded = (ROUNDED * nominal).max(SAME_LB_PER_FT * POUND_PER_FOOT_KG_PER_M);
        (mass_kg_per_m - nominal).abs() <= rounded
            && with_joints > (1.0 + ALIKE) * nominal
            && mass_kg_per_m < 0.5 * (nominal + with_joints)
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
    let is_nominal = |pipe: &CatalogueEntry| pipe.is_nominal_mass(mass_kg_per_m);
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
        // Rounded, in pounds and in kilograms.
        for mass in [19.4 * POUND_PER_FOOT_KG_PER_M, 19.6 * POUND_PER_FOOT_KG_PER_M, 29.0] {
            assert_eq!(nominal_pipe(Some(&entry), 0.0, 0.0, mass), Some(entry.clone()), "{mass}");
        }
        // The weight of the body alone, and any with tool joints.
        for pounds in [17.93, 19.2, 19.8, 20.9, 21.4] {
            let mass = pounds * POUND_PER_FOOT_KG_PER_M;
            assert_eq!(nominal_pipe(Some(&entry), 0.0, 0.0, mass), None, "{pounds}");
        }
        let found = nominal_pipe(None, 0.127, 0.108_610, nominal).expect("the same pipe");
        assert!(found.designation.starts_with("5 in 19.50 lb/ft"), "{}", found.designation);
        assert_eq!(nominal_pipe(None, 0.127, 0.070, nominal), None);
        // The weight of heavy-weight pipe counts its joints.
        let heavy = find("HWDP 5 in 49.3 lb/ft").expect("an entry");
        assert_eq!(heavy.nominal_mass_kg_per_m(), None);
    }

    /// The weight with tool joints of no pipe in the catalogue is taken for a nominal one of pipe
    /// of its diameters.
    #[test]
    fn no_weight_with_tool_joints_is_nominal() {
        let steel = Material::STEEL.density_kg_per_m3;
        for pipe in entries().iter().filter(|pipe| pipe.kind == TubularKind::DrillPipe) {
            let mass = pipe.mass_per_length_kg_per_m(steel);
            for (entry, name) in [(Some(pipe), "its entry"), (None, "its diameters")] {
                let found = nominal_pipe(entry, pipe.od_m, pipe.id_m, mass);
                assert_eq!(found, None, "{} by {name}", pipe.designation);
            }
        }
    }
}
