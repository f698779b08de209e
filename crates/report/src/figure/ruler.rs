//! Ranges and ticks that fall on round numbers.

use super::{Axis, Range, Scale};

/// An axis with its range and its ticks.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Ruler {
    /// Ends of the range; for a logarithmic axis, their powers of ten.
    from: f64,
    to: f64,
    logarithmic: bool,
    /// Values and their text.
    pub(super) ticks: Vec<(f64, String)>,
}

impl Ruler {
    /// The ruler for an axis and its values, with about `count` ticks. Values that have no place
    /// are left out.
    pub(super) fn new(axis: &Axis, values: impl IntoIterator<Item = f64>, count: f64) -> Self {
        match &axis.scale {
            Scale::Linear => {
                let (from, to) = range(axis, bounds(values));
                Self::linear(from, to, count)
            }
            Scale::Logarithmic => {
                let powers = values.into_iter().filter(|value| *value > 0.0).map(f64::log10);
                let ends = match axis.range {
                    Range::Fixed(from, to) => Some((from.log10(), to.log10())),
                    _ => bounds(powers),
                };
                let (from, to) = ends.unwrap_or((-1.0, 0.0));
                let (from, to) = match axis.range {
                    Range::Near | Range::Zero => (from.floor(), to.ceil()),
                    _ => (from, to),
                };
                let to = if to > from { to } else { from + 1.0 };
                Self::logarithmic(from, to, count)
            }
            Scale::Words(words) => {
                let words = words.iter().enumerate();
                Self {
                    from: -0.5,
                    to: words.len().max(1) as f64 - 0.5,
                    logarithmic: false,
                    ticks: words.map(|(place, word)| (place as f64, word.clone())).collect(),
                }
            }
        }
    }

    fn linear(from: f64, to: f64, count: f64) -> Self {
        let (from, to) = drawable(from, to);
        let step = round_step((to - from) / count.max(1.0));
        // A tick at the very end of the range survives rounding.
        let slack = 1e-9;
        let (first, last) = (from / step, to / step);
        let ticks = ((first - slack).ceil() as i64..=(last + slack).floor() as i64)
            .take(MAX_TICKS)
            .map(|index| index as f64 * step)
            .map(|tick| (tick, tick_text(tick, step)))
            .collect();
        Self { from, to, logarithmic: false, ticks }
    }

