//! A soft string in its hole, for any number of operations.

use super::{
    SoftError, SoftLoads, SoftProfile, SoftSettings, error,
    hole::{self, Stretch},
    integrate::{self, Integral, Keep},
    loads::{BucklingMargins, Loads, Rows},
};
use crate::{model::Model, operation::Operation};

/// A soft string with its bit at one depth, ready for any number of operations: it contains the
/// data that none of them changes, the hole step by step and the buckling loads there, which are
/// most of the work of one solution.
///
/// ```
/// use wholestring::{prelude::*, statics::soft::{SoftSettings, SoftString, solve}};
///
/// # let top = Station::from_degrees(0.0, 0.0, 0.0);
/// # let stations = [top, Station::from_degrees(900.0, 40.0, 0.0)];
/// # let path = Path::minimum_curvature(&stations)?;
/// # let hole = Hole::new(vec![HoleSection::open(0.0..900.0, 0.2159, 0.3)])?;
/// # let string = StringSpec::from_bit(ComponentSpec::bit(0.2159, 0.3))
/// #     .catalogue("5 in 19.50 lb/ft S-135", ToSurface)?.assemble(900.0)?;
/// # let model = Model::new(Well { path, hole }, string, Mud::of_density(1200.0));
/// let settings = SoftSettings::default();
/// let string = SoftString::new(&model, 900.0, &settings)?;
/// for operation in [Operation::trip_out(900.0), Operation::trip_in(900.0)] {
///     assert_eq!(string.solve(&operation)?, solve(&model, &operation, &settings)?);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct SoftString<'a> {
    model: &'a Model,
    settings: SoftSettings,
    bit_depth_m: f64,
    /// From the bit up.
    stretches: Vec<Stretch>,
}

impl<'a> SoftString<'a> {
    /// The string of a model with its bit at a depth, m.
    ///
    /// # Errors
    /// A setting or a depth out of its range, or a string that is not as long as the bit is deep.
    pub fn new(
        model: &'a Model,
        bit_depth_m: f64,
        settings: &SoftSettings,
    ) -> Result<Self, SoftError> {
        error::check_string(model, bit_depth_m, settings)?;
        Ok(Self::elsewhere(model, bit_depth_m, settings))
    }

    /// The same of a string that need not be as long as its bit is deep.
    pub(super) fn elsewhere(model: &'a Model, bit_depth_m: f64, settings: &SoftSettings) -> Self {
        let stretches = hole::stretches(model, bit_depth_m, settings.step_m);
        Self { model, settings: *settings, bit_depth_m, stretches }
    }

    /// Torque and drag of an operation with the bit where the string has it, whatever depth the
    /// operation names.
    ///
    /// # Errors
    /// A set point out of its range, or a load that leaves the range of floating-point numbers.
    pub fn solve(&self, operation: &Operation) -> Result<SoftProfile, SoftError> {
        error::check_operation(self.model, operation)?;
        let (rows, integral) = self.rows(operation)?;
        Ok(SoftProfile::new(self.model, &self.here(operation), rows, &integral))
    }

    /// Loads of string and rig in an operation, without the other results of [`Self::solve`].
    ///
    /// # Errors
    /// Those of [`Self::solve`].
    pub fn loads(&self, operation: &Operation) -> Result<SoftLoads, SoftError> {
        error::check_operation(self.model, operation)?;
        let mut loads = Loads::new(self.nodes());
        let integral = self.integrate(operation, &mut loads)?;
        Ok(SoftLoads::new(loads, &integral))
    }

    /// Least additional compression along the string in an operation up to a sinusoid and up to a
    /// helix, N; infinite where nothing can buckle.
    ///
    /// # Errors
    /// Those of [`Self::solve`].
    pub fn buckling_margins_N(&self, operation: &Operation) -> Result<[f64; 2], SoftError> {
        error::check_operation(self.model, operation)?;
        let mut margins = BucklingMargins::NONE;
        self.integrate(operation, &mut margins)?;
        Ok(margins.0)
    }

    /// Everything of an operation whose set points are in their ranges.
    pub(super) fn rows(&self, operation: &Operation) -> Result<(Rows, Integral), SoftError> {
        let mut rows = Rows::new(&self.here(operation), self.nodes());
        let integral = self.integrate(operation, &mut rows)?;
        Ok((rows, integral))
    }

    fn integrate(
        &self,
        operation: &Operation,
        keep: &mut impl Keep,
    ) -> Result<Integral, SoftError> {
        let operation = self.here(operation);
        integrate::from_bit(self.model, &self.stretches, &operation, &self.settings, keep)
    }

    /// An operation with the bit here.
    fn here(&self, operation: &Operation) -> Operation {
        Operation { bit_depth_m: self.bit_depth_m, ..*operation }
    }

    /// One at the end of each step, and one at the bit.
    fn nodes(&self) -> usize {
        self.stretches.iter().map(|stretch| stretch.steps.len()).sum::<usize>() + 1
    }
}

#[cfg(test)]
mod tests;
