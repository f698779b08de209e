//! The string along the hole at one depth of the bit, in stations of a standard spacing.

use wholestring::{
    operation::{Operation, OperationKind},
    outcome::Buckling,
    statics::soft::{self, SoftProfile},
};
use wholestring_judge::NoAnswer;

use super::Broomstick;
use crate::FrictionLevel;

/// The string at a measured depth, by the soft string.
#[derive(Debug, Clone, PartialEq)]
pub struct StringStation {
    /// The operation.
    pub operation: OperationKind,
    /// Measured depth, m.
    pub md_m: f64,
    /// True vertical depth, m.
    pub tvd_m: f64,
    /// Inclination of the hole, rad.
    pub inclination_rad: f64,
    /// Dogleg severity of the hole, rad/m.
    pub dogleg_severity_rad_per_m: f64,
    /// Name of the component.
    pub component: String,
    /// Effective tension, N; negative in compression.
    pub tension_N: f64,
    /// Torque that the string carries, N·m.
    pub torque_N_m: f64,
    /// Side force per length, N/m; positive where the string lies on the high side.
    pub side_force_N_per_m: f64,
    /// Von Mises stress, Pa.
    pub von_mises_stress_Pa: f64,
    /// That stress over the minimum yield strength; `None` where the strength is not known.
    pub yield_use: Option<f64>,
    /// Buckling by the compression there.
    pub buckling: Buckling,
}

impl Broomstick {
    /// Returns the string of an operation with the expected friction at every multiple of
    /// `spacing_m` from the surface to the bit, and at the bit. Values between the nodes of the
    /// soft string are in proportion; the component and the buckling are those of the next node
    /// down.
    ///
    /// # Errors
    /// The reason why there is no answer.
    pub fn along(
        &self,
        operation: &Operation,
        spacing_m: f64,
    ) -> Result<Vec<StringStation>, NoAnswer> {
        let bit_depth_m = operation.bit_depth_m;
        let model = self.setup(FrictionLevel::Expected).at(bit_depth_m)?;
        let solved = soft::solve(&model, operation, &self.soft)?;
        let multiples = (0..).map(|index| f64::from(index) * spacing_m);
        let depths = multiples.take_while(|md_m| *md_m < bit_depth_m).chain([bit_depth_m]);
        let station = |md_m: f64| {
            let place = model.well.path.at(md_m);
            let (row, share) = between(&solved.md_m, md_m);
            let at = |column: &[f64]| match row.checked_sub(1) {
                Some(above) => column[above] + share * (column[row] - column[above]),
                None => column[row],
            };
            let (_, component) = model.string.component_at(bit_depth_m - md_m);
            StringStation {
                operation: operation.kind,
                md_m,
                tvd_m: place.position_m.z,
                inclination_rad: place.inclination_rad(),
                dogleg_severity_rad_per_m: model.well.path.dogleg_severity_rad_per_m(md_m),
                component: component.name.clone(),
                tension_N: at(&solved.tension_N),
                torque_N_m: at(&solved.torque_N_m),
                side_force_N_per_m: at(&solved.side_force_N_per_m),
                von_mises_stress_Pa: at(&solved.von_mises_stress_Pa),
                yield_use: yield_use(&solved, row, &at),
                buckling: solved.buckling(row),
            }
        };
        Ok(depths.map(station).collect())
    }
}

/// The first row at or below a depth, and the share of the way to it from the row above.
fn between(md_m: &[f64], at_m: f64) -> (usize, f64) {
    let row = md_m.partition_point(|depth| *depth < at_m).min(md_m.len() - 1);
    let share = match row.checked_sub(1) {
        Some(above) if md_m[row] > md_m[above] => {
            ((at_m - md_m[above]) / (md_m[row] - md_m[above])).clamp(0.0, 1.0)
        }
        _ => 1.0,
    };
    (row, share)
}

/// The stress at a depth over the yield strength of the next row down.
fn yield_use(solved: &SoftProfile, row: usize, at: &impl Fn(&[f64]) -> f64) -> Option<f64> {
    let stress_Pa = solved.von_mises_stress_Pa[row];
    let strength_Pa = stress_Pa / solved.yield_use[row]?;
    Some(if stress_Pa > 0.0 { at(&solved.von_mises_stress_Pa) / strength_Pa } else { 0.0 })
}

#[cfg(test)]
mod tests {
    use super::between;

    #[test]
    fn rows_and_shares() {
        let md_m = [0.0, 10.0, 10.0, 20.0];
        assert_eq!(between(&md_m, 0.0), (0, 1.0));
        assert_eq!(between(&md_m, 2.5), (1, 0.25));
        assert_eq!(between(&md_m, 10.0), (1, 1.0));
        assert_eq!(between(&md_m, 25.0), (3, 1.0));
    }
}
