//! The assembled string.

use serde::Serialize;

use super::Component;

/// The whole string, from the bit up, exactly as long as the bit is deep.
///
/// Made by [`StringSpec::assemble`](super::StringSpec::assemble), which checks every dimension.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DrillString {
    components: Vec<Component>,
    /// Distance from the bit to the top of each component, m.
    #[serde(skip)]
    tops_m: Vec<f64>,
}

/// Position of a component in the string.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span<'a> {
    /// The component.
    pub component: &'a Component,
    /// Distance from the bit to its lower end, m.
    pub from_bit_m: f64,
    /// Distance from the bit to its upper end, m.
    pub to_bit_m: f64,
}

impl DrillString {
    /// `components` holds at least one component, and every length is positive.
    pub(super) fn new(components: Vec<Component>) -> Self {
        let tops_m = components
            .iter()
            .scan(0.0, |top_m, component| {
                *top_m += component.length_m;
                Some(*top_m)
            })
            .collect();
        Self { components, tops_m }
    }

    /// Components from the bit up.
    pub fn components(&self) -> &[Component] {
        &self.components
    }

    /// Length from the bit to the surface, m.
    pub fn length_m(&self) -> f64 {
        self.tops_m[self.tops_m.len() - 1]
    }

    /// Mass in air, kg.
    pub fn mass_kg(&self) -> f64 {
        self.components
            .iter()
            .map(|component| component.mass_per_length_kg_per_m * component.length_m)
            .sum()
    }

    /// The tool face of its lowest bend, rad, if it has any.
    pub fn toolface_rad(&self) -> Option<f64> {
        self.components.iter().find_map(|one| one.bend).map(|bend| bend.toolface_rad)
    }

    /// The same string turned until its lowest bend points to a tool face, rad; other bends turn
    /// with it.
    #[must_use]
    pub fn at_toolface(&self, toolface_rad: f64) -> Self {
        let mut turned = self.clone();
        if let Some(before_rad) = self.toolface_rad() {
            for bend in turned.components.iter_mut().filter_map(|one| one.bend.as_mut()) {
                bend.toolface_rad += toolface_rad - before_rad;
            }
        }
        turned
    }

    /// The component at a distance from the bit, and its place counted from the bit.
    ///
    /// Between two components it is the upper one; below the bit it is the bit, above the surface
    /// the topmost component.
    pub fn component_at(&self, distance_from_bit_m: f64) -> (usize, &Component) {
        let index = self
            .tops_m
            .partition_point(|&top_m| top_m <= distance_from_bit_m)
            .min(self.components.len() - 1);
        (index, &self.components[index])
    }

    /// The components between two distances from the bit, m, from the bit up, each with its
    /// fraction of that length; the fractions add up to one. The topmost component includes the
    /// rounding error above it.
    pub fn parts_between(
        &self,
        from_bit_m: f64,
        to_bit_m: f64,
    ) -> impl Iterator<Item = (&Component, f64)> {
        let span_m = to_bit_m - from_bit_m;
        let last = self.components.len() - 1;
        self.spans().enumerate().filter_map(move |(index, span)| {
            let top_m = if index == last { f64::INFINITY } else { span.to_bit_m };
            let part = (to_bit_m.min(top_m) - from_bit_m.max(span.from_bit_m)) / span_m;
            (part > 0.0).then_some((span.component, part))
        })
    }

    /// The components with their places, from the bit up.
    pub fn spans(&self) -> impl DoubleEndedIterator<Item = Span<'_>> + ExactSizeIterator {
        (0..self.components.len()).map(|index| Span {
            component: &self.components[index],
            from_bit_m: if index == 0 { 0.0 } else { self.tops_m[index - 1] },
            to_bit_m: self.tops_m[index],
        })
    }
}
