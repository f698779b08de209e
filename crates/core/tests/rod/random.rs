//! Numbers that are random and the same in every run.

use nalgebra::Vector3;

/// Steele, Lea and Flood's SplitMix64 (2014).
pub struct Random(pub u64);

impl Random {
    /// Between `low` and `high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        low + (high - low) * (z >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A vector with components between −`size` and `size`.
    pub fn vector(&mut self, size: f64) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.between(-size, size))
    }

    /// A vector across `director`.
    pub fn across(&mut self, director: Vector3<f64>, size: f64) -> Vector3<f64> {
        let v = self.vector(size);
        v - director * director.dot(&v)
    }
}
