//! Results of the soft string.

use std::ops::Deref;

use nalgebra::Vector3;

use super::{
    integrate::Integral,
    loads::{Row, Rows},
};
use crate::{
    model::Model,
    mud::Hydraulics,
    operation::Operation,
    outcome::{
        HOLE_STEP_M, HoleWear, Profile, Scalars, cutoff_in_build_m, hole_depths_m, neutral_rows,
    },
};

/// Results of the soft string: loads along the string, from the surface to the bit, and their
/// scalars.
///
/// Its profile's columns are read as its own: `soft.tension_N`. `md_m` goes from 0 to the depth of
/// the bit. Where a property jumps (a station of a minimum-curvature path, the end of a component
/// or hole section), side force and friction are those of the stretch above. The string is on the
/// wall all the time, wherever a load presses it there.
#[derive(Debug, Clone, PartialEq)]
pub struct SoftProfile {
    /// Along the string.
    pub profile: Profile,
    /// Unit vector from the hole's axis to where the pipe touches the wall, the direction of the
    /// load; towards the low side where there is no load. A row for each of the profile.
    pub contact_direction: Vec<Vector3<f64>>,
    /// Along the hole.
    pub wear: HoleWear,
    /// The operation's scalars.
    pub scalars: Scalars,
    /// Effect of the mud; none without a rheology.
    pub hydraulics: Option<Hydraulics>,
}

impl Deref for SoftProfile {
    type Target = Profile;

    fn deref(&self) -> &Profile {
        &self.profile
    }
}

impl SoftProfile {
    pub(super) fn new(
        model: &Model,
        operation: &Operation,
        row_set: Rows,
        &Integral { totals, hydraulics, .. }: &Integral,
    ) -> Self {
        let Rows { mut rows, hole_W, .. } = row_set;
        rows.reverse();
        let column = |value: fn(&Row) -> f64| rows.iter().map(value).collect::<Vec<f64>>();
        let md_m = column(|row| row.md_m);
        let maybe = |value: fn(&Row) -> Option<f64>| rows.iter().map(value).collect::<Vec<_>>();
        let tension_N = column(|row| row.totals.tension_N);
        let side_force_N_per_m = column(|row| {
            let side = row.load.q_N_per_m.dot(&row.high_side);
            row.load.side_force_N_per_m.copysign(side)
        });
        let bit_torque_N_m = operation.bit_torque_now_N_m();
        let scalars = Scalars {
            hook_load_N: totals.tension_N,
            surface_torque_N_m: totals.torque_N_m,
            friction_torque_N_m: totals.torque_N_m
                - bit_torque_N_m
                - hydraulics.map_or(0.0, |mud| mud.mud_torque_N_m),
            axial_friction_N: totals.axial_friction_N,
            side_force_total_N: totals.side_force_N,
            weight_on_bit_N: operation.weight_on_bit_now_N(),
            bit_torque_N_m,
            twist_rad: totals.twist_rad,
            stretch_m: totals.stretch_m,
            neutral_point_m: neutral_point_m(&rows),
            cutoff_depth_m: cutoff_in_build_m(
                &model.well.path,
                operation.bit_depth_m,
                &md_m,
                &side_force_N_per_m,
            ),
        };
        let contact_direction = rows
            .iter()
            .map(|row| {
                let load = row.load.q_N_per_m.try_normalize(0.0);
                load.unwrap_or(-row.high_side)
            })
            .collect();
        let touches = |force: &f64| f64::from(u8::from(*force != 0.0));
        let profile = Profile {
            contact_fraction: side_force_N_per_m.iter().map(touches).collect(),
            torque_N_m: column(|row| row.totals.torque_N_m),
            axial_friction_N_per_m: column(|row| row.load.axial_friction_N_per_m),
            friction_torque_N_m_per_m: column(|row| row.load.friction_torque_N_m_per_m),
            stretch_m: column(|row| row.totals.stretch_m),
            twist_rad: column(|row| row.totals.twist_rad),
            climb_rad: maybe(|row| row.bearing.climb_rad),
            lateral_offset_m: column(|row| row.bearing.lateral_offset_m),
            side_force_per_joint_N: maybe(|row| row.bearing.side_force_per_joint_N),
            outside_pressure_Pa: column(|row| row.bearing.outside_pressure_Pa),
            inside_pressure_Pa: column(|row| row.bearing.inside_pressure_Pa),
            true_tension_N: column(|row| row.bearing.true_tension_N),
            bending_moment_N_m: column(|row| row.bearing.bending_moment_N_m),
            bending_moment_between_N_m: column(|row| row.bearing.bending_moment_between_N_m),
            sag_m: column(|row| row.bearing.sag_m),
            body_contact_fraction: column(|row| row.bearing.body_contact_fraction),
            bending_stress_Pa: column(|row| row.bearing.bending_stress_Pa),
            von_mises_stress_Pa: column(|row| row.bearing.von_mises_stress_Pa),
            yield_use: maybe(|row| row.bearing.yield_use),
            wear_power_W_per_m: column(|row| row.bearing.wear_power_W_per_m),
            sinusoidal_load_N: maybe(|row| row.buckling_loads_N.map(|loads_N| loads_N[0])),
            helical_load_N: maybe(|row| row.buckling_loads_N.map(|loads_N| loads_N[1])),
            md_m,
            tension_N,
            side_force_N_per_m,
            // Quantities that vary in time are left out.
            ..Profile::default()
        };
        Self {
            profile,
            contact_direction,
            wear: HoleWear {
                md_m: hole_depths_m(hole_W.len()),
                wear_power_W_per_m: hole_W.iter().map(|power| power / HOLE_STEP_M).collect(),
                wear_work_J_per_m: Vec::new(),
            },
            scalars,
            hydraulics,
        }
    }

