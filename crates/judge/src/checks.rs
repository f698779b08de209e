//! All checks of an operation.

use serde::{Deserialize, Serialize};

use crate::{Check, CheckKind, Severity, Unchecked};

/// The checks of an operation, the most severe first, and what could not be checked.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Checks {
    /// Of each kind of limit one for each component that it concerns and those of the rig; then the
    /// states that are reported.
    pub checks: Vec<Check>,
    /// What could not be checked.
    pub unchecked: Vec<Unchecked>,
}

impl Checks {
    /// The checks in the order in which people read them: the most severe first, among equals what
    /// stops the operation, then why, as they were made.
    pub(crate) fn ordered(mut self) -> Self {
        self.checks.sort_by_key(|check| std::cmp::Reverse(check.severity));
        self
    }

    /// The check of a limit that has the least reserve.
    pub fn worst(&self, kind: CheckKind) -> Option<&Check> {
        self.least(|check| check.kind == kind)
    }

    /// The limit that breaks something or stops the operation first.
    pub fn governing(&self) -> Option<&Check> {
        self.least(|check| check.kind.stops())
    }

    fn least(&self, chosen: impl Fn(&Check) -> bool) -> Option<&Check> {
        let limits = self.checks.iter().filter(|check| check.factor.is_some() && chosen(check));
        limits.min_by(|a, b| a.reserve().total_cmp(&b.reserve()))
    }

    /// Limits alone.
    pub fn limits(&self) -> impl Iterator<Item = &Check> {
        self.checks.iter().filter(|check| check.factor.is_some())
    }

    /// The most severe check that needs attention; none where all limits are kept.
    pub fn most_severe(&self) -> Option<&Check> {
        let open = self.checks.iter().filter(|check| !check.is_ok());
        // The first of equals: `max_by_key` gives the last.
        open.rev().max_by_key(|check| check.severity)
    }

    /// The checks of a result's summary: all that need attention, and of each kind of limit the one
    /// with the least reserve.
    pub fn governing_of_each_kind(&self) -> Vec<Check> {
        let governs =
            |check: &Check| self.worst(check.kind).is_some_and(|worst| std::ptr::eq(worst, check));
        let shown = self.checks.iter();
        shown
            .filter(|check| {
                check.severity >= Severity::Warning || check.factor.is_none() || governs(check)
            })
            .cloned()
            .collect()
    }

    pub(crate) fn lacks(
        &mut self,
        kind: CheckKind,
        component: Option<&str>,
        missing: crate::Missing,
    ) {
        let component = component.map(str::to_owned);
        self.unchecked.push(Unchecked { kind, component, missing });
    }
}
