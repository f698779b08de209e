//! The units that the standards print in.

/// An inch, m.
pub(super) const INCH_M: f64 = 0.0254;
/// A pound per square inch, Pa.
pub(super) const PSI_PA: f64 = 6894.757293168361;

/// Pound per foot, kg/m.
pub(super) const POUND_PER_FOOT_KG_PER_M: f64 = 0.453_592_37 / 0.3048;
