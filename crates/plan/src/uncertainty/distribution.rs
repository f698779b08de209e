//! How an input is distributed.

use super::normal;

/// How an input is distributed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Distribution {
    /// Evenly between two values; a range of which nothing else is known.
    Uniform {
        /// Least value.
        from: f64,
        /// Largest value.
        to: f64,
    },
    /// Normally.
    Normal {
        /// Mean.
        mean: f64,
        /// Standard deviation.
        std: f64,
    },
    /// With a density that rises evenly to a value and falls evenly from it.
    Triangular {
        /// Least value.
        from: f64,
        /// Likeliest value.
        mode: f64,
        /// Largest value.
        to: f64,
    },
}

/// Why there is no such distribution.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum DistributionError {
    /// A number that is not finite.
    #[error("a number of the distribution is not finite")]
    NotFinite,
    /// The largest value is not above the least.
    #[error("it ends at {to}, which is not above {from}")]
    Empty {
        /// Least value.
        from: f64,
        /// Largest value.
        to: f64,
    },
    /// The likeliest value lies outside.
    #[error("its likeliest value {mode} lies outside {from} to {to}")]
    Mode {
        /// Least value.
        from: f64,
        /// Likeliest value.
        mode: f64,
        /// Largest value.
        to: f64,
    },
    /// The standard deviation is not above zero.
    #[error("its standard deviation {0} is not above zero")]
    Deviation(f64),
}

impl Distribution {
    /// The same, if there is such a thing.
    ///
    /// # Errors
    /// A number that is not finite, an empty range, a likeliest value outside, no deviation.
    pub fn checked(self) -> Result<Self, DistributionError> {
        let numbers = match self {
            Self::Uniform { from, to } => [from, to, to],
            Self::Normal { mean, std } => [mean, std, std],
            Self::Triangular { from, mode, to } => [from, mode, to],
        };
        if !numbers.iter().all(|number| number.is_finite()) {
            return Err(DistributionError::NotFinite);
        }
        match self {
            Self::Uniform { from, to } | Self::Triangular { from, to, .. } if to <= from => {
                Err(DistributionError::Empty { from, to })
            }
            Self::Triangular { from, mode, to } if !(from..=to).contains(&mode) => {
                Err(DistributionError::Mode { from, mode, to })
            }
            Self::Normal { std, .. } if std <= 0.0 => Err(DistributionError::Deviation(std)),
            sound => Ok(sound),
        }
    }

    /// The value below which a part of it lies; `part` is between 0 and 1, both excluded.
    pub fn quantile(&self, part: f64) -> f64 {
        match *self {
            Self::Uniform { from, to } => from + part * (to - from),
            Self::Normal { mean, std } => mean + std * normal::quantile(part),
            Self::Triangular { from, mode, to } => {
                let (rise, whole) = (mode - from, to - from);
                if part * whole < rise {
                    from + (part * whole * rise).sqrt()
                } else {
                    to - ((1.0 - part) * whole * (to - mode)).sqrt()
                }
            }
        }
    }

    /// Its mean.
    pub fn mean(&self) -> f64 {
        match *self {
            Self::Uniform { from, to } => 0.5 * (from + to),
            Self::Normal { mean, .. } => mean,
            Self::Triangular { from, mode, to } => (from + mode + to) / 3.0,
        }
    }

    /// Its variance.
    pub fn variance(&self) -> f64 {
        match *self {
            Self::Uniform { from, to } => (to - from).powi(2) / 12.0,
            Self::Normal { std, .. } => std * std,
            Self::Triangular { from, mode, to } => {
                let squares = from * from + mode * mode + to * to;
                (squares - from * mode - from * to - mode * to) / 18.0
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Mean and variance of many quantiles in the middles of equal parts.
    #[test]
    fn quantiles_have_mean_and_variance() {
        for of in [
            Distribution::Uniform { from: -1.0, to: 4.0 },
            Distribution::Normal { mean: 3.0, std: 0.5 },
            Distribution::Triangular { from: 0.1, mode: 0.2, to: 0.6 },
            Distribution::Triangular { from: 0.0, mode: 0.0, to: 1.0 },
        ] {
            let count = 100_000;
            let quantiles =
                (0..count).map(|index| of.quantile((index as f64 + 0.5) / count as f64));
            let (sum, squares) = quantiles.fold((0.0, 0.0), |(sum, squares), value| {
                (sum + value, squares + (value - of.mean()).powi(2))
            });
            assert!((sum / count as f64 - of.mean()).abs() < 1e-5, "{of:?}");
            let variance = squares / count as f64;
            assert!((variance / of.variance() - 1.0).abs() < 2e-4, "{of:?} {variance}");
            assert_eq!(of.checked(), Ok(of));
        }
    }

    #[test]
    fn what_is_no_distribution_is_refused() {
        use DistributionError::{Deviation, Empty, Mode, NotFinite};
        for (of, error) in [
            (Distribution::Uniform { from: 1.0, to: 1.0 }, Empty { from: 1.0, to: 1.0 }),
            (Distribution::Uniform { from: 1.0, to: f64::NAN }, NotFinite),
            (Distribution::Normal { mean: 0.0, std: 0.0 }, Deviation(0.0)),
            (
                Distribution::Triangular { from: 0.0, mode: 2.0, to: 1.0 },
                Mode { from: 0.0, mode: 2.0, to: 1.0 },
            ),
        ] {
            assert_eq!(of.checked(), Err(error));
        }
    }
}
