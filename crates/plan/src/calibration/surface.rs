//! Predictions between the factors at which they were made.
//!
//! A hook load grows about exponentially with the friction factor, torque linearly: a polynomial
//! through few nodes reproduces both to a hundredth of the resolution of a weight, so that fits,
//! profiles and samples cost no further solutions. Its error is checked against the model at the
//! best fit.

use std::collections::{BTreeMap, BTreeSet};

use super::{Asked, CalibrationError, Loads, Motion, Parameter, Predict, Reading, Settings};

/// Number of nodes of a rotating string, whose loads are nearly linear.
const TURNING_NODES: usize = 3;

/// Maximum number of strings of a station: with many factors each has fewer nodes, and the box is
/// narrowed more often until that is enough.
const MOST_STRINGS: usize = 243;

/// A string at a depth in a motion, and the parameters that its friction depends on.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Station {
    pub(super) setup: usize,
    pub(super) bit_depth_m: f64,
    pub(super) motion: Motion,
    /// Indices of the parameters.
    pub(super) rubs_by: Vec<usize>,
}

impl Station {
    pub(super) fn new(
        model: &impl Predict,
        settings: &Settings,
        setup: usize,
        bit_depth_m: f64,
        motion: Motion,
    ) -> Self {
        let follows = settings.around_follows();
        let rubs = |parameter: &Parameter| {
            parameter.rubs(motion, follows)
                && parameter.part().is_none_or(|part| model.reaches(setup, bit_depth_m, part))
        };
        let parameters = settings.parameters.iter().enumerate();
        let rubs_by = parameters.filter(|(_, parameter)| rubs(parameter)).map(|(place, _)| place);
        Self { setup, bit_depth_m, motion, rubs_by: rubs_by.collect() }
    }

    /// Returns the number of nodes of each of its factors.
    fn nodes(&self, nodes: usize) -> usize {
        let most = if self.motion.turns() { nodes.min(TURNING_NODES) } else { nodes };
        let strings = |each: usize| each.pow(self.rubs_by.len() as u32);
        (2..=most).rev().find(|each| strings(*each) <= MOST_STRINGS).unwrap_or(2)
    }

    pub(super) fn asked(&self, settings: &Settings, values: &[f64]) -> Asked {
        Asked {
            setup: self.setup,
            bit_depth_m: self.bit_depth_m,
            motion: self.motion,
            factors: settings.state(values).factors,
        }
    }
}

/// Returns the distinct stations of readings, and the index of each reading's station.
pub(super) fn stations(
    model: &impl Predict,
    settings: &Settings,
    readings: &[Reading],
) -> (Vec<Station>, Vec<usize>) {
    let mut stations: Vec<Station> = Vec::new();
    let station_of = readings.iter().map(|reading| {
        let motion = reading.channel.motion();
        let same = |station: &Station| {
            station.setup == reading.setup
                && station.bit_depth_m == reading.bit_depth_m
                && station.motion == motion
        };
        stations.iter().position(same).unwrap_or_else(|| {
            let station = Station::new(model, settings, reading.setup, reading.bit_depth_m, motion);
            stations.push(station);
            stations.len() - 1
        })
    });
    let station_of = station_of.collect();
    (stations, station_of)
}

/// Loads and their derivatives with respect to the parameters that they depend on.
#[derive(Debug, Clone)]
pub(super) struct Sloped {
    pub(super) loads: [f64; 2],
    /// Derivatives by index of the parameter.
    pub(super) slopes: Vec<(usize, [f64; 2])>,
}

/// Predictions of stations over a box of the factors.
#[derive(Debug, Clone)]
pub(super) struct Surfaces {
    /// Range of each parameter.
    pub(super) span: Vec<[f64; 2]>,
    /// The different numbers of nodes of the stations.
    nodes: BTreeSet<usize>,
    /// Parameters and loads at the nodes, the first parameter's outermost.
    stations: Vec<(Vec<usize>, usize, Vec<[f64; 2]>)>,
}

/// Chebyshev's extrema between -1 and 1.
fn extrema(nodes: usize) -> Vec<f64> {
    let last = (nodes - 1) as f64;
    (0..nodes).map(|k| -libm::cos(std::f64::consts::PI * k as f64 / last)).collect()
}

/// Lagrange's polynomials of the nodes at a place, and their slopes.
fn lagrange(nodes: usize, at: f64) -> Vec<[f64; 2]> {
    let x = extrema(nodes);
    let others = |i: usize| (0..nodes).filter(move |&j| j != i);
    let polynomial = |i: usize| {
        let value = others(i).map(|j| (at - x[j]) / (x[i] - x[j])).product();
        let slope = others(i).map(|m| {
            let rest = others(i).filter(|&j| j != m).map(|j| (at - x[j]) / (x[i] - x[j]));
            rest.product::<f64>() / (x[i] - x[m])
        });
        [value, slope.sum()]
    };
    (0..nodes).map(polynomial).collect()
}

