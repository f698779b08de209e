//! An operation by its name.

use wholestring::operation::OperationKind;
use wholestring_case::operation_named;

use crate::failure::Failure;

/// Returns the operation with this name, or with a driller's word for it.
///
/// # Errors
/// No operation has this name.
pub(crate) fn operation(name: &str) -> Result<OperationKind, Failure> {
    operation_named(name).ok_or_else(|| {
        let names = OperationKind::ALL.map(OperationKind::name).join(", ");
        Failure::BadInput(format!("error: `{name}` is no operation: expected one of {names}"))
    })
}
