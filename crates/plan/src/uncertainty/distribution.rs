//! Distributions of an input.

use super::normal;

/// Distribution of an input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Distribution {
    /// Uniform between two values; for a range without further information.
    Uniform {
        /// Least value.
        from: f64,
        /// Largest value.
        to: f64,
    },
    /// Normal.
    Normal {
        /// Mean.
        mean: f64,
        /// Standard deviation.
        std: f64,
    },
    /// Triangular: a density that rises linearly to a value and falls linearly from it.
    Triangular {
        /// Least value.
        from: f64,
        /// Likeliest value.
        mode: f64,
        /// Largest value.
        to: f64,
    },
    /// Normal, truncated at two values, of which one may be infinite.
    TruncatedNormal {
        /// Mean of the whole normal distribution.
        mean: f64,
        /// Its standard deviation.
        std: f64,
        /// Least value.
        from: f64,
        /// Largest value.
        to: f64,
    },
    /// Log-normal.
    LogNormal {
        /// Median: half of the values are below it.
        median: f64,
        /// Geometric standard deviation: about two thirds of the values are between the median
        /// divided by this and the median times this.
        factor: f64,
    },
    /// A choice among equally likely values, by index from zero. The indices need not be an order.
    Choice {
        /// Number of values.
        count: usize,
    },
}

/// The reason why there is no such distribution.
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
    /// The likeliest value is outside the range.
    #[error("its likeliest value {mode} is outside {from} to {to}")]
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
    /// Hardly any of a normal distribution is within its limits.
    #[error("hardly any of it is within its limits")]
    CutAway {
        /// Least value.
        from: f64,
        /// Largest value.
        to: f64,
    },
    /// The median of a log-normal distribution is not above zero.
    #[error("its median {0} is not above zero")]
    Median(f64),
    /// A geometric standard deviation that is not above one.
    #[error("its factor {0} is not above one")]
    Factor(f64),
    /// A choice among fewer than two values.
    #[error("it has fewer than two values")]
    NoChoice,
}

/// Least part of a normal distribution within its limits: quantiles of a smaller part would be
/// rounding errors.
const NOTHING: f64 = 1e-9;

impl Distribution {
    /// Returns the distribution if it is valid.
    ///
    /// # Errors
    /// A number that is not finite, an empty range, a likeliest value outside, no deviation, a
    /// normal distribution with hardly any part within its limits, a log-normal one that is not
    /// above zero, no choice.
    pub fn checked(self) -> Result<Self, DistributionError> {
        let numbers = match self {
            Self::Uniform { from, to } => [from, to, to],
            Self::Normal { mean, std } => [mean, std, std],
            Self::Triangular { from, mode, to } => [from, mode, to],
            // One of its ends may be infinite, but neither is NaN.
            Self::TruncatedNormal { mean, std, from, to } => {
                [mean, std, if from.is_nan() || to.is_nan() { f64::NAN } else { 0.0 }]
            }
            Self::LogNormal { median, factor } => [median, factor, factor],
            Self::Choice { count } => [count as f64; 3],
        };
        if !numbers.iter().all(|number| number.is_finite()) {
            return Err(DistributionError::NotFinite);
        }
        match self {
            Self::Uniform { from, to }
            | Self::Triangular { from, to, .. }
            | Self::TruncatedNormal { from, to, .. }
                if to <= from =>
            {
                Err(DistributionError::Empty { from, to })
            }
            Self::Triangular { from, mode, to } if !(from..=to).contains(&mode) => {
                Err(DistributionError::Mode { from, mode, to })
            }
            Self::Normal { std, .. } | Self::TruncatedNormal { std, .. } if std <= 0.0 => {
                Err(DistributionError::Deviation(std))
            }
            Self::TruncatedNormal { from, to, .. } if self.kept() < NOTHING => {
                Err(DistributionError::CutAway { from, to })
            }
            Self::LogNormal { median, .. } if median <= 0.0 => {
                Err(DistributionError::Median(median))
            }
            Self::LogNormal { factor, .. } if factor <= 1.0 => {
                Err(DistributionError::Factor(factor))
            }
            Self::Choice { count } if count < 2 => Err(DistributionError::NoChoice),
            sound => Ok(sound),
        }
    }

    /// Returns the ends of a truncated normal distribution in standard deviations from its mean.
    fn cut(&self) -> [f64; 2] {
        match *self {
            Self::TruncatedNormal { mean, std, from, to } => {
                [from, to].map(|end| (end - mean) / std)
            }
            _ => [f64::NEG_INFINITY, f64::INFINITY],
        }
    }

    /// Returns the part of the normal distribution within its limits.
    fn kept(&self) -> f64 {
        let [a, b] = self.cut();
        normal::between(a, b)
    }

    /// Returns the part of the distribution below a value.
    pub(super) fn below(&self, value: f64) -> f64 {
        match *self {
            Self::Uniform { from, to } => (value - from) / (to - from),
            Self::Normal { mean, std } => normal::below((value - mean) / std),
            Self::Triangular { from, mode, to } => {
                let whole = to - from;
                match value < mode {
                    true => (value - from).powi(2) / (whole * (mode - from)),
                    false => {
                        1.0 - (to - value).powi(2) / (whole * (to - mode).max(f64::MIN_POSITIVE))
                    }
                }
            }
            Self::TruncatedNormal { mean, std, .. } => {
                normal::between(self.cut()[0], (value - mean) / std) / self.kept()
            }
            Self::LogNormal { median, factor } => {
                normal::below(libm::log(value / median) / libm::log(factor))
            }
            Self::Choice { count } => (value + 0.5) / count as f64,
        }
    }

