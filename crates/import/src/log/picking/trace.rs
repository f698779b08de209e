//! A log reduced for drawing to its smallest and largest values.

use super::row::Row;

/// A channel of a drawn log.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Channel {
    /// Height of the block, m.
    Block,
    /// Measured depth of the bit, m.
    BitDepth,
    /// Hook load as it was logged, N.
    HookLoad,
    /// Torque, N·m.
    Torque,
    /// Rotary speed, rad/s.
    Rotary,
}

/// Number of channels of a trace.
const CHANNELS: usize = 5;

/// Consecutive rows of a log, with the smallest and largest value of each channel.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Bucket {
    from_s: f64,
    to_s: f64,
    ends: [[f32; 2]; CHANNELS],
}

/// A log reduced for drawing: consecutive rows are combined so that every peak remains and the size
/// is bounded.
#[derive(Debug, Clone, PartialEq)]
pub struct Trace {
    buckets: Vec<Bucket>,
    /// Maximum number of buckets.
    most: usize,
    /// Number of rows of a bucket.
    size: usize,
    /// Number of rows in the last bucket.
    filled: usize,
}

impl Trace {
    /// Returns an empty trace of at most this many points.
    pub(super) fn new(most: usize) -> Self {
        Self { buckets: Vec::new(), most: most.max(2), size: 1, filled: 0 }
    }

    pub(super) fn push(&mut self, row: &Row) {
        let values =
            [row.block_m, row.bit_depth_m, row.hook_load_N, row.torque_N_m, row.rotary_rad_per_s];
        let own = Bucket {
            from_s: row.time_s,
            to_s: row.time_s,
            ends: values.map(|value| [value as f32; 2]),
        };
        match self.buckets.last_mut() {
            Some(last) if self.filled < self.size => last.join(&own),
            _ => {
                if self.buckets.len() == self.most {
                    self.halve();
                }
                self.buckets.push(own);
                self.filled = 0;
            }
        }
        self.filled += 1;
    }

    fn halve(&mut self) {
        let pairs = self.buckets.chunks(2).map(|pair| {
            let mut joined = pair[0];
            pair[1..].iter().for_each(|other| joined.join(other));
            joined
        });
        self.buckets = pairs.collect();
        self.size *= 2;
    }

    /// Times and values of a channel, s and SI, in order: the smallest and the largest value of
    /// each bucket.
    pub fn points(&self, channel: Channel) -> Vec<(f64, f64)> {
        let index = channel as usize;
        let ends = self.buckets.iter().flat_map(|bucket| {
            let [low, high] = bucket.ends[index].map(f64::from);
            [(bucket.from_s, low), (0.5 * (bucket.from_s + bucket.to_s), high)]
        });
        let mut points: Vec<(f64, f64)> = ends.collect();
        points.dedup();
        points
    }
}

impl Bucket {
    fn join(&mut self, other: &Bucket) {
        self.to_s = other.to_s;
        for (own, other) in self.ends.iter_mut().zip(&other.ends) {
            // Of a number and NaN, the number remains.
            *own = [own[0].min(other[0]), own[1].max(other[1])];
        }
    }
}
