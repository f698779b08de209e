//! The uncertainty of the parameters: covariance, correlation, leverage.

use nalgebra_0_34::{DMatrix, DVector};

use super::{CalibrationError, Settings};

/// Lower limit of singular values, as a part of the largest.
const SINGULAR: f64 = 1e-8;

/// Statistics of the parameters from a design matrix.
#[derive(Debug, Clone)]
pub(super) struct Spread {
    /// Covariance; zero for parameters at their bounds.
    pub(super) covariance: DMatrix<f64>,
    /// Condition number of the normal equations, columns scaled alike.
    pub(super) condition: f64,
    /// Influence of each reading on its own prediction, from 0 to 1.
    pub(super) leverage: Vec<f64>,
}

impl Spread {
    /// Returns the statistics of a design matrix, without the columns of parameters at bounds.
    pub(super) fn of(
        design: &DMatrix<f64>,
        left_out: &[bool],
        settings: &Settings,
    ) -> Result<Self, CalibrationError> {
        let count = design.ncols();
        let free: Vec<usize> = (0..count).filter(|&index| !left_out[index]).collect();
        let norms: Vec<f64> = free.iter().map(|&index| design.column(index).norm()).collect();
        if let Some(place) = norms.iter().position(|norm| *norm == 0.0) {
            return Err(CalibrationError::Untold(settings.parameters[free[place]]));
        }
        let scaled = DMatrix::from_fn(design.nrows(), free.len(), |row, column| {
            design[(row, free[column])] / norms[column]
        });
        let mut covariance = DMatrix::zeros(count, count);
        let mut leverage = vec![0.0; design.nrows()];
        let mut condition = 1.0;
        if !free.is_empty() {
            let svd = scaled.clone().svd(false, true);
            let Some(v_t) = svd.v_t else {
                return Err(CalibrationError::NotFitted(
                    "its design has no singular values".into(),
                ));
            };
            let largest = svd.singular_values.max();
            let floored = svd.singular_values.map(|value| value.max(SINGULAR * largest));
            condition = (largest / floored.min()).powi(2);
            let inverse = floored.map(|value| 1.0 / (value * value));
            let normal = v_t.transpose() * DMatrix::from_diagonal(&inverse) * &v_t;
            for (row, value) in leverage.iter_mut().enumerate() {
                let row: DVector<f64> = scaled.row(row).transpose();
                *value = (row.transpose() * &normal * &row)[0].clamp(0.0, 1.0);
            }
            for (a, &first) in free.iter().enumerate() {
                for (b, &second) in free.iter().enumerate() {
                    covariance[(first, second)] = normal[(a, b)] / (norms[a] * norms[b]);
                }
            }
        }
        Ok(Self { covariance, condition, leverage })
    }

    pub(super) fn standard_error(&self, index: usize) -> f64 {
        self.covariance[(index, index)].sqrt()
    }

    pub(super) fn correlation(&self, a: usize, b: usize) -> f64 {
        let both = self.standard_error(a) * self.standard_error(b);
        match (a == b, both > 0.0) {
            (true, _) => 1.0,
            (false, true) => (self.covariance[(a, b)] / both).clamp(-1.0, 1.0),
            (false, false) => 0.0,
        }
    }

    /// Returns the variance of a prediction from its derivatives.
    pub(super) fn variance(&self, slopes: &[f64]) -> f64 {
        let slopes = DVector::from_column_slice(slopes);
        (slopes.transpose() * &self.covariance * &slopes)[0].max(0.0)
    }
}
