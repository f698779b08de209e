//! Laws of the caller's own, and the numbers that they keep between steps.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

/// A checkpoint was written with another law or controller of the caller's own.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("the checkpoint was written with {found} as {role}, the settings have {expected}")]
pub struct AnotherExtension {
    /// Role in the run: the law of the bit, the controller of the top drive.
    pub role: &'static str,
    /// Its name and the length of its state, by the checkpoint.
    pub found: String,
    /// The same by the settings.
    pub expected: String,
}

/// A law of the caller's own in a run.
///
/// The law itself is shared and never changes; only `state` changes, which consists of plain
/// numbers that a checkpoint stores. An extension that has been read back has no law until
/// [`Self::attach`] gives it.
#[derive(Debug, Serialize, Deserialize)]
#[serde(bound = "")]
pub(in crate::dynamics) struct Extension<L: ?Sized> {
    name: String,
    state: Vec<f64>,
    #[serde(skip)]
    law: Option<Arc<L>>,
}

impl<L: ?Sized> Clone for Extension<L> {
    fn clone(&self) -> Self {
        Self { name: self.name.clone(), state: self.state.clone(), law: self.law.clone() }
    }
}

impl<L: ?Sized> Extension<L> {
    pub(in crate::dynamics) fn new(law: &Arc<L>, name: &str, state: Vec<f64>) -> Self {
        Self { name: name.to_owned(), state, law: Some(Arc::clone(law)) }
    }

    /// Gives one that has been read back its law; refuses a law of another name, or one that keeps
    /// another count of numbers.
    pub(in crate::dynamics) fn attach(
        &mut self,
        role: &'static str,
        law: &Arc<L>,
        name: &str,
        numbers: usize,
    ) -> Result<(), AnotherExtension> {
        if self.name != name || self.state.len() != numbers {
            let words =
                |name: &str, numbers: usize| format!("`{name}` (state of length {numbers})");
            return Err(AnotherExtension {
                role,
                found: words(&self.name, self.state.len()),
                expected: words(name, numbers),
            });
        }
        self.law = Some(Arc::clone(law));
        Ok(())
    }

    /// Whether it has its law.
    pub(in crate::dynamics) fn is_attached(&self) -> bool {
        self.law.is_some()
    }

    /// The law and its numbers; none of one that has not been attached.
    pub(in crate::dynamics) fn get(&self) -> Option<(&L, &[f64])> {
        Some((self.law.as_deref()?, &self.state))
    }

    /// The same, the numbers to be changed.
    pub(in crate::dynamics) fn get_mut(&mut self) -> Option<(&L, &mut [f64])> {
        Some((self.law.as_deref()?, &mut self.state))
    }
}
