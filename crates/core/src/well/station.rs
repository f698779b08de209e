//! Survey stations.

/// One survey station.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Station {
    /// Measured depth along the hole, m.
    pub md_m: f64,
    /// Inclination from vertical, rad.
    pub inclination_rad: f64,
    /// Azimuth from north, clockwise seen from above, rad.
    pub azimuth_rad: f64,
}
