//! Fatigue damage of rotation, place by place.

use std::f64::consts::TAU;

use wholestring::{
    model::Model,
    operation::Operation,
    outcome::{Profile, Solution},
    string::Component,
};

use super::{
    EnduranceCurve, SnCurve, equivalent_amplitude_Pa, minimum_tensile_strength_Pa,
    permissible_dogleg_rad_per_m,
};

/// Settings of the fatigue model.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize)]
pub struct FatigueSettings {
    /// Cycles to failure.
    pub sn_curve: SnCurve,
    /// Tensile strength, Pa, of all pipe; `None` for that of its grade
    /// ([`minimum_tensile_strength_Pa`]).
    pub tensile_strength_Pa: Option<f64>,
}

impl FatigueSettings {
    /// Returns the tensile strength of a component, Pa; `None` where its yield strength is not
    /// known either.
    pub fn tensile_strength_of_Pa(&self, component: &Component) -> Option<f64> {
        let of_grade = || component.yield_strength_Pa.map(minimum_tensile_strength_Pa);
        self.tensile_strength_Pa.or_else(of_grade)
    }

    /// Returns the alternating stress and its damage at a row of a profile, of a component with
    /// this tensile strength, Pa.
    pub(super) fn cost(
        &self,
        component: &Component,
        tensile_strength_Pa: f64,
        profile: &Profile,
        row: usize,
    ) -> Cost {
        let bending_Pa = profile.bending_stress_Pa[row];
        let mean_Pa = profile.tension_N[row] / component.area_m2();
        let equivalent_Pa = equivalent_amplitude_Pa(bending_Pa, mean_Pa, tensile_strength_Pa);
        Cost { bending_Pa, mean_Pa, equivalent_Pa, cycles: self.sn_curve.cycles(equivalent_Pa) }
    }
}

/// Damage of a revolution.
pub(super) struct Cost {
    bending_Pa: f64,
    mean_Pa: f64,
    equivalent_Pa: f64,
    pub(super) cycles: f64,
}

/// Fatigue of a place along the string.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct FatigueRow {
    /// Measured depth, m.
    pub md_m: f64,
    /// Component, counted from the bit.
    pub component: usize,
    /// Amplitude of the bending stress at the outer surface, Pa.
    pub bending_Pa: f64,
    /// Mean stress of the effective tension, Pa.
    pub mean_Pa: f64,
    /// Amplitude with the same damage without a mean stress, Pa (Goodman).
    pub equivalent_Pa: f64,
    /// Revolutions to failure; infinite without damage.
    pub revolutions_to_failure: f64,
    /// Part of its life that an hour of this operation uses; zero for a string that does not turn.
    pub damage_per_hour: f64,
    /// Dogleg severity of the hole, rad/m.
    pub dogleg_rad_per_m: f64,
    /// Permissible dogleg severity under that tension, rad/m; `None` where the yield strength is
    /// not known.
    pub permissible_dogleg_rad_per_m: Option<f64>,
}

/// Returns the fatigue along the string, a row for each of the profile whose component's tensile
/// strength is known, without those of the bit.
pub fn rows(
    model: &Model,
    operation: &Operation,
    solution: &Solution<'_>,
    settings: &FatigueSettings,
) -> Vec<FatigueRow> {
    let profile = solution.profile;
    let revolutions_per_hour = operation.rotation_rad_per_s() * 3600.0 / TAU;
    let row = |(row, md_m): (usize, &f64)| {
        let (index, component) = model.string.component_at(operation.bit_depth_m - md_m);
        if component.is_bit() {
            return None;
        }
        let tensile_Pa = settings.tensile_strength_of_Pa(component)?;
        let cost = settings.cost(component, tensile_Pa, profile, row);
        let permissible = component.yield_strength_Pa.map(|yield_Pa| {
            let curve = EnduranceCurve::of(yield_Pa);
            permissible_dogleg_rad_per_m(component, profile.tension_N[row], curve)
        });
        Some(FatigueRow {
            md_m: *md_m,
            component: index,
            bending_Pa: cost.bending_Pa,
            mean_Pa: cost.mean_Pa,
            equivalent_Pa: cost.equivalent_Pa,
            revolutions_to_failure: cost.cycles,
            damage_per_hour: revolutions_per_hour / cost.cycles,
            dogleg_rad_per_m: model.well.path.dogleg_severity_rad_per_m(*md_m),
            permissible_dogleg_rad_per_m: permissible,
        })
    };
    profile.md_m.iter().enumerate().filter_map(row).collect()
}
