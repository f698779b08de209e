//! Colours of operations.

use wholestring::operation::OperationKind;

/// Place of an operation among the colours of curves: the same in every picture.
pub fn operation_colour(kind: OperationKind) -> usize {
    use OperationKind::{BackReam, Drill, Ream, RotateOffBottom, Slide, TripIn, TripOut};
    match kind {
        TripIn => 0,
        TripOut => 1,
        RotateOffBottom => 2,
        Drill => 3,
        Slide => 4,
        Ream => 5,
        BackReam => 6,
    }
}