    /// Effective tension at a measured depth, N, linear between the rows; the end's value beyond
    /// them.
    pub fn tension_at_N(&self, md_m: f64) -> f64 {
        interpolate(&self.md_m, &self.tension_N, md_m)
    }

    /// Signed side force at a measured depth, N/m, linear between the rows; the end's value beyond
    /// them.
    pub fn side_force_at_N_per_m(&self, md_m: f64) -> f64 {
        interpolate(&self.md_m, &self.side_force_N_per_m, md_m)
    }

    /// Direction of contact at a measured depth: that of the nearest row.
    pub fn contact_direction_at(&self, md_m: f64) -> Vector3<f64> {
        let below = self.md_m.partition_point(|&md| md < md_m);
        let below = below.min(self.md_m.len() - 1);
        let above = below.saturating_sub(1);
        let nearer_above = md_m - self.md_m[above] < self.md_m[below] - md_m;
        self.contact_direction[if nearer_above { above } else { below }]
    }
}

/// Measured depth of the shallowest change between tension and compression, m, of rows from the
/// surface down. Between two of them the tension is a parabola that leaves the lower one with its
/// rate: a straight line would move with the rows by some tenths of a millimetre.
fn neutral_point_m(rows: &[Row]) -> Option<f64> {
    let tensions_N = || rows.iter().map(|row| row.totals.tension_N);
    let largest_N = tensions_N().fold(0.0_f64, |largest, tension| largest.max(tension.abs()));
    let [(above, _), (below, _)] = neutral_rows(tensions_N().enumerate(), largest_N)?;
    let pair = rows[above..=below].windows(2).find(|pair| {
        let [upper_N, lower_N] = [0, 1].map(|index| pair[index].totals.tension_N);
        (upper_N > 0.0) != (lower_N > 0.0)
    })?;
    let (upper, lower) = (&pair[0], &pair[1]);
    let length_m = lower.md_m - upper.md_m;
    let (from_N, to_N) = (lower.totals.tension_N, upper.totals.tension_N);
    let by_N = lower.tension_rate_N_per_m * length_m;
    let bend_N = to_N - from_N - by_N;
    // `from + by x + bend x²` is zero between 0 and 1, by halves.
    let (mut same, mut other) = (0.0, 1.0);
    for _ in 0..60 {
        let part: f64 = 0.5 * (same + other);
        let there_N = from_N + part * (by_N + part * bend_N);
        if (there_N > 0.0) == (from_N > 0.0) {
            same = part;
        } else {
            other = part;
        }
    }
    Some(lower.md_m - other * length_m)
}

fn interpolate(md: &[f64], values: &[f64], at_m: f64) -> f64 {
    let below = md.partition_point(|&md| md < at_m);
    if below == 0 {
        return values[0];
    }
    if below == md.len() {
        return values[below - 1];
    }
    let part = (at_m - md[below - 1]) / (md[below] - md[below - 1]);
    values[below - 1] + part * (values[below] - values[below - 1])
}
