//! The pattern on the bottom of a hole.

use serde::{Deserialize, Serialize};

use crate::Packed;

/// Part of the cells that are above the rim.
const RIM: f64 = 0.05;

/// Depths of the bottom of a hole by rings and sectors, SI.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BottomPicture {
    /// Radius of the middle of each ring, m, from the axis outwards.
    pub radius_m: Packed,
    /// Angle of the middle of each sector from the high side towards the right, rad; they part the circle evenly.
    pub angle_rad: Packed,
    /// Depth below the rim, m: sector by sector of a ring after the other; missing where nothing is known. The rim is what a
    /// twentieth of the cells is above: a splinter of the wall does not count.
    pub depth_m: Packed,
}

impl BottomPicture {
    /// A bottom whose depths have any origin; none where no depth is known.
    ///
    /// # Panics
    /// If there is not one depth for each sector of each ring.
    pub fn new(radius_m: &[f64], angle_rad: &[f64], depth_m: &[f64]) -> Option<Self> {
        assert_eq!(
            depth_m.len(),
            radius_m.len() * angle_rad.len(),
            "a depth for each cell"
        );
        let known = depth_m.iter().copied().filter(|depth| depth.is_finite());
        let mut known: Vec<f64> = known.collect();
        known.sort_by(f64::total_cmp);
        let rim = *known.get((RIM * known.len() as f64) as usize)?;
        Some(Self {
            radius_m: Packed::single(radius_m.iter().copied()),
            angle_rad: Packed::single(angle_rad.iter().copied()),
            depth_m: Packed::single(depth_m.iter().map(|depth| depth - rim)),
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
    use super::*;

    #[test]
    fn a_splinter_is_not_the_rim() {
        let radii: Vec<f64> = (0..40).map(f64::from).collect();
        let mut depths = vec![0.02; 40];
        depths[39] = -0.05;
        let bottom = BottomPicture::new(&radii, &[0.0], &depths).expect("depths are known");
        let depths = bottom.depth_m.values();
        assert_eq!(depths[0], 0.0);
        assert!((depths[39] + 0.07).abs() < 1e-8, "{} m", depths[39]);
    }

    #[test]
    fn depths_begin_at_the_rim() {
        let bottom = BottomPicture::new(
            &[0.01, 0.03],
            &[1.0, 3.0, 5.0],
            &[-5.0, f64::NAN, -4.5, -4.0, -5.5, -4.25],
        );
        let bottom = bottom.expect("depths are known");
        let depths = bottom.depth_m.values();
        assert!(depths[1].is_nan());
        assert_eq!(depths[4], 0.0);
        assert_eq!(depths[3], 1.5);
        let [inner, outer] = bottom.edges_m();
        assert!(inner.abs() < 1e-9 && (outer - 0.04).abs() < 1e-9);
        assert_eq!(BottomPicture::new(&[0.1], &[0.0], &[f64::NAN]), None);
    }
}
