//! Results along the hole: friction work, contact over depth and time, and the path of the well.

use serde::{Deserialize, Serialize};

use super::{
    column::{columns, unlike_declared},
    method::{IN_TIME, ModelKind},
};
use crate::well::Path;

columns! {
    /// Wear of the hole from the surface to the bit, a row per [`HOLE_STEP_M`]. Columns that the
    /// method does not provide are empty.
    #[derive(Debug, Clone, PartialEq, Default)]
    pub struct HoleWear, "Columns of the wear of the hole, in the order of `wear.parquet`."
    HOLE_WEAR {
        md_m: Vec<f64> => Depth, "Measured depth of the middle of the stretch";
        wear_work_J_per_m: Vec<f64> => WorkPerLength,
            "Work of friction over the window per metre of hole: force times sliding distance",
            known_by IN_TIME;
        wear_power_W_per_m: Vec<f64> => PowerPerLength,
            "Mean rate of the work of friction, for a soft string the rate: force times sliding \
             speed; multiplied by 3600, the work in an hour of the same operation";
    }
}

impl HoleWear {
    /// As [`Profile::unlike_declared`](super::Profile::unlike_declared).
    pub fn unlike_declared(&self, model: ModelKind) -> Vec<&'static str> {
        unlike_declared(HOLE_WEAR, self, model)
    }
}

/// Length of hole that one number of a profile along the hole represents, m.
pub const HOLE_STEP_M: f64 = 5.0;

/// Number of values for a hole down to a depth, m; at least one.
pub(crate) fn hole_steps(to_md_m: f64) -> usize {
    (to_md_m / HOLE_STEP_M).ceil().max(1.0) as usize
}

/// Measured depths of the middles of this many stretches, m.
pub(crate) fn hole_depths_m(steps: usize) -> Vec<f64> {
    (0..steps).map(|i| (i as f64 + 0.5) * HOLE_STEP_M).collect()
}

/// Spreads an amount evenly over a stretch of the hole; the part beyond either end is added at that
/// end.
pub(crate) fn spread(hole: &mut [f64], from_m: f64, to_m: f64, amount: f64) {
    let last = hole.len() - 1;
    let place = |md: f64| ((md / HOLE_STEP_M).max(0.0) as usize).min(last);
    let (first, end) = (place(from_m), place(to_m));
    let per_m = amount / (to_m - from_m);
    for (step, sum) in hole.iter_mut().enumerate().take(end + 1).skip(first) {
        let top = if step == first { from_m } else { step as f64 * HOLE_STEP_M };
        let bottom = if step == end { to_m } else { (step + 1) as f64 * HOLE_STEP_M };
        *sum += per_m * (bottom - top);
    }
}

// Contact over depth and time, declared once.

columns! {
    /// Contact over depth and time, coarse: row after row in time, each from the surface down.
    /// There is one stretch of string per column of a row, at most 200 of them, and each row is an
    /// average over the time since the one before, at most 201.
    #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
    pub struct ContactMap, "Columns of a map of contact, in the order of `contact.parquet`."
    CONTACT_MAP {
        time_s: Vec<f64> => Time,
            "Simulated time at the end of the average, settling included", known_by IN_TIME;
        md_m: Vec<f64> => Depth,
            "Measured depth of the middle of the stretch of string", known_by IN_TIME;
        side_force_N_per_m: Vec<f64> => ForcePerLength,
            "Mean side force per length since the time before; positive where the string lies on \
             the high side",
            known_by IN_TIME;
        contact_force_N_per_m: Vec<f64> => ForcePerLength,
            "Mean magnitude of the contact force per length since the time before",
            known_by IN_TIME;
    }
}

// The path of a well in columns, declared once.

columns! {
    /// The path of a well at some measured depths.
    #[derive(Debug, Clone, PartialEq, Default)]
    pub struct WellPath, "Columns of the path of a well."
    WELL_PATH {
        md_m: Vec<f64> => Depth, "Measured depth";
        north_m: Vec<f64> => Length, "North";
        east_m: Vec<f64> => Length, "East";
        tvd_m: Vec<f64> => Depth, "True vertical depth";
        vertical_section_m: Vec<f64> => Length, "Distance along the closure's direction";
        inclination_rad: Vec<f64> => Angle, "Inclination";
        azimuth_rad: Vec<f64> => Angle, "Azimuth";
        dogleg_severity_rad_per_m: Vec<f64> => Curvature, "Dogleg severity";
    }
}

impl WellPath {
    /// The path at these measured depths.
    pub fn at(path: &Path, md_m: Vec<f64>) -> Self {
        let from = path.at(path.first_md_m()).position_m;
        let closure = (path.at(path.last_md_m()).position_m - from).xy();
        // Zero of a path that ends below its beginning.
        let direction = closure.try_normalize(1e-9).unwrap_or_default();
        let mut well = Self::default();
        for &md in &md_m {
            let place = path.at(md);
            well.north_m.push(place.position_m.x);
            well.east_m.push(place.position_m.y);
            well.tvd_m.push(place.position_m.z);
            well.vertical_section_m.push((place.position_m - from).xy().dot(&direction));
            well.inclination_rad.push(place.inclination_rad());
            well.azimuth_rad.push(place.azimuth_rad());
            well.dogleg_severity_rad_per_m.push(path.dogleg_severity_rad_per_m(md));
        }
        Self { md_m, ..well }
    }

    /// The same for a drawing in single precision: coordinates of a map, which have no digits to
    /// spare there, are counted from the first station; distances from a slot stay.
    pub fn drawn(mut self, path: &Path) -> Self {
        let start = path.tie_in();
        if start.is_on_map() {
            self.north_m.iter_mut().for_each(|north_m| *north_m -= start.north_m);
            self.east_m.iter_mut().for_each(|east_m| *east_m -= start.east_m);
        }
        self
    }
}
