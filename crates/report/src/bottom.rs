//! The pattern on the bottom of a hole.

use serde::{Deserialize, Serialize};
use wholestring_results::Table;

use crate::Packed;

/// Part of the cells that are above the rim.
const RIM: f64 = 0.05;

/// Depths of the bottom of a hole by rings and sectors, SI.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BottomPicture {
    /// Radius of the middle of each ring, m, from the axis outwards.
    pub radius_m: Packed,
    /// Angle of the middle of each sector from the high side towards the right, rad; they part the
    /// circle evenly.
    pub angle_rad: Packed,
    /// Depth below the rim, m: sector by sector of a ring after the other; missing where it is not
    /// known. A twentieth of the cells are above the rim, so that a splinter of the wall does not
    /// count.
    pub depth_m: Packed,
}

impl BottomPicture {
    /// The bottom in the rows of a `bottom_hole.parquet`; `None` if it has none.
    pub fn of_table(table: &Table) -> Option<Self> {
        let [mut radius_m, mut angle_rad, depth_m] =
            ["radius_m", "angle_rad", "depth_m"].map(|name| table.values(name));
        // Sectors of a ring are consecutive.
        let sectors = radius_m.iter().take_while(|radius| **radius == radius_m[0]).count();
        if sectors == 0 || !radius_m.len().is_multiple_of(sectors) {
            return None;
        }
        radius_m = radius_m.into_iter().step_by(sectors).collect();
        angle_rad.truncate(sectors);
        Self::new(&radius_m, &angle_rad, &depth_m)
    }

    /// Creates a bottom whose depths have any origin; `None` where no depth is known, or where
    /// there is not one depth for each sector of each ring. Cells farther from the rim than the
    /// bottom is from its axis to its edge are loose pieces, and are left out.
    pub fn new(radius_m: &[f64], angle_rad: &[f64], depth_m: &[f64]) -> Option<Self> {
        if depth_m.len() != radius_m.len() * angle_rad.len() {
            return None;
        }
        let known = depth_m.iter().copied().filter(|depth| depth.is_finite());
        let mut known: Vec<f64> = known.collect();
        known.sort_by(f64::total_cmp);
        let rim = *known.get((RIM * known.len() as f64) as usize)?;
        // Pieces that have come off the rock do not belong to the bottom.
        let far_m = radius_m.last().copied().unwrap_or(0.0);
        let place = |depth: f64| if depth.abs() > far_m { f64::NAN } else { depth };
        Some(Self {
            radius_m: Packed::single(radius_m.iter().copied()),
            angle_rad: Packed::single(angle_rad.iter().copied()),
            depth_m: Packed::single(depth_m.iter().map(|depth| place(depth - rim))),
        })
    }

    /// Radii of the inner edge of the first ring and of the outer edge of the last one, m.
    pub(crate) fn edges_m(&self) -> [f64; 2] {
        let radii = self.radius_m.values();
        let [first, .., last] = radii[..] else {
            return [0.0, 2.0 * radii.first().copied().unwrap_or(0.0)];
        };
        let half = 0.5 * (last - first) / (radii.len() - 1) as f64;
        [(first - half).max(0.0), last + half]
    }
}

#[cfg(test)]
mod tests {
    use wholestring_results::BOTTOM_HOLE;

    use super::*;

    /// Ring by ring; a table without rows has no bottom.
    #[test]
    fn a_bottom_is_read_back() {
        const NAN: f64 = f64::NAN;
        let mut table = Table::with_columns(BOTTOM_HOLE);
        assert_eq!(BottomPicture::of_table(&table), None);
        table.append(
            &[("operation", &["drill"])],
            &[
                ("radius_m", &[0.03, 0.03, 0.03, 0.05, 0.05, 0.05]),
                ("angle_rad", &[1.0, 3.0, 5.0, 1.0, 3.0, 5.0]),
                ("depth_m", &[-0.03, NAN, 0.0, 0.0, 0.0, 0.01]),
            ],
        );
        let picture = BottomPicture::of_table(&table).expect("a bottom");
        let near = |a: f64, b: f64| (a - b).abs() < 1e-7;
        let radii = picture.radius_m.values();
        assert!(radii.len() == 2 && near(radii[1], 0.05), "{radii:?}");
        assert_eq!(picture.angle_rad.values(), [1.0, 3.0, 5.0]);
        let depths = picture.depth_m.values();
        assert!(near(depths[0], 0.0) && depths[1].is_nan() && near(depths[5], 0.04));
        assert_eq!(BottomPicture::of_table(&Table::new(Vec::new())), None);
    }

    #[test]
    fn a_splinter_is_not_the_rim() {
        let radii: Vec<f64> = (1..=40).map(|ring| 0.004 * f64::from(ring)).collect();
        let mut depths = vec![0.02; 40];
        depths[39] = -0.05;
        let bottom = BottomPicture::new(&radii, &[0.0], &depths).expect("depths are known");
        let depths = bottom.depth_m.values();
        assert_eq!(depths[0], 0.0);
        assert!((depths[39] + 0.07).abs() < 1e-8, "{} m", depths[39]);
    }

    #[test]
    fn a_loose_element_is_not_the_bottom() {
        let radii = [0.02, 0.06, 0.1];
        let bottom = BottomPicture::new(&radii, &[0.0], &[0.0, 1.1, 0.09]);
        let depths = bottom.expect("depths are known").depth_m.values();
        assert!(depths[0] == 0.0 && depths[1].is_nan() && depths[2] > 0.08);
    }

    #[test]
    fn depths_begin_at_the_rim() {
        let bottom = BottomPicture::new(
            &[0.01, 0.03],
            &[1.0, 3.0, 5.0],
            &[-5.005, f64::NAN, -5.0, -5.0, -5.01, -4.99],
        );
        let bottom = bottom.expect("depths are known");
        let depths = bottom.depth_m.values();
        assert!(depths[1].is_nan());
        assert_eq!(depths[4], 0.0);
        assert!((depths[3] - 0.01).abs() < 1e-8);
        let [inner, outer] = bottom.edges_m();
        assert!(inner.abs() < 1e-9 && (outer - 0.04).abs() < 1e-9);
        assert_eq!(BottomPicture::new(&[0.1], &[0.0], &[f64::NAN]), None);
        assert_eq!(BottomPicture::new(&[0.1, 0.2], &[0.0], &[1.0]), None);
    }
}
