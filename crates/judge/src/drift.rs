//! The sentence on means that drift over the window.

use wholestring::{
    dynamics::Statistic,
    outcome::{QuantityKind, scalars_by_row},
};
use wholestring_units::{Dimension, UnitSet};

use crate::{
    Quantity, Rounding,
    quantities::{deviation, dimension, shown, symbol},
};

/// Travel of the bit in the window, m, from which it is named as a possible cause of a changing
/// mean.
const TRAVELS_M: f64 = 1.0;

/// Scalars that drift over the window, as a sentence with marked quantities; `None` where no scalar of the table does.
pub fn sentence(statistics: &[(&str, Statistic)], bit_travel_m: f64) -> Option<String> {
    let drifts: Vec<String> = scalars_by_row()
        .into_iter()
        .filter_map(|scalar| {
            let quantity = scalar.quantity;
            let mut known = statistics.iter();
            let (_, statistic) =
                known.find(|(name, statistic)| *name == quantity.name && statistic.drifts)?;
            let verb = if statistic.drift < 0.0 { "falls" } else { "rises" };
            let change = change(quantity.kind, statistic.drift.abs());
            let label = scalar.label.to_lowercase();
            Some(format!("{label} {verb} by {change}"))
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
            Quantity::new(Dimension::Length, bit_travel_m, Rounding::Tenth)
        ),
        false => "settle longer".to_owned(),
    };
    let sentence =
        format!("{list} over the window (↗ ↘): there ± is drift, not motion alone; {why}");
    let mut letters = sentence.chars();
    let first = letters.next().map(char::to_uppercase);
    Some(first.into_iter().flatten().chain(letters).collect())
}

/// A change of a scalar with its unit. Turns have the same unit in every set.
fn change(kind: QuantityKind, change: f64) -> String {
    match (kind, dimension(kind)) {
        (QuantityKind::Angle, _) | (_, None) => {
            format!("{} {}", deviation(shown(kind, change, UnitSet::Si)), symbol(kind, UnitSet::Si))
        }
        (_, Some(dimension)) => Quantity::new(dimension, change, Rounding::Deviation).to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::{sentence as wording, *};
    use crate::Wording;

    fn sentence(
        statistics: &[(&str, Statistic)],
        bit_travel_m: f64,
        units: UnitSet,
    ) -> Option<String> {
        Some(Wording::from(wording(statistics, bit_travel_m)?).in_units(units))
    }

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
