//! What breaks the gel of a mud that has rested.

use wholestring::{
    model::Model,
    mud::{AnnulusGel, gel::bore_gradient_Pa_per_m},
};

use super::passage::Passages;

/// What breaks the gel on the whole way of the mud at once, down the bore and up the annulus: the most that the
/// pump must give before anything flows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GelBreak {
    /// In the bore, Pa.
    pub bore_Pa: f64,
    /// In the annulus, Pa.
    pub annulus_Pa: f64,
    /// What the gel in the annulus takes off the hook load meanwhile, N, where no wall holds the string.
    pub lift_N: f64,
}

impl GelBreak {
    /// What the pump must give, Pa.
    pub fn pressure_Pa(&self) -> f64 {
        self.bore_Pa + self.annulus_Pa
    }
}

/// What breaks a gel of this strength, Pa, with the bit at a measured depth, m.
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
