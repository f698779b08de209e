//! Samples of a scalar that may be stored on a disk, and are read in their order as often as
//! needed.

use std::ops::Range;

/// Samples of a scalar in their order.
pub trait Samples {
    /// Number of samples.
    fn count(&self) -> usize;

    /// Calls `take` with all samples, stretch after stretch.
    fn each(&self, take: &mut dyn FnMut(&[f64]));
}

impl Samples for [f64] {
    fn count(&self) -> usize {
        self.len()
    }

    fn each(&self, take: &mut dyn FnMut(&[f64])) {
        take(self);
    }
}

impl<const N: usize> Samples for [f64; N] {
    fn count(&self) -> usize {
        N
    }

    fn each(&self, take: &mut dyn FnMut(&[f64])) {
        take(self);
    }
}

impl Samples for Vec<f64> {
    fn count(&self) -> usize {
        self.len()
    }

    fn each(&self, take: &mut dyn FnMut(&[f64])) {
        take(self);
    }
}

impl<S: Samples + ?Sized> Samples for &S {
    fn count(&self) -> usize {
        (**self).count()
    }

    fn each(&self, take: &mut dyn FnMut(&[f64])) {
        (**self).each(take);
    }
}

/// Some of the samples.
pub(crate) struct Part<'a, S: ?Sized> {
    pub(crate) samples: &'a S,
    pub(crate) rows: Range<usize>,
}

impl<S: Samples + ?Sized> Samples for Part<'_, S> {
    fn count(&self) -> usize {
        self.rows.len()
    }

    fn each(&self, take: &mut dyn FnMut(&[f64])) {
        let mut first = 0;
        self.samples.each(&mut |values| {
            let within = |row: usize| row.clamp(first, first + values.len()) - first;
            let part = &values[within(self.rows.start)..within(self.rows.end)];
            if !part.is_empty() {
                take(part);
            }
            first += values.len();
        });
    }
}

/// Values computed one by one from the samples and their places.
pub(crate) struct Mapped<'a, S: ?Sized, F> {
    pub(crate) samples: &'a S,
    pub(crate) value: F,
}

/// Values that are computed at once.
const AT_ONCE: usize = 1024;

impl<S: Samples + ?Sized, F: Fn(usize, f64) -> f64> Samples for Mapped<'_, S, F> {
    fn count(&self) -> usize {
        self.samples.count()
    }

    fn each(&self, take: &mut dyn FnMut(&[f64])) {
        let mut place = 0;
        let mut mapped = [0.0; AT_ONCE];
        self.samples.each(&mut |values| {
            for values in values.chunks(AT_ONCE) {
                for (value, mapped) in values.iter().zip(&mut mapped) {
                    *mapped = (self.value)(place, *value);
                    place += 1;
                }
                take(&mapped[..values.len()]);
            }
        });
    }
}

/// The sum of `term` over each sample and its place, in their order.
pub fn sum(samples: &(impl Samples + ?Sized), mut term: impl FnMut(usize, f64) -> f64) -> f64 {
    let (mut sum, mut place) = (-0.0, 0);
    samples.each(&mut |values| {
        for value in values {
            sum += term(place, *value);
            place += 1;
        }
    });
    sum
}

/// The mean; zero of no samples.
pub fn mean(samples: &(impl Samples + ?Sized)) -> f64 {
    sum(samples, |_, value| value) / samples.count().max(1) as f64
}

/// The first and the last sample; none of no samples.
pub fn ends(samples: &(impl Samples + ?Sized)) -> Option<[f64; 2]> {
    let mut ends: Option<[f64; 2]> = None;
    samples.each(&mut |values| {
        if let ([first, ..], [.., last]) = (values, values) {
            ends = Some([ends.map_or(*first, |[first, _]| first), *last]);
        }
    });
    ends
}

/// Bits of a key that are counted in one pass.
const DIGIT: u32 = 11;