    fn logarithmic(from: f64, to: f64, count: f64) -> Self {
        let from = if from.is_finite() { from.clamp(-300.0, 299.0) } else { -1.0 };
        let to = if to > from { to.min(300.0) } else { from + 1.0 };
        let every = ((to - from) / count.max(1.0)).ceil().max(1.0) as i32;
        let (first, last) = (from.floor() as i32, to.ceil() as i32);
        // For few decades, also two steps in each.
        let steps: &[f64] = if to - from < 2.0 { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let ticks = (first..=last)
            .filter(|power| power.rem_euclid(every) == 0)
            .flat_map(|power| steps.iter().map(move |step| (*step, power)))
            .map(|(step, power)| (step * 10_f64.powi(power), power_text(step, power)))
            .filter(|(tick, _)| (from - 1e-9..=to + 1e-9).contains(&tick.log10()))
            .collect();
        Self { from, to, logarithmic: true, ticks }
    }

    /// Place of the value in the range: 0 at its start, 1 at its end; not a number where it has no
    /// place.
    pub(super) fn place(&self, value: f64) -> f64 {
        let value = match self.logarithmic {
            false => value,
            true if value > 0.0 => value.log10(),
            true => f64::NAN,
        };
        (value - self.from) / (self.to - self.from)
    }

    /// Ends of the range in the axis' own values.
    pub(super) fn ends(&self) -> (f64, f64) {
        match self.logarithmic {
            false => (self.from, self.to),
            true => (10_f64.powf(self.from), 10_f64.powf(self.to)),
        }
    }

    /// A value in the format of this ruler's ticks, to a tenth of their step or in three digits.
    pub(super) fn text(&self, value: f64) -> String {
        let step = match &self.ticks[..] {
            [(first, _), (second, _), ..] => second - first,
            _ => self.to - self.from,
        };
        let third = 10_f64.powf(value.abs().log10().floor() - 2.0);
        let step = round_step(0.1 * step).max(if third.is_finite() { third } else { 0.0 });
        tick_text((value / step).round() * step, step)
    }

    /// The value at a part of a linear range.
    pub(super) fn value(&self, place: f64) -> f64 {
        self.from + place * (self.to - self.from)
    }
}

/// More ticks than any axis has.
const MAX_TICKS: usize = 200;

/// The ends of a range that ticks can divide; others for values that are not finite, extreme, or so
/// close to each other that no number is between them.
fn drawable(from: f64, to: f64) -> (f64, f64) {
    const LARGEST: f64 = 1e100;
    if !(from.is_finite() && to.is_finite()) {
        return (0.0, 1.0);
    }
    let [from, to] = [from, to].map(|end| end.clamp(-LARGEST, LARGEST));
    let least = (1e-9 * from.abs().max(to.abs())).max(1e-290);
    if to - from > least { (from, to) } else { (from, from + 1.0_f64.max(2.0 * least)) }
}

/// The ends of a linear axis; it has some length whatever the values.
fn range(axis: &Axis, values: Option<(f64, f64)>) -> (f64, f64) {
    let (low, high) = match (axis.range, values) {
        (Range::Fixed(from, to), _) => return (from, if to > from { to } else { from + 1.0 }),
        (_, None) => return (0.0, 1.0),
        (Range::Tight, Some((low, high))) => {
            return (low, if high > low { high } else { low + 1.0 });
        }
        (Range::Zero, Some((low, high))) => (low.min(0.0), high.max(0.0)),
        (Range::Near, Some((low, high))) if low > 0.0 && low < 0.35 * high => (0.0, high),
        (Range::Near, Some((low, high))) if high < 0.0 && high > 0.35 * low => (low, 0.0),
        (Range::Near, Some(ends)) => ends,
    };
    let (low, high) = if axis.sides.is_some() {
        // Room on either side of zero, so that both can be named.
        let side = 0.15 * (high - low);
        (low.min(-side), high.max(side))
    } else {
        (low, high)
    };
    // A force or torque below this, in any usual unit, is rounding.
    const NOTHING: f64 = 1e-6;
    if low.abs() <= NOTHING && high.abs() <= NOTHING {
        return if axis.sides.is_some() { (-1.0, 1.0) } else { (0.0, 1.0) };
    }
    let span = if high > low { high - low } else { 0.2 * high.abs() };
    let air = 0.05 * span;
    let short = axis.min_span - span;
    if short > 0.0 {
        // A range at zero, or that would pass it, stays at it; the other side of it is rounding.
        let rounding = 1e-3 * axis.min_span;
        return match (low, high) {
            (low, high) if low >= -rounding && low < 0.5 * short => (0.0, high.max(axis.min_span)),
            (low, high) if high <= rounding && -high < 0.5 * short => {
                (low.min(-axis.min_span), 0.0)
            }
            (low, high) => (low - 0.5 * short, high + 0.5 * short),
        };
    }
    (if low == 0.0 { 0.0 } else { low - air }, if high == 0.0 { 0.0 } else { high + air })
}

fn bounds(values: impl IntoIterator<Item = f64>) -> Option<(f64, f64)> {
    values.into_iter().filter(|value| value.is_finite()).fold(None, |range, value| {
        let (low, high) = range.unwrap_or((value, value));
        Some((low.min(value), high.max(value)))
    })
}

/// The smallest of 1, 2, 2.5, 5 times a power of ten that is at least `step`.
fn round_step(step: f64) -> f64 {
    let power = 10_f64.powf(step.log10().floor());
    let factor =
        [1.0, 2.0, 2.5, 5.0].into_iter().find(|factor| factor * power >= step * (1.0 - 1e-9));
    factor.unwrap_or(10.0) * power
}

/// A tick's number with the digits that its step needs, thousands separated from five digits on,
/// with a true minus.
fn tick_text(tick: f64, step: f64) -> String {
    let whole = |digits: i32| {
        let shifted = step * 10_f64.powi(digits);
        (shifted - shifted.round()).abs() < 1e-6
    };
    let digits = (0..8).find(|digits| whole(*digits)).unwrap_or(8) as usize;
    // Rounding must not leave a zero with a sign.
    let tick = if tick.abs() < 1e-6 * step { 0.0 } else { tick };
    let text = format!("{:.digits$}", tick.abs());
    let (whole, part) = match text.split_once('.') {
        Some((whole, part)) => (whole, format!(".{part}")),
        None => (text.as_str(), String::new()),
    };
    let mut apart = String::new();
    for (place, digit) in whole.chars().enumerate() {
        let left = whole.len() - place;
        if place > 0 && whole.len() > 4 && left.is_multiple_of(3) {
            apart.push('\u{202f}');
        }
        apart.push(digit);
    }
    let sign = if tick < 0.0 { "\u{2212}" } else { "" };
    format!("{sign}{apart}{part}")
}

/// A step and a power of ten, as a number where that is short.
fn power_text(step: f64, power: i32) -> String {
    match power {
        0..=3 => format!("{}", step * 10_f64.powi(power)),
        -3..=-1 => format!("{:.*}", power.unsigned_abs() as usize, step * 10_f64.powi(power)),
        _ => {
            let marks = power.to_string();
            let raised = marks.chars().map(|mark| match mark {
                '-' => '⁻',
                digit => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹']
                    [digit.to_digit(10).unwrap_or(0) as usize],
            });
            let times = if step == 1.0 { String::new() } else { format!("{step}·") };
            format!("{times}10{}", raised.collect::<String>())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(ruler: &Ruler) -> Vec<&str> {
        ruler.ticks.iter().map(|(_, text)| text.as_str()).collect()
    }

    #[test]
    fn ticks_are_round_and_inside() {
        let ruler =
            |range, values: [f64; 2], count| Ruler::new(&Axis::new("", range), values, count);
        let axis = ruler(Range::Zero, [-250.0, 1480.0], 5.0);
        assert_eq!(labels(&axis), ["0", "500", "1000", "1500"]);
        let axis = ruler(Range::Zero, [0.02, 0.13], 5.0);
        assert_eq!(labels(&axis), ["0.00", "0.05", "0.10"]);
        let axis = ruler(Range::Zero, [-3.0, -1.0], 4.0);
        assert_eq!(labels(&axis), ["\u{2212}3", "\u{2212}2", "\u{2212}1", "0"]);
        let axis = ruler(Range::Tight, [0.0, 4305.0], 10.0);
        assert_eq!(labels(&axis).len(), 9);
        assert_eq!(axis.place(4305.0), 1.0);
        let axis = ruler(Range::Near, [8.9e4, 9.6e4], 3.1);
        assert_eq!(labels(&axis), ["90\u{202f}000", "92\u{202f}500", "95\u{202f}000"]);
    }

    #[test]
    fn logarithmic_ticks_are_decades() {
        let mut axis = Axis::new("", Range::Near);
        axis.scale = Scale::Logarithmic;
        let ruler = Ruler::new(&axis, [0.0, -1.0, 2e-5, 30.0], 10.0);
        assert_eq!(labels(&ruler), ["10⁻⁵", "10⁻⁴", "0.001", "0.01", "0.1", "1", "10", "100"]);
        assert!((ruler.place(1e-5), ruler.place(100.0)) == (0.0, 1.0));
        axis.range = Range::Tight;
        let short = Ruler::new(&axis, [4.0, 50.0], 10.0);
        assert_eq!(labels(&short), ["5", "10", "20", "50"]);
        let small = Ruler::new(&axis, [2e-7, 1e-6], 10.0);
        assert_eq!(labels(&small), ["2·10⁻⁷", "5·10⁻⁷", "10⁻⁶"]);
        assert!(ruler.place(0.0).is_nan());
    }

    #[test]
    fn ranges_beyond_all_reason_have_ticks() {
        let ends = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, 1e300, -1e300, 1e20, 5e-324];
        for values in ends.iter().flat_map(|low| ends.map(|high| [*low, high])) {
            for scale in [Scale::Linear, Scale::Logarithmic] {
                let fixed = Range::Fixed(values[0], values[1]);
                for range in [Range::Tight, Range::Near, Range::Zero, fixed] {
                    let axis = Axis { scale: scale.clone(), ..Axis::new("", range) };
                    let ruler = Ruler::new(&axis, values, 5.0);
                    assert!(ruler.to > ruler.from, "{values:?} {ruler:?}");
                    assert!(ruler.ticks.len() <= MAX_TICKS, "{values:?}");
                }
            }
        }
    }

    #[test]
    fn ranges_exist_without_values() {
        for values in [vec![], vec![f64::NAN], vec![0.0, 1e-12], vec![7.0], vec![-7.0]] {
            for scale in [Scale::Linear, Scale::Logarithmic] {
                for range in [Range::Tight, Range::Near, Range::Zero] {
                    for sides in [None, Some(["low".to_owned(), "high".to_owned()])] {
                        let axis = Axis { scale: scale.clone(), sides, ..Axis::new("", range) };
                        let ruler = Ruler::new(&axis, values.clone(), 5.0);
                        assert!(ruler.to > ruler.from, "{ruler:?}");
                        assert!((1..20).contains(&ruler.ticks.len()), "{ruler:?}");
                    }
                }
            }
        }
    }
}
