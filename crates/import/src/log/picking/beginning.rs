//! Properties of a log derived from its beginning.

use super::{
    estimate::{median, quantile, spread},
    row::Row,
};

/// Hook load while the string hangs in slips, from the remaining weight on the hook.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Level {
    pub(super) median_N: f64,
    pub(super) spread_N: f64,
}

/// Properties of a log derived from its beginning.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Beginning {
    /// Time between two rows, s.
    pub(super) step_s: f64,
    /// Level in slips; `None` if the log does not show it.
    pub(super) slips: Option<Level>,
    /// Hook load exceeded by one row in twenty, N.
    pub(super) heavy_N: f64,
    /// Torque below which a string without a rotary speed sensor is taken as not turning, N·m;
    /// `None` without torque.
    pub(super) idle_torque_N_m: Option<f64>,
    pub(super) has: Channels,
    /// Whether any channel shows that the bit is off bottom.
    pub(super) tells_bottom: bool,
}

/// Channels with values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Channels {
    pub(super) time: bool,
    pub(super) bit_depth: bool,
    pub(super) hole_depth: bool,
    pub(super) block: bool,
    pub(super) hook_load: bool,
    pub(super) torque: bool,
    pub(super) rotary: bool,
}

/// Minimum number of rows that determine the level in slips.
const ROWS: usize = 20;

/// Fraction of the torque exceeded by one row in twenty above which a string turns.
const IDLE: f64 = 0.1;

impl Beginning {
    pub(super) fn of(rows: &[Row]) -> Self {
        let has = |value: fn(&Row) -> f64| rows.iter().any(|row| value(row).is_finite());
        let all = |value: fn(&Row) -> f64| rows.iter().map(value).collect::<Vec<f64>>();
        let steps = rows.windows(2).map(|pair| pair[1].time_s - pair[0].time_s);
        let heavy_N = quantile(&mut all(|row| row.hook_load_N), 0.95).unwrap_or(f64::NAN);
        let torque = quantile(&mut all(|row| row.torque_N_m), 0.95);
        let block = has(|row| row.block_m);
        Self {
            step_s: median(&mut steps.collect()).unwrap_or(f64::NAN),
            slips: still_bit(rows, heavy_N).or_else(|| lowest_peak(rows)),
            heavy_N,
            idle_torque_N_m: torque.map(|torque| IDLE * torque),
            tells_bottom: true,
            has: Channels {
                time: has(|row| row.time_s),
                bit_depth: has(|row| row.bit_depth_m),
                hole_depth: has(|row| row.hole_depth_m),
                block,
                hook_load: has(|row| row.hook_load_N),
                torque: has(|row| row.torque_N_m),
                rotary: has(|row| row.rotary_rad_per_s),
            },
        }
    }
}

/// Returns the hook load while the block moves and the bit does not.
fn still_bit(rows: &[Row], heavy_N: f64) -> Option<Level> {
    /// Time over which a motion is visible through the noise, s.
    const OVER_S: f64 = 4.0;
    /// 3 m/min.
    const MOVES_M_PER_S: f64 = 0.05;
    /// Maximum travel of the bit, over that of the block, at which the bit is stationary.
    const STANDS: f64 = 0.1;
    let mut loads = Vec::new();
    let mut last = 0;
    for (first, row) in rows.iter().enumerate() {
        while last < rows.len() && rows[last].time_s - row.time_s < OVER_S {
            last += 1;
        }
        let Some(after) = rows.get(last) else { break };
        let span_s = after.time_s - row.time_s;
        let way_m = (after.block_m - row.block_m).abs();
        let bit_m = (after.bit_depth_m - row.bit_depth_m).abs();
        if span_s < 10.0 * OVER_S && way_m > MOVES_M_PER_S * span_s && bit_m < STANDS * way_m {
            loads.push(rows[usize::midpoint(first, last)].hook_load_N);
        }
    }
    loads.retain(|load| load.is_finite());
    let median_N = median(&mut loads)?;
    let spread_N = spread(&loads, median_N);
    let is_clear = loads.len() >= ROWS && spread_N < 0.1 * (heavy_N - median_N);
    is_clear.then_some(Level { median_N, spread_N })
}

/// Returns the lowest peak of the hook loads that a valley separates from the others.
fn lowest_peak(rows: &[Row]) -> Option<Level> {
    const BINS: usize = 200;
    /// Minimum fraction of the rows in a peak.
    const PEAK: f64 = 0.02;
    /// Height of the valley over that of the peak.
    const VALLEY: f64 = 0.2;
    let mut loads: Vec<f64> = rows.iter().map(|row| row.hook_load_N).collect();
    let low_N = quantile(&mut loads, 0.001)?;
    let high_N = quantile(&mut loads, 0.999)?;
    if high_N <= low_N {
        return None;
    }
    let bin_of = |load: f64| ((load - low_N) / (high_N - low_N) * BINS as f64) as usize;
    let mut bins = vec![0usize; BINS + 1];
    for &load in &loads {
        bins[bin_of(load).min(BINS)] += 1;
    }
    // Each bin with its neighbours, over which a peak is spread.
    let near = |bin: usize| bins[bin.saturating_sub(1)..(bin + 2).min(BINS)].iter().sum::<usize>();
    let least = ((PEAK * loads.len() as f64) as usize).max(ROWS);
    let first = (0..BINS).find(|&bin| near(bin) >= least)?;
    let end = (first..BINS).find(|&bin| near(bin) < near(first))?;
    let peak = (first..=end).max_by_key(|&bin| near(bin))?;
    let valley = (peak..BINS).find(|&bin| (near(bin) as f64) < VALLEY * near(peak) as f64)?;
    let above = (valley..BINS).any(|bin| near(bin) >= least);
    if !above {
        return None;
    }
    loads.retain(|&load| bin_of(load) < valley);
    let median_N = median(&mut loads)?;
    Some(Level { median_N, spread_N: spread(&loads, median_N) })
}
