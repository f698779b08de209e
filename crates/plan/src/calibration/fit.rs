//! The fit of weighted least squares, with factors not below zero.

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt, TerminationReason};
use nalgebra_0_34::{DMatrix, DVector, Dyn, U1, VecStorage};

use super::{CalibrationError, Channel, Parameter, Reading, Settings, surface::Surfaces};

/// Readings, their predictions, and their errors.
#[derive(Debug, Clone)]
pub(super) struct Likelihood<'a> {
    pub(super) settings: &'a Settings,
    pub(super) surfaces: &'a Surfaces,
    pub(super) readings: &'a [Reading],
    /// The index of each reading's station.
    pub(super) station_of: &'a [usize],
    /// Standard errors by kind.
    pub(super) errors: [f64; 3],
    /// Weights of the squared residuals, with which a robust loss reduces those that are large; all
    /// one otherwise.
    pub(super) weights: Vec<f64>,
}

impl Likelihood<'_> {
    /// Returns the root of a reading's weight.
    fn root_weight(&self, row: usize) -> f64 {
        self.weights.get(row).map_or(1.0, |weight| weight.sqrt())
    }

    /// Returns the prediction of each reading, and its derivative with respect to each parameter.
    pub(super) fn predictions(&self, values: &[f64]) -> Vec<(f64, Vec<f64>)> {
        let stations = self.surfaces.at(values);
        let state = self.settings.state(values);
        let parameters = &self.settings.parameters;
        let prediction = |(reading, &station): (&Reading, &usize)| {
            let channel = reading.channel;
            let part = usize::from(channel.is_torque());
            let sloped = &stations[station];
            let mut slopes = vec![0.0; parameters.len()];
            for (place, slope) in &sloped.slopes {
                slopes[*place] = slope[part];
            }
            let beside = match channel {
                Channel::OnBottomTorque => (Parameter::BitTorque, state.bit_torque_N_m),
                Channel::OffBottomTorque => return (sloped.loads[part], slopes),
                _ => (Parameter::BlockWeight, state.block_weight_N),
            };
            if let Some(place) = parameters.iter().position(|parameter| *parameter == beside.0) {
                slopes[place] = 1.0;
            }
            (sloped.loads[part] + beside.1, slopes)
        };
        self.readings.iter().zip(self.station_of).map(prediction).collect()
    }

    pub(super) fn error_of(&self, reading: &Reading) -> f64 {
        self.errors[reading.channel.error().place()]
    }

    /// Returns the residuals, measured less predicted, over their errors.
    pub(super) fn residuals(&self, values: &[f64]) -> Vec<f64> {
        let predictions = self.predictions(values);
        let residual = |(row, (reading, (predicted, _))): (usize, (&Reading, &(f64, Vec<f64>)))| {
            self.root_weight(row) * (reading.value - predicted) / self.error_of(reading)
        };
        self.readings.iter().zip(&predictions).enumerate().map(residual).collect()
    }

    /// Returns the sum of their squares.
    pub(super) fn chi2(&self, values: &[f64]) -> f64 {
        self.residuals(values).iter().map(|residual| residual * residual).sum()
    }

    /// Returns the derivatives of the predictions over the errors, a row for each reading.
    pub(super) fn design(&self, values: &[f64]) -> DMatrix<f64> {
        let predictions = self.predictions(values);
        DMatrix::from_fn(self.readings.len(), values.len(), |row, column| {
            self.root_weight(row) * predictions[row].1[column] / self.error_of(&self.readings[row])
        })
    }

    /// Returns the best values, from initial ones, with some of them fixed; none is below zero,
    /// because neither friction nor the block's weight nor the bit's torque is. The second list
    /// marks those at zero.
    pub(super) fn fit(
        &self,
        from: &[f64],
        held: &[Option<f64>],
    ) -> Result<(Vec<f64>, Vec<bool>), CalibrationError> {
        let mut at_bound = vec![false; from.len()];
        let mut released = vec![false; from.len()];
        let mut values = from.to_vec();
        loop {
            let now: Vec<Option<f64>> = held
                .iter()
                .zip(&at_bound)
                .map(|(held, bound)| held.or(bound.then_some(0.0)))
                .collect();
            values = self.free_fit(&values, &now)?;
            let below = (0..values.len())
                .filter(|&index| now[index].is_none() && values[index] < 0.0)
                .min_by(|&a, &b| values[a].total_cmp(&values[b]));
            if let Some(index) = below {
                at_bound[index] = true;
                continue;
            }
            // A parameter that would rise again now that the others have moved is released, once.
            let residuals = self.residuals(&values);
            let design = self.design(&values);
            let rises = (0..values.len()).find(|&index| {
                let slope: f64 =
                    design.column(index).iter().zip(&residuals).map(|(j, r)| j * r).sum();
                at_bound[index] && !released[index] && slope > 1e-9
            });
            match rises {
                Some(index) => (at_bound[index], released[index]) = (false, true),
                None => return Ok((values, at_bound)),
            }
        }
    }

    fn free_fit(&self, from: &[f64], held: &[Option<f64>]) -> Result<Vec<f64>, CalibrationError> {
        let mut values: Vec<f64> =
            from.iter().zip(held).map(|(from, held)| held.unwrap_or(*from)).collect();
        let free: Vec<usize> = (0..values.len()).filter(|&index| held[index].is_none()).collect();
        if free.is_empty() {
            return Ok(values);
        }
        let at = DVector::from_iterator(free.len(), free.iter().map(|&index| values[index]));
        let problem = Problem { likelihood: self, whole: values.clone(), free: free.clone(), at };
        let (problem, report) = LevenbergMarquardt::new().minimize(problem);
        match report.termination {
            TerminationReason::NoImprovementPossible(_) => {}
            reason if reason.was_successful() => {}
            reason => return Err(CalibrationError::NotFitted(explained(&reason).to_owned())),
        }
        for (place, &index) in free.iter().enumerate() {
            values[index] = problem.at[place];
        }
        Ok(values)
    }
}