/// The samples at these places of the sorted order, by their total order. Each pass counts one
/// digit of those samples whose higher digits are known to match, so that only memory for the
/// counts is needed.
///
/// # Panics
/// At a place that there is not.
pub(crate) fn sorted_at<const N: usize>(
    samples: &(impl Samples + ?Sized),
    mut places: [usize; N],
) -> [f64; N] {
    assert!(places.iter().all(|place| *place < samples.count()), "the samples have these places");
    let mut keys = [0_u64; N];
    let mut shift = u64::BITS;
    while shift > 0 {
        let above = shift;
        shift = shift.saturating_sub(DIGIT);
        let higher = |key: u64| key.checked_shr(above).unwrap_or(0);
        // Places whose higher digits are alike share their counts.
        let mut prefixes: Vec<u64> = keys.iter().map(|key| higher(*key)).collect();
        prefixes.sort_unstable();
        prefixes.dedup();
        let digits = 1 << (above - shift);
        let mut counts = vec![0_usize; prefixes.len() * digits];
        samples.each(&mut |values| {
            for key in values.iter().map(|value| key(*value)) {
                let prefix = higher(key);
                if let Some(group) = prefixes.iter().position(|candidate| *candidate == prefix) {
                    counts[group * digits + (key >> shift) as usize % digits] += 1;
                }
            }
        });
        for (key, place) in keys.iter_mut().zip(&mut places) {
            let prefix = higher(*key);
            let group = prefixes.iter().position(|candidate| *candidate == prefix).unwrap_or(0);
            let mut digit = 0;
            for count in &counts[group * digits..(group + 1) * digits - 1] {
                if *place < *count {
                    break;
                }
                *place -= count;
                digit += 1;
            }
            *key |= digit << shift;
        }
    }
    keys.map(value)
}

/// Returns a whole number with the total order of the numbers.
fn key(value: f64) -> u64 {
    let bits = value.to_bits();
    if bits >> 63 == 0 { bits | 1 << 63 } else { !bits }
}

fn value(key: u64) -> f64 {
    f64::from_bits(if key >> 63 == 0 { !key } else { key & !(1 << 63) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// Samples in stretches, like those on a disk.
    struct Stretches<'a>(&'a [f64], usize);

    impl Samples for Stretches<'_> {
        fn count(&self) -> usize {
            self.0.len()
        }

        fn each(&self, take: &mut dyn FnMut(&[f64])) {
            self.0.chunks(self.1).for_each(take);
        }
    }

    fn numbers(count: usize) -> Vec<f64> {
        let mut random = Random::new(7);
        let number = |_| match (random.unit() * 8.0) as usize {
            0 => 0.0,
            1 => -0.0,
            2 => -1e300 * random.unit(),
            3 => 1e-310 * random.unit(),
            _ => random.unit() - 0.5,
        };
        (0..count).map(number).collect()
    }

    #[test]
    fn places_are_those_of_sorted_samples() {
        for count in [1, 2, 17, 5000] {
            let samples = numbers(count);
            let mut sorted = samples.clone();
            sorted.sort_by(f64::total_cmp);
            let places = [0, count / 20, count / 2, (19 * count / 20).min(count - 1), count - 1];
            let expected = places.map(|place| sorted[place].to_bits());
            for stretch in [1, 7, 5000] {
                let found = sorted_at(&Stretches(&samples, stretch), places);
                assert_eq!(found.map(f64::to_bits), expected);
            }
        }
        for odd in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(sorted_at(&[odd], [0]).map(f64::to_bits), [odd.to_bits()]);
        }
    }

    #[test]
    fn stretches_make_no_difference() {
        let samples = numbers(3000);
        let in_stretches = Stretches(&samples, 11);
        assert_eq!(mean(&in_stretches).to_bits(), mean(&samples).to_bits());
        assert_eq!(mean(&samples), samples.iter().sum::<f64>() / 3000.0);
        assert_eq!(ends(&in_stretches), Some([samples[0], samples[2999]]));
        assert_eq!(ends(&[]), None);
        let part = Part { samples: &in_stretches, rows: 5..2990 };
        let mut found = Vec::new();
        part.each(&mut |values| found.extend_from_slice(values));
        assert_eq!((part.count(), &found[..]), (2985, &samples[5..2990]));
        let mapped = Mapped { samples: &in_stretches, value: |place, value| value + place as f64 };
        found.clear();
        mapped.each(&mut |values| found.extend_from_slice(values));
        let expected: Vec<f64> = (0..3000).map(|i| samples[i] + i as f64).collect();
        assert_eq!(found, expected);
    }
}
