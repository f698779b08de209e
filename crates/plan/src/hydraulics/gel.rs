//! Breaking of the gel of a mud that has rested.

use wholestring::{
    model::Model,
    mud::{AnnulusGel, gel::bore_gradient_Pa_per_m},
};

use super::passage::Passages;

/// Pressures that break the gel on the whole path of the mud at once, down the bore and up the
/// annulus: an upper limit of the pump pressure before anything flows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GelBreak {
    /// In the bore, Pa.
    pub bore_Pa: f64,
    /// In the annulus, Pa.
    pub annulus_Pa: f64,
    /// Reduction of the hook load by the gel in the annulus meanwhile, N, where no wall holds the
    /// string.
    pub lift_N: f64,
}

impl GelBreak {
    /// Returns the required pressure of the pump, Pa.
    pub fn pressure_Pa(&self) -> f64 {
        self.bore_Pa + self.annulus_Pa
    }
}

/// Returns the pressures that break a gel of this strength, Pa, with the bit at a measured depth,
/// m.
pub fn gel_break(model: &Model, bit_depth_m: f64, gel_strength_Pa: f64) -> GelBreak {
    let mut all = GelBreak { bore_Pa: 0.0, annulus_Pa: 0.0, lift_N: 0.0 };
    for (length_m, annulus, bore_m2) in Passages::of(model, bit_depth_m).lengths() {
        let AnnulusGel { gradient_Pa_per_m, lift_N_per_m } = annulus.gel(gel_strength_Pa);
        all.bore_Pa += length_m * bore_gradient_Pa_per_m(gel_strength_Pa, bore_m2);
        all.annulus_Pa += length_m * gradient_Pa_per_m;
        all.lift_N += length_m * lift_N_per_m;
    }
    all
}