/// Returns the reason why the optimiser stopped, in a sentence.
fn explained(reason: &TerminationReason) -> &'static str {
    match reason {
        TerminationReason::Numerical(_) => {
            "a prediction or a reading is not a finite number, or the readings of a kind are all \
             zero"
        }
        TerminationReason::LostPatience => {
            "its steps did not become small, because the readings do not determine the fitted \
             numbers together. Give other readings too (pick-up, slack-off and rotating weights, \
             torque), or fit fewer numbers: one factor, a factor that is held, the block weight in \
             the case"
        }
        _ => "the readings are inconsistent with the fitted numbers",
    }
}

/// The problem in the form of the optimiser.
struct Problem<'a> {
    likelihood: &'a Likelihood<'a>,
    whole: Vec<f64>,
    free: Vec<usize>,
    at: DVector<f64>,
}

impl Problem<'_> {
    fn values(&self) -> Vec<f64> {
        let mut values = self.whole.clone();
        for (place, &index) in self.free.iter().enumerate() {
            values[index] = self.at[place];
        }
        values
    }
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Problem<'_> {
    type ResidualStorage = VecStorage<f64, Dyn, U1>;
    type JacobianStorage = VecStorage<f64, Dyn, Dyn>;
    type ParameterStorage = VecStorage<f64, Dyn, U1>;

    fn set_params(&mut self, at: &DVector<f64>) {
        self.at.copy_from(at);
    }

    fn params(&self) -> DVector<f64> {
        self.at.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        let residuals = self.likelihood.residuals(&self.values());
        // Predicted less measured: the Jacobian is then the design.
        Some(-DVector::from_vec(residuals))
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let design = self.likelihood.design(&self.values());
        Some(design.select_columns(&self.free))
    }
}
