//! All checks of an operation.

use serde::{Deserialize, Serialize};

use crate::{Check, CheckKind, Severity, Unchecked};

/// The checks of an operation, the most severe first, and the limits that could not be checked.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Checks {
    /// For each kind of limit, one check for each component that it concerns and those of the rig;
    /// then the reported states.
    pub checks: Vec<Check>,
    /// Limits that could not be checked.
    pub unchecked: Vec<Unchecked>,
}

impl Checks {
    /// Sorts the checks in the order in which people read them: the most severe first; among equals
    /// those that stop the operation, then their causes, in the order in which they were made.
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

    /// The most severe check that needs attention; `None` where all limits are met.
    pub fn most_severe(&self) -> Option<&Check> {
        let open = self.checks.iter().filter(|check| !check.is_ok());
        // Takes the first of equals, because `max_by_key` returns the last.
        open.rev().max_by_key(|check| check.severity)
    }

    /// The checks of a result's summary: all that need attention, and for each kind of limit the
    /// one with the least reserve.
    pub fn governing_of_each_kind(&self) -> Vec<Check> {
        let governs =
            |check: &Check| self.worst(check.kind).is_some_and(|worst| std::ptr::eq(worst, check));
        let selected = self.checks.iter();
        selected
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
