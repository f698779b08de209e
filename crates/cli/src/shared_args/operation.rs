//! An operation by its name.

use wholestring::operation::OperationKind;

use crate::failure::Failure;

/// Returns the operation with this name.
///
/// # Errors
/// No operation has this name.
pub(crate) fn operation(name: &str) -> Result<OperationKind, Failure> {
    OperationKind::from_name(name).ok_or_else(|| {
        let names = OperationKind::ALL.map(OperationKind::name).join(", ");
        Failure::BadInput(format!("error: `{name}` is no operation: expected one of {names}"))
    })
}
