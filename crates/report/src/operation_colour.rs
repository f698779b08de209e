//! Colours of operations.

use wholestring::operation::OperationKind;

/// Operations with a colour of their own, in the order of the colours of curves; others share the
/// next.
const COLOURED: [OperationKind; 6] = [
    OperationKind::TripIn,
    OperationKind::TripOut,
    OperationKind::RotateOffBottom,
    OperationKind::Drill,
    OperationKind::Slide,
    OperationKind::Ream,
];

/// Place of an operation among the colours of curves: the same in every picture.
pub fn operation_colour(kind: OperationKind) -> usize {
    COLOURED.iter().position(|coloured| *coloured == kind).unwrap_or(COLOURED.len())
}
