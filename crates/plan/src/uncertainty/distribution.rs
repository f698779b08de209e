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
    /// Normally, but for what lies outside of two values, of which one may be infinite.
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
    /// Its logarithm normally.
    LogNormal {
        /// Half of it lies below.
        median: f64,
        /// Geometric standard deviation: about two thirds of it lie between the median divided by this
        /// and the median times this.
        factor: f64,
    },
    /// One of so many things that are equally likely, by its number from zero. Their numbers need not be
    /// an order.
    Choice {
        /// How many there are.
        count: usize,
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
    /// Next to nothing of a normal distribution lies where it is cut to.
    #[error("next to nothing of it lies where it is kept")]
    CutAway {
        /// Least value.
        from: f64,
        /// Largest value.
        to: f64,
    },
    /// The median of a logarithmic one is not above zero.
    #[error("its median {0} is not above zero")]
    Median(f64),
    /// A geometric standard deviation that is not above one.
    #[error("its factor {0} is not above one")]
    Factor(f64),
    /// Fewer than two things to choose from.
    #[error("it has fewer than two values")]
    NoChoice,
}

/// Less than this part of a normal distribution is nothing: quantiles of what is left would be rounding.
const NOTHING: f64 = 1e-9;

impl Distribution {
    /// The same, if there is such a thing.
    ///
    /// # Errors
    /// A number that is not finite, an empty range, a likeliest value outside, no deviation, a normal
    /// distribution of which nothing is left, a logarithmic one that is not above zero, no choice.
    pub fn checked(self) -> Result<Self, DistributionError> {
        let numbers = match self {
            Self::Uniform { from, to } => [from, to, to],
            Self::Normal { mean, std } => [mean, std, std],
            Self::Triangular { from, mode, to } => [from, mode, to],
            // One of its ends may be infinite, but none is not a number.
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

    /// Ends of a truncated normal distribution in standard deviations from its mean.
    fn cut(&self) -> [f64; 2] {
        match *self {
            Self::TruncatedNormal { mean, std, from, to } => {
                [from, to].map(|end| (end - mean) / std)
            }
            _ => [f64::NEG_INFINITY, f64::INFINITY],
        }
    }

    /// What part of the normal distribution a truncated one is.
    fn kept(&self) -> f64 {
        let [a, b] = self.cut();
        normal::between(a, b)
    }

    /// The part of it that lies below a value.
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

    /// Its mean.
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

    /// Its variance.
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
                // Of an end that is infinite, nothing.
                let [za, zb] =
                    ends.map(|z| if z.is_finite() { z * normal::density(z) } else { 0.0 });
                let kept = self.kept();
                std * std * (1.0 + (za - zb) / kept - ((a - b) / kept).powi(2))
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
        for of in [
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
                (0..count).map(|index| of.quantile((index as f64 + 0.5) / count as f64));
            let (sum, squares) = quantiles.fold((0.0, 0.0), |(sum, squares), value| {
                (sum + value, squares + (value - of.mean()).powi(2))
            });
            assert!((sum / count as f64 - of.mean()).abs() < 1e-5, "{of:?}");
            let variance = squares / count as f64;
            assert!((variance / of.variance() - 1.0).abs() < 3e-4, "{of:?} {variance}");
            assert_eq!(of.checked(), Ok(of));
            for part in [0.001, 0.3, 0.5, 0.9, 0.999] {
                let below = of.below(of.quantile(part));
                let width =
                    if let Distribution::Choice { count } = of { count as f64 } else { 1e12 };
                assert!((below - part).abs() <= 0.5 / width + 1e-12, "{of:?} {part} {below}");
            }
        }
    }

    #[test]
    fn what_is_no_distribution_is_refused() {
        use DistributionError::{
            CutAway, Deviation, Empty, Factor, Median, Mode, NoChoice, NotFinite,
        };
        for (of, error) in [
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
            assert_eq!(of.checked(), Err(error));
        }
    }
}
