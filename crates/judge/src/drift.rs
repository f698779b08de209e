//! The sentence on means that drift over the window.

use wholestring::{dynamics::Statistic, outcome::scalars_by_row};
use wholestring_units::{Dimension, UnitSet};

use crate::quantities::{deviation, shown, symbol};

/// Travel of the bit in the window, m, from which it is named as a possible cause of a changing
/// mean.
const TRAVELS_M: f64 = 1.0;

/// Scalars that drift over the window, as a sentence; `None` where no scalar of the table does.
pub fn sentence(
    statistics: &[(&str, Statistic)],
    bit_travel_m: f64,
    units: UnitSet,
) -> Option<String> {
    let drifts: Vec<String> = scalars_by_row()
        .into_iter()
        .filter_map(|scalar| {
            let quantity = scalar.quantity;
            let mut known = statistics.iter();
            let (_, statistic) =
                known.find(|(name, statistic)| *name == quantity.name && statistic.drifts)?;
            let verb = if statistic.drift < 0.0 { "falls" } else { "rises" };
            let change = deviation(shown(quantity.kind, statistic.drift.abs(), units));
            let symbol = symbol(quantity.kind, units);
            let label = scalar.label.to_lowercase();
            Some(format!("{label} {verb} by {change} {symbol}"))
        })
        .collect();
    let (first, rest) = drifts.split_first()?;
    let list = match rest.split_last() {
        None => first.clone(),
        Some((last, [])) => format!("{first} and {last}"),
        Some((last, between)) => format!("{first}, {} and {last}", between.join(", ")),
    };
    let why = match bit_travel_m.abs() >= TRAVELS_M {
        true => format!(
            "the string goes {} through the hole meanwhile, and a shorter window reduces this",
            Dimension::Length.format((10.0 * bit_travel_m).round() / 10.0, units)
        ),
        false => "settle longer".to_owned(),
    };
    let sentence =
        format!("{list} over the window (↗ ↘): there ± is drift, not motion alone; {why}");
    let mut letters = sentence.chars();
    let first = letters.next().map(char::to_uppercase);
    Some(first.into_iter().flatten().chain(letters).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn statistic(std: f64, drift: f64, drifts: bool) -> Statistic {
        let json = serde_json::json!({
            "mean": 200e3, "std": std, "min": 0.0, "max": 0.0, "p05": 0.0, "p95": 0.0,
            "std_error": 10.0, "drift": drift, "drifts": drifts,
        });
        serde_json::from_value(json).expect("a statistic")
    }

    #[test]
    fn drifting_means_are_named_with_their_drift() {
        let statistics = [
            ("hook_load_N", statistic(700.0, -2100.0, true)),
            ("axial_friction_N", statistic(700.0, -2000.0, false)),
            ("stretch_m", statistic(0.003, 0.01, true)),
        ];
        assert_eq!(
            sentence(&statistics, 0.05, UnitSet::Si).as_deref(),
            Some(
                "Hook load without block falls by 2.1 kN and stretch rises by 0.010 m over the \
                 window (↗ ↘): there ± is drift, not motion alone; settle longer"
            )
        );
    }

    #[test]
    fn a_string_that_travels_needs_no_longer_settling() {
        let statistics = [("hook_load_N", statistic(700.0, 2600.0, true))];
        let sentence = sentence(&statistics, 18.0, UnitSet::Si).expect("a sentence");
        assert!(sentence.contains("the string goes 18 m through the hole meanwhile"), "{sentence}");
        assert!(!sentence.contains("settle"), "{sentence}");
    }

    #[test]
    fn steady_means_have_no_sentence() {
        let statistics = [("hook_load_N", statistic(700.0, 0.0, false))];
        assert_eq!(sentence(&statistics, 0.0, UnitSet::Si), None);
    }
}
