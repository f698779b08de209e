//! Dimensions of the keys of the settings.

use wholestring_case::dimension_of;
use wholestring_units::Dimension;

/// Dimension of a key of the settings on the page, and its name without the unit; `None` for a bare
/// number.
pub(crate) fn of_setting(key: &str) -> Option<(&'static str, &str)> {
    if let Some(name) = key.strip_suffix("_J_per_m3") {
        return Some(("work per volume", name));
    }
    let (dimension, name) = dimension_of(key)?;
    Some(match dimension {
        // In GPa, unlike other stresses.
        Dimension::Stress if name.ends_with("modulus") => ("modulus", name),
        other => (other.name(), name),
    })
}

#[cfg(test)]
mod tests {
    use wholestring_report::display_units;

    use super::*;

    #[test]
    fn keys_of_the_settings_have_their_dimension() {
        for (key, expected) in [
            ("bit_depth_m", "length"),
            ("od_m", "diameter"),
            ("diameter_m", "diameter"),
            ("gauge_relief_m", "diameter"),
            ("mass_per_length_kg_per_m", "mass per length"),
            ("youngs_modulus_Pa", "modulus"),
            ("yield_strength_Pa", "stress"),
            ("largest_von_mises_stress_Pa", "stress"),
            ("pump_pressure_limit_Pa", "pressure"),
            ("pump_pressure_Pa", "pressure"),
            ("rock_stiffness_N_per_m", "stiffness"),
            ("top_drive_torque_N_m", "torque"),
            ("rotary_speed_rad_per_s", "rotary speed"),
            ("gain_m_per_s_per_N", "hoist gain"),
            ("rop_m_per_s", "rate of penetration"),
            ("settle_s", "time"),
        ] {
            let found = of_setting(key).map(|(dimension, _)| dimension);
            assert_eq!(found, Some(expected), "{key}");
            assert!(display_units().contains_key(expected), "{expected}");
        }
        assert_eq!(of_setting("seed"), None);
    }
}
