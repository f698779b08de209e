//! Ranges and ticks that fall on round numbers.

/// A force or torque below this, in any unit that people read, is rounding.
const NOTHING: f64 = 1e-6;

/// A range with round ticks.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Axis {
    pub(crate) from: f64,
    pub(crate) to: f64,
    step: f64,
}

impl Axis {
    /// The range of the values and zero, against which forces and torques are read, widened so that
    /// no curve touches the frame, with about `ticks` ticks. With `two_sided` there is room on either
    /// side of zero. Values that are not finite are left out; nothing but zeros gets a range of 1.
    pub(crate) fn around(
        values: impl IntoIterator<Item = f64>,
        two_sided: bool,
        ticks: usize,
    ) -> Self {
        let (low, high) = bounds(values).unwrap_or((0.0, 0.0));
        let (low, high) = (low.min(0.0), high.max(0.0));
        let span = if high - low > NOTHING {
            high - low
        } else {
            1.0
        };
        let margin = 0.05 * span;
        let side = if two_sided { 0.15 * span } else { 0.0 };
        Self {
            from: (if low < -NOTHING { low - margin } else { 0.0 }).min(-side),
            to: (if low < -NOTHING && high <= NOTHING {
                0.0
            } else {
                low + span + margin
            })
            .max(side),
            step: round_step(span / ticks as f64),
        }
    }

    /// The range of a depth axis: exactly that of the values.
    pub(crate) fn depth(values: impl IntoIterator<Item = f64>, ticks: usize) -> Self {
        let (from, to) = bounds(values).unwrap_or((0.0, 1.0));
        let to = if to > from { to } else { from + 1.0 };
        Self {
            from,
            to,
            step: round_step((to - from) / ticks as f64),
        }
    }

    /// Ticks inside the range.
    pub(crate) fn ticks(&self) -> Vec<f64> {
        let (first, last) = (self.from / self.step, self.to / self.step);
        // A tick at the very end of the range survives rounding.
        let slack = 1e-9;
        ((first - slack).ceil() as i64..=(last + slack).floor() as i64)
            .map(|index| index as f64 * self.step)
            .collect()
    }

    /// A tick's number with the digits that its step needs.
    pub(crate) fn label(&self, tick: f64) -> String {
        let digits = (-self.step.log10().floor()).max(0.0) as usize;
        // A true minus sign is as wide as the digits are.
        let text = format!("{tick:.digits$}");
        match text.strip_prefix('-') {
            Some(rest) if rest.bytes().all(|byte| matches!(byte, b'0' | b'.')) => rest.to_owned(),
            Some(rest) => format!("\u{2212}{rest}"),
            None => text,
        }
    }

    /// Where the value lies in the range: 0 at its start, 1 at its end.
    pub(crate) fn place(&self, value: f64) -> f64 {
        (value - self.from) / (self.to - self.from)
    }
}

fn bounds(values: impl IntoIterator<Item = f64>) -> Option<(f64, f64)> {
    values
        .into_iter()
        .filter(|value| value.is_finite())
        .fold(None, |range, value| {
            let (low, high) = range.unwrap_or((value, value));
            Some((low.min(value), high.max(value)))
        })
}

/// The smallest of 1, 2, 5 times a power of ten that is at least `step`.
fn round_step(step: f64) -> f64 {
    let power = 10_f64.powf(step.log10().floor());
    let factor = [1.0, 2.0, 5.0]
        .into_iter()
        .find(|factor| factor * power >= step * (1.0 - 1e-9));
    factor.unwrap_or(10.0) * power
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_inside() {
        let labels = |axis: &Axis| {
            let ticks = axis.ticks();
            ticks
                .iter()
                .map(|tick| axis.label(*tick))
                .collect::<Vec<_>>()
        };
        let axis = Axis::around([-250.0, 1480.0], false, 5);
        assert_eq!(labels(&axis), ["0", "500", "1000", "1500"]);
        let axis = Axis::around([0.02, 0.13], false, 5);
        assert_eq!(labels(&axis), ["0.00", "0.05", "0.10"]);
        let axis = Axis::around([-3.0, -1.0], false, 4);
        assert_eq!(labels(&axis), ["\u{2212}3", "\u{2212}2", "\u{2212}1", "0"]);
        let axis = Axis::depth([0.0, 4305.0], 10);
        assert_eq!(labels(&axis).len(), 9);
        assert_eq!(axis.place(4305.0), 1.0);
    }

    #[test]
    fn ranges_exist_without_values() {
        for values in [
            vec![],
            vec![f64::NAN],
            vec![0.0, 1e-12],
            vec![7.0],
            vec![-7.0],
        ] {
            let two_sided = Axis::around(values.clone(), true, 5);
            assert!(two_sided.from < -0.1 && two_sided.to > 0.1, "{two_sided:?}");
            let one_sided = Axis::around(values.clone(), false, 5);
            for axis in [one_sided, two_sided, Axis::depth(values, 5)] {
                assert!(axis.to > axis.from, "{axis:?}");
                assert!((2..20).contains(&axis.ticks().len()), "{axis:?}");
            }
        }
    }
}