    /// Returns the value below which a part of the distribution lies; `part` is between 0 and 1,
    /// both excluded.
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
            Self::TruncatedNormal { mean, std, from, to } => {
                let [a, b] = self.cut();
                (mean + std * normal::quantile_between(a, b, part)).clamp(from, to)
            }
            Self::LogNormal { median, factor } => {
                median * libm::exp(libm::log(factor) * normal::quantile(part))
            }
            Self::Choice { count } => (part * count as f64).floor().min(count as f64 - 1.0),
        }
    }

    /// Returns the mean.
    pub fn mean(&self) -> f64 {
        match *self {
            Self::Uniform { from, to } => 0.5 * (from + to),
            Self::Normal { mean, .. } => mean,
            Self::Triangular { from, mode, to } => (from + mode + to) / 3.0,
            Self::TruncatedNormal { mean, std, .. } => {
                let [a, b] = self.cut().map(normal::density);
                mean + std * (a - b) / self.kept()
            }
            Self::LogNormal { median, factor } => {
                median * libm::exp(0.5 * libm::log(factor).powi(2))
            }
            Self::Choice { count } => 0.5 * (count as f64 - 1.0),
        }
    }

    /// Returns the variance.
    pub fn variance(&self) -> f64 {
        match *self {
            Self::Uniform { from, to } => (to - from).powi(2) / 12.0,
            Self::Normal { std, .. } => std * std,
            Self::Triangular { from, mode, to } => {
                let squares = from * from + mode * mode + to * to;
                (squares - from * mode - from * to - mode * to) / 18.0
            }
            Self::TruncatedNormal { std, .. } => {
                let ends = self.cut();
                let [a, b] = ends.map(normal::density);
                // An infinite end contributes nothing.
                let [za, zb] =
                    ends.map(|z| if z.is_finite() { z * normal::density(z) } else { 0.0 });
                let inside = self.kept();
                std * std * (1.0 + (za - zb) / inside - ((a - b) / inside).powi(2))
            }
            Self::LogNormal { median, factor } => {
                let square = libm::log(factor).powi(2);
                median * median * libm::exp(square) * libm::expm1(square)
            }
            Self::Choice { count } => ((count * count) as f64 - 1.0) / 12.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Mean and variance of many quantiles in the middles of equal parts.
    #[test]
    fn quantiles_have_mean_and_variance() {
        for distribution in [
            Distribution::Uniform { from: -1.0, to: 4.0 },
            Distribution::Normal { mean: 3.0, std: 0.5 },
            Distribution::Triangular { from: 0.1, mode: 0.2, to: 0.6 },
            Distribution::Triangular { from: 0.0, mode: 0.0, to: 1.0 },
            Distribution::TruncatedNormal { mean: 0.3, std: 0.1, from: 0.1, to: 0.4 },
            Distribution::TruncatedNormal { mean: 0.3, std: 0.1, from: 0.5, to: f64::INFINITY },
            Distribution::LogNormal { median: 2.0, factor: 1.2 },
            Distribution::Choice { count: 5 },
        ] {
            let count = 100_000;
            let quantiles =
                (0..count).map(|index| distribution.quantile((index as f64 + 0.5) / count as f64));
            let (sum, squares) = quantiles.fold((0.0, 0.0), |(sum, squares), value| {
                (sum + value, squares + (value - distribution.mean()).powi(2))
            });
            assert!((sum / count as f64 - distribution.mean()).abs() < 1e-5, "{distribution:?}");
            let variance = squares / count as f64;
            assert!(
                (variance / distribution.variance() - 1.0).abs() < 3e-4,
                "{distribution:?} {variance}"
            );
            assert_eq!(distribution.checked(), Ok(distribution));
            for part in [0.001, 0.3, 0.5, 0.9, 0.999] {
                let below = distribution.below(distribution.quantile(part));
                let width = if let Distribution::Choice { count } = distribution {
                    count as f64
                } else {
                    1e12
                };
                assert!(
                    (below - part).abs() <= 0.5 / width + 1e-12,
                    "{distribution:?} {part} {below}"
                );
            }
        }
    }

    #[test]
    fn what_is_no_distribution_is_refused() {
        use DistributionError::{
            CutAway, Deviation, Empty, Factor, Median, Mode, NoChoice, NotFinite,
        };
        for (distribution, error) in [
            (
                Distribution::TruncatedNormal { mean: 0.0, std: 1.0, from: 9.0, to: 10.0 },
                CutAway { from: 9.0, to: 10.0 },
            ),
            (
                Distribution::TruncatedNormal { mean: 0.0, std: -1.0, from: 0.0, to: 1.0 },
                Deviation(-1.0),
            ),
            (Distribution::LogNormal { median: 0.0, factor: 1.2 }, Median(0.0)),
            (Distribution::LogNormal { median: 1.0, factor: 1.0 }, Factor(1.0)),
            (Distribution::Choice { count: 1 }, NoChoice),
            (Distribution::Uniform { from: 1.0, to: 1.0 }, Empty { from: 1.0, to: 1.0 }),
            (Distribution::Uniform { from: 1.0, to: f64::NAN }, NotFinite),
            (Distribution::Normal { mean: 0.0, std: 0.0 }, Deviation(0.0)),
            (
                Distribution::Triangular { from: 0.0, mode: 2.0, to: 1.0 },
                Mode { from: 0.0, mode: 2.0, to: 1.0 },
            ),
        ] {
            assert_eq!(distribution.checked(), Err(error));
        }
    }
}
