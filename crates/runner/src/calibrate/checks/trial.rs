//! Predicted readings with one friction factor everywhere, from zero to more than in any hole.

use wholestring_plan::calibration::{
    Asked, CalibrationError, Channel, Factors, Motion, Parameter, Predict, Settings,
};

use super::{super::search::Predictions, text::median};
use crate::{cancellation::CancellationToken, error::Error, observer::Silent, readings::Readings};

/// Friction factors with which the strings are solved.
const NODES: [f64; 5] = [0.0, 0.15, 0.3, 0.45, 0.6];

/// The largest friction factor.
pub(super) const MOST: f64 = NODES[NODES.len() - 1];

/// Number of steps between no friction and the largest.
const STEPS: usize = 24;

/// The block in the weights.
#[derive(Debug, Clone, Copy)]
pub(super) enum Block {
    /// Weight from the case, N.
    Held(f64),
    /// Best fit, not negative.
    Free,
    /// Best fit, may be negative.
    Any,
}

impl Block {
    /// The quantities that a comparison with the string leaves open, in words.
    pub(super) const fn left_open(self) -> &'static str {
        match self {
            Self::Held(_) => "any friction",
            Self::Free | Self::Any => "any friction and any weight of the block",
        }
    }
}

/// Misfit of the weights.
#[derive(Debug, Clone, Copy)]
pub(super) struct Misfit {
    /// Median deviation over the median weight.
    pub(super) part: f64,
    pub(super) friction: f64,
    pub(super) block_N: f64,
}

/// Loads of every reading at each friction factor.
pub(super) struct Trial {
    /// Weights, N, without the block; torques, N·m, without the torque on bit.
    loads: Vec<[f64; NODES.len()]>,
    /// Hook loads without friction, N.
    pub(super) weights_N: Vec<f64>,
    /// The block as in the fit.
    pub(super) block: Block,
    /// Torque on bit, N·m; `None` if it is fitted.
    pub(super) bit_torque_N_m: Option<f64>,
}

impl Trial {
    /// Solves the strings; `None` if one of them has no solution.
    pub(super) fn of(
        data: &Readings,
        settings: &Settings,
        cancellation: &CancellationToken,
    ) -> Result<Option<Self>, Error> {
        let mut stations: Vec<(usize, f64, Motion)> = Vec::new();
        let place = data.readings.iter().map(|reading| {
            let station = (reading.setup, reading.bit_depth_m, reading.channel.motion());
            stations.iter().position(|known| *known == station).unwrap_or_else(|| {
                stations.push(station);
                stations.len() - 1
            })
        });
        let place: Vec<usize> = place.collect();
        let requests = stations.iter().flat_map(|&(setup, bit_depth_m, motion)| {
            NODES.map(|friction| Asked {
                setup,
                bit_depth_m,
                motion,
                factors: Factors::of_walls(friction, friction),
            })
        });
        let requests: Vec<Asked> = requests.collect();
        let model = Predictions {
            assemblies: &data.assemblies,
            stiff: None,
            cancellation,
            observer: &Silent,
        };
        let loads = match model.loads(&requests) {
            Ok(loads) => loads,
            Err(CalibrationError::Interrupted) => return Err(Error::Interrupted),
            Err(_) => return Ok(None),
        };
        let of_reading = |(reading, place): (&wholestring_plan::calibration::Reading, &usize)| {
            let own = &loads[place * NODES.len()..];
            let is_torque = reading.channel.is_torque();
            std::array::from_fn(|k| if is_torque { own[k].torque_N_m } else { own[k].hook_load_N })
        };
        let looked_for = |parameter: Parameter| settings.parameters.contains(&parameter);
        Ok(Some(Self {
            loads: data.readings.iter().zip(&place).map(of_reading).collect(),
            weights_N: place.iter().map(|place| loads[place * NODES.len()].hook_load_N).collect(),
            block: match looked_for(Parameter::BlockWeight) {
                true => Block::Free,
                false => Block::Held(settings.held.block_weight_N),
            },
            bit_torque_N_m: (!looked_for(Parameter::BitTorque))
                .then_some(settings.held.bit_torque_N_m),
        }))
    }

