//! A column of numbers for drawing.

use serde::{Serialize, Serializer};
use utoipa::ToSchema;

/// Numbers for drawing, in single precision, which suffices for a picture and halves the page's
/// transfer time. NaN is null.
#[derive(Debug, Clone, PartialEq, ToSchema)]
#[schema(value_type = Vec<Option<f32>>)]
pub struct Column(Vec<f32>);

impl Column {
    #[cfg(test)]
    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    #[cfg(test)]
    pub(super) fn last(&self) -> Option<f32> {
        self.0.last().copied()
    }

    /// Whether it has no number at all.
    pub fn is_blank(&self) -> bool {
        self.0.iter().all(|number| !number.is_finite())
    }
}

impl FromIterator<f64> for Column {
    fn from_iter<I: IntoIterator<Item = f64>>(numbers: I) -> Self {
        Self(numbers.into_iter().map(|number| number as f32).collect())
    }
}

impl Serialize for Column {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.iter().map(|number| number.is_finite().then_some(*number)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_is_null() {
        let column: Column = [0.1, f64::NAN, f64::INFINITY, -4305.25].into_iter().collect();
        assert_eq!(serde_json::to_string(&column).expect("JSON"), "[0.1,null,null,-4305.25]");
        assert!(!column.is_blank());
        assert!([f64::NAN].into_iter().collect::<Column>().is_blank());
    }
}
