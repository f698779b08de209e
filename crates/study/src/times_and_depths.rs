//! Times and depths of the figures and tables of a study.

use wholestring_config::prelude::*;

/// Maximum number of times or depths of one figure, because more curves cannot be distinguished.
pub(crate) const MAX: usize = 12;

/// A time.
pub(crate) fn time() -> Quantity {
    Quantity::si(Dimension::Time, Range::from_to(0.0, 1e9), "10 s")
}

/// A measured depth.
pub(crate) fn depth() -> Quantity {
    Quantity::si(Dimension::Length, Range::from_to(0.0, 20_000.0), "600 m")
}

/// Times, one or several.
pub(crate) fn times() -> List<Quantity> {
    List::or_one(time(), "times", MAX)
}

/// Measured depths, one or several.
pub(crate) fn depths() -> List<Quantity> {
    List::or_one(depth(), "depths", MAX)
}

/// A first and a last time.
pub(crate) fn two_times() -> List<Quantity> {
    List::of(time(), "times", 2)
}

/// First and last time.
pub(crate) fn window(
    times: Option<&Spanned<Vec<Spanned<f64>>>>,
    reader: &mut Reader,
) -> Option<Option<[f64; 2]>> {
    let Some(times) = times else {
        return Some(None);
    };
    match times.value.as_slice() {
        [from, to] if from.value < to.value => Some(Some([from.value, to.value])),
        _ => Diagnostic::error("`window` has no duration")
            .at(times.place, "expected two times, such as [\"0 s\", \"20 s\"]")
            .refuse(reader),
    }
}