    /// Load of a reading at a friction factor, interpolated linearly between solved factors.
    pub(super) fn load(&self, row: usize, friction: f64) -> f64 {
        let loads = &self.loads[row];
        let at = (friction / MOST * (NODES.len() - 1) as f64).clamp(0.0, (NODES.len() - 1) as f64);
        let low = (at.floor() as usize).min(NODES.len() - 2);
        loads[low] + (loads[low + 1] - loads[low]) * (at - low as f64)
    }

    /// Misfit of the weights of some rows when multiplied by a factor, at the best friction factor.
    pub(super) fn misfit(
        &self,
        data: &Readings,
        rows: &[usize],
        factor: f64,
        block: Block,
    ) -> Misfit {
        let value = |row: usize| factor * data.readings[row].value;
        let size = median(rows.iter().map(|&row| value(row).abs()).collect()).max(1e-9);
        let misfit = |step: usize| {
            let friction = MOST * step as f64 / STEPS as f64;
            let off: Vec<f64> =
                rows.iter().map(|&row| value(row) - self.load(row, friction)).collect();
            let block_N = match block {
                Block::Held(block_N) => block_N,
                Block::Free => median(off.clone()).max(0.0),
                Block::Any => median(off.clone()),
            };
            let part = median(off.iter().map(|off| (off - block_N).abs()).collect()) / size;
            Misfit { part, friction, block_N }
        };
        let all = (0..=STEPS).map(misfit);
        all.min_by(|a, b| a.part.total_cmp(&b.part)).unwrap_or(Misfit {
            part: f64::INFINITY,
            friction: 0.0,
            block_N: 0.0,
        })
    }
}

/// Weights of the block by kind of weight, with the friction that suits them best.
#[derive(Debug, Clone)]
pub(super) struct Apart {
    /// Median deviation over the median weight.
    pub(super) part: f64,
    /// Kinds of weights, and the block in each, N.
    pub(super) blocks_N: Vec<(Channel, f64)>,
}

impl Trial {
    /// Misfit of the weights where the block may differ between pick-up, slack-off and rotating
    /// weights.
    pub(super) fn misfit_apart(&self, data: &Readings) -> Apart {
        let all = weight_rows(data);
        let size = median(all.iter().map(|&row| data.readings[row].value.abs()).collect());
        let channels = [Channel::PickUp, Channel::SlackOff, Channel::Rotating];
        let misfit = |step: usize| {
            let friction = MOST * step as f64 / STEPS as f64;
            let (mut blocks_N, mut deviations) = (Vec::new(), Vec::new());
            for channel in channels {
                let own = rows(data, |other| other == channel);
                if own.is_empty() {
                    continue;
                }
                let off =
                    own.iter().map(|&row| data.readings[row].value - self.load(row, friction));
                let off: Vec<f64> = off.collect();
                let block_N = median(off.clone());
                deviations.extend(off.iter().map(|off| (off - block_N).abs()));
                blocks_N.push((channel, block_N));
            }
            Apart { part: median(deviations) / size.max(1e-9), blocks_N }
        };
        let all = (0..=STEPS).map(misfit);
        all.min_by(|a, b| a.part.total_cmp(&b.part))
            .unwrap_or(Apart { part: f64::INFINITY, blocks_N: Vec::new() })
    }
}

/// Rows with readings of these channels.
pub(super) fn rows(data: &Readings, is: impl Fn(Channel) -> bool) -> Vec<usize> {
    (0..data.readings.len()).filter(|&row| is(data.readings[row].channel)).collect()
}

/// Rows of weights.
pub(super) fn weight_rows(data: &Readings) -> Vec<usize> {
    rows(data, |channel| !channel.is_torque())
}
