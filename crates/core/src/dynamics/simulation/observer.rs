//! Observers of a run, and a run to its end.

use std::ops::ControlFlow;

use super::{Simulation, diverged::Diverged};
use crate::dynamics::output::outcome::DynamicOutcome;

/// Looks at a simulation after each sample.
///
/// It finds the sample in the last row of [`Simulation::series`], and the whole string in
/// [`Simulation::frame`], which costs a pass over the string. A closure is an observer, too:
///
/// ```
/// # use std::ops::ControlFlow;
/// # use wholestring::{dynamics::{Observer, Simulation}, prelude::*};
/// fn print_hook_load(simulation: &mut Simulation) -> Result<(), Box<dyn std::error::Error>> {
///     simulation.advance_with(1.0, &mut |now: &Simulation| {
///         println!("{:.2} s: {:?} N", now.time_s(), now.series().hook_load_N.last());
///         ControlFlow::Continue(())
///     })?;
///     Ok(())
/// }
/// ```
pub trait Observer {
    /// Called after each sample. [`ControlFlow::Break`] ends the call that the simulation continues
    /// in; the simulation itself can continue in another.
    fn sampled(&mut self, simulation: &Simulation) -> ControlFlow<()>;
}

impl<F: FnMut(&Simulation) -> ControlFlow<()>> Observer for F {
    fn sampled(&mut self, simulation: &Simulation) -> ControlFlow<()> {
        self(simulation)
    }
}

impl Simulation {
    /// Advances by `seconds`, to the nearest sample, or until the observer breaks off. The answer
    /// does not depend on who looks.
    ///
    /// # Errors
    /// A run that diverged; its earlier samples remain available.
    pub fn advance_with(
        &mut self,
        seconds: f64,
        observer: &mut dyn Observer,
    ) -> Result<ControlFlow<()>, Diverged> {
        let samples = (seconds / self.sample_interval_s()).round().max(1.0) as u64;
        for _ in 0..samples {
            self.advance(self.sample_interval_s())?;
            if observer.sampled(self).is_break() {
                return Ok(ControlFlow::Break(()));
            }
        }
        Ok(ControlFlow::Continue(()))
    }

    /// Advances to the end of the window, and returns the solution over it. [`Simulation::frame`]
    /// and [`Simulation::series`] stay available.
    ///
    /// # Errors
    /// A run that diverged; its earlier samples remain available.
    pub fn to_end(&mut self) -> Result<DynamicOutcome, Diverged> {
        self.to_end_with(&mut |_: &Self| ControlFlow::Continue(()))
    }

    /// The same with an observer; the answer so far where it breaks off.
    ///
    /// # Errors
    /// Those of [`Self::to_end`].
    pub fn to_end_with(&mut self, observer: &mut dyn Observer) -> Result<DynamicOutcome, Diverged> {
        let sample_s = self.sample_interval_s();
        // The end is known when the window begins, and the last sample is the nearest to it.
        while self.time_s() < self.end_time_s() - 0.5 * sample_s {
            if self.advance_with(sample_s, observer)?.is_break() {
                break;
            }
        }
        Ok(self.outcome())
    }
}
