//! The path of a well in columns, declared once.

use super::column::columns;
use crate::well::Path;

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
