//! The pattern on the bottom of a hole.

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

/// Heights of a bottom by rings and sectors: the mean of the values added to each cell.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BottomHole {
    radii_m: [f64; 2],
    rings: usize,
    sectors: usize,
    /// Sum of the depths in each cell, sector by sector of a ring, and their number.
    sums: Vec<(f64, u32)>,
}

impl BottomHole {
    /// A bottom between two radii, m, of which nothing is known.
    ///
    /// # Panics
    ///
    /// If there is no ring or no sector.
    pub fn new(radii_m: [f64; 2], rings: usize, sectors: usize) -> Self {
        assert!(rings > 0 && sectors > 0, "a bottom needs rings and sectors");
        Self { radii_m, rings, sectors, sums: vec![(0.0, 0); rings * sectors] }
    }

    /// Number of rings.
    pub fn rings(&self) -> usize {
        self.rings
    }

    /// Number of sectors.
    pub fn sectors(&self) -> usize {
        self.sectors
    }

    /// Radius of the middle of a ring, m.
    pub fn radius_m(&self, ring: usize) -> f64 {
        let [from, to] = self.radii_m;
        from + (to - from) * (ring as f64 + 0.5) / self.rings as f64
    }

    /// Angle of the middle of a sector from `x` towards `y`, rad.
    pub fn angle_rad(&self, sector: usize) -> f64 {
        TAU * (sector as f64 + 0.5) / self.sectors as f64
    }

    /// Depth of a cell, m; `None` where nothing is known.
    pub fn z_m(&self, ring: usize, sector: usize) -> Option<f64> {
        let (sum, count) = self.sums[ring * self.sectors + sector];
        (count > 0).then(|| sum / f64::from(count))
    }

    /// Takes in a point of the bottom, `x` and `y` across the hole's axis, `z` down it. One outside
    /// the rings is left out.
    pub fn add(&mut self, [x, y, z]: [f64; 3]) {
        let [from, to] = self.radii_m;
        let ring = (libm::hypot(x, y) - from) / (to - from) * self.rings as f64;
        if !(0.0..self.rings as f64).contains(&ring) {
            return;
        }
        let turn = libm::atan2(y, x).rem_euclid(TAU) / TAU;
        let sector = ((turn * self.sectors as f64) as usize).min(self.sectors - 1);
        let (sum, count) = &mut self.sums[ring as usize * self.sectors + sector];
        *sum += z;
        *count += 1;
    }

    /// Sets the depth of a cell, m.
    pub fn set_m(&mut self, ring: usize, sector: usize, z_m: f64) {
        self.sums[ring * self.sectors + sector] = (z_m, 1);
    }

    /// Rock between an earlier bottom of the same cells and this one, m³, where both are known.
    ///
    /// # Panics
    ///
    /// If the cells are not the same.
    pub fn removed_since_m3(&self, earlier: &Self) -> f64 {
        let same = self.radii_m == earlier.radii_m
            && (self.rings, self.sectors) == (earlier.rings, earlier.sectors);
        assert!(same, "bottoms of other cells");
        let [from, to] = self.radii_m;
        let width = (to - from) / self.rings as f64;
        let mut removed = 0.0;
        for ring in 0..self.rings {
            let area = TAU * self.radius_m(ring) * width / self.sectors as f64;
            for sector in 0..self.sectors {
                if let (Some(now), Some(then)) = (self.z_m(ring, sector), earlier.z_m(ring, sector))
                {
                    removed += (now - then) * area;
                }
            }
        }
        removed
    }
}