impl Surfaces {
    pub(super) fn new(
        model: &impl Predict,
        settings: &Settings,
        stations: &[Station],
        span: Vec<[f64; 2]>,
    ) -> Result<Self, CalibrationError> {
        let middle: Vec<f64> = span.iter().map(|[from, to]| 0.5 * (from + to)).collect();
        let mut requests = Vec::new();
        let mut counts = Vec::new();
        for station in stations {
            let each = station.nodes(settings.nodes);
            let x = extrema(each);
            let count = each.pow(station.rubs_by.len() as u32);
            for index in 0..count {
                let mut values = middle.clone();
                let mut rest = index;
                for &place in station.rubs_by.iter().rev() {
                    let [from, to] = span[place];
                    values[place] = from + 0.5 * (to - from) * (1.0 + x[rest % each]);
                    rest /= each;
                }
                requests.push(station.asked(settings, &values));
            }
            counts.push((each, count));
        }
        let nodes = counts.iter().map(|(each, _)| *each).collect();
        let mut loads = model.loads(&requests)?.into_iter();
        let stations = stations.iter().zip(counts).map(|(station, (each, count))| {
            let loads = loads.by_ref().take(count);
            let at_nodes = loads.map(|Loads { hook_load_N, torque_N_m }| [hook_load_N, torque_N_m]);
            (station.rubs_by.clone(), each, at_nodes.collect())
        });
        let stations = stations.collect();
        Ok(Self { span, nodes, stations })
    }

    /// Returns the loads of every station, and their derivatives.
    pub(super) fn at(&self, values: &[f64]) -> Vec<Sloped> {
        let bases = |nodes: usize| -> Vec<Vec<[f64; 2]>> {
            let at = |(&value, [from, to]): (&f64, &[f64; 2])| {
                let half = 0.5 * (to - from);
                let basis = lagrange(nodes, (value - from) / half - 1.0);
                basis.into_iter().map(|[value, slope]| [value, slope / half]).collect()
            };
            values.iter().zip(&self.span).map(at).collect()
        };
        let bases: BTreeMap<usize, _> =
            self.nodes.iter().map(|nodes| (*nodes, bases(*nodes))).collect();
        let station = |(places, each, loads): &(Vec<usize>, usize, Vec<[f64; 2]>)| {
            let bases: Vec<&Vec<[f64; 2]>> =
                places.iter().map(|&place| &bases[each][place]).collect();
            let mut sloped =
                Sloped { loads: [0.0; 2], slopes: places.iter().map(|&p| (p, [0.0; 2])).collect() };
            for (index, node_loads) in loads.iter().enumerate() {
                let mut rest = index;
                let mut digits = [0; Parameter::ALL.len()];
                for digit in digits[..places.len()].iter_mut().rev() {
                    *digit = rest % each;
                    rest /= each;
                }
                let factor = |along: Option<usize>| -> f64 {
                    let each = bases.iter().zip(&digits).enumerate();
                    each.map(|(place, (basis, &digit))| {
                        basis[digit][usize::from(along == Some(place))]
                    })
                    .product()
                };
                let value = factor(None);
                for (sum, load) in sloped.loads.iter_mut().zip(node_loads) {
                    *sum += value * load;
                }
                for (place, (_, slope)) in sloped.slopes.iter_mut().enumerate() {
                    let value = factor(Some(place));
                    for (sum, load) in slope.iter_mut().zip(node_loads) {
                        *sum += value * load;
                    }
                }
            }
            sloped
        };
        self.stations.iter().map(station).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_go_through_their_nodes_and_have_their_slopes() {
        for nodes in [2, 3, 7] {
            for (k, x) in extrema(nodes).into_iter().enumerate() {
                for (i, [value, _]) in lagrange(nodes, x).into_iter().enumerate() {
                    assert!((value - f64::from(u8::from(i == k))).abs() < 1e-12);
                }
            }
        }
        // x³ by four nodes: exactly, and 3 x².
        let cube: Vec<f64> = extrema(4).into_iter().map(|x| x.powi(3)).collect();
        let at = |part: usize| -> f64 {
            lagrange(4, 0.3).iter().zip(&cube).map(|(polynomial, x)| polynomial[part] * x).sum()
        };
        assert!((at(0) - 0.027).abs() < 1e-14 && (at(1) - 0.27).abs() < 1e-13);
    }
}
