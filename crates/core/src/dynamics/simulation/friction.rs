//! The hole's friction, changed as the run goes.

use super::run::Run;
use crate::{
    dynamics::boundary::hole_friction::{FrictionFault, HoleFriction},
    simd::number::Real,
};

impl<R: Real> Run<R> {
    /// Sets the kinetic coefficient of friction of each section of the hole, which it reaches in
    /// proportion to time within `ramp_s`; those at rest and around the hole keep their ratios.
    ///
    /// # Errors
    /// A count that is not the sections', a coefficient or a time that there is not.
    pub fn set_friction(&mut self, kinetic: &[f64], ramp_s: f64) -> Result<(), FrictionFault> {
        let (hole, time_s) = (&self.model.well.hole, self.time_s());
        let mut friction =
            self.state.hole_friction.take().unwrap_or_else(|| HoleFriction::of(hole));
        let changed = friction.change(hole, kinetic, time_s, ramp_s);
        self.state.hole_friction = Some(friction);
        changed?;
        self.reach_friction();
        Ok(())
    }

    /// The kinetic coefficient of friction of each section of the hole now.
    pub fn friction(&self) -> Vec<f64> {
        match &self.state.hole_friction {
            Some(friction) => friction.kinetic().to_vec(),
            None => HoleFriction::of(&self.model.well.hole).kinetic().to_vec(),
        }
    }

    /// Gives the nodes the friction of now, where it is on its way.
    pub(super) fn reach_friction(&mut self) {
        let time_s = self.time_s();
        if let Some(friction) = &mut self.state.hole_friction
            && friction.moves()
            && let Ok(hole) = friction.reach(&self.model.well.hole, time_s)
        {
            self.borehole.set_friction_of(hole, &mut self.chain, &self.state.anchors);
        }
    }
}
