//! Checks of verification tests: each number with its reference, tolerance and the reason for the
//! tolerance.
//!
//! A test passes each number that it checks to [`Check::report`], which asserts it. If the
//! environment variable [`FILE`] names a file, the row is appended to it as a line of JSON, and
//! `cargo xtask verify` makes the book's table from all rows.
//!
//! ```
//! use wholestring_verification::verify;
//!
//! verify("E05", "climb angle at friction 0.25, rad")
//!     .relative(2e-4, "what the slow rolling has left after ten seconds")
//!     .report(0.25_f64.atan(), 0.244_97);
//! ```
#![warn(missing_docs)]

use std::{borrow::Cow, fs::OpenOptions, io::Write};

use serde::{Deserialize, Serialize};

/// A file of `verification/`, parsed.
///
/// # Panics
/// If there is no such file, or it is no JSON.
pub fn file(name: &str) -> serde_json::Value {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../verification");
    let path = folder.join(name);
    let text = std::fs::read_to_string(&path)
        .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// `|obtained - expected| / |expected|`.
pub fn relative_error(obtained: f64, expected: f64) -> f64 {
    (obtained - expected).abs() / expected.abs()
}

/// The environment variable with the path of the file for the rows.
pub const FILE: &str = "WHOLESTRING_VERIFICATION";

/// Tolerance of a computed value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Tolerance {
    /// Relative to the expected value.
    Relative(f64),
    /// Absolute, in the quantity's unit; required for an expected zero.
    Absolute(f64),
    /// The expected value is a lower bound, and positive.
    AtLeast,
    /// Unlimited: a prediction, or a published number that is not reproduced, is reported without a
    /// check.
    Any,
}

/// Begins the check of a number. `case` is the name of a file of `verification/` up to its first
/// underscore (`E05`), or another name in the list of `verification/README.md`. `quantity` is the
/// number with whatever distinguishes it from others of the case, then its unit if it has one, as
/// in `climb at friction 0.25, rad`. A comma in it is the one before the unit.
///
/// # Panics
/// If the text after a comma is not one of [`UNITS`].
#[track_caller]
pub fn verify<'a>(case: &'a str, quantity: impl Into<Cow<'a, str>>) -> Quantity<'a> {
    let quantity = quantity.into();
    let unit = unit(&quantity);
    assert!(
        unit.is_empty() || UNITS.contains(&unit),
        "{case}, {quantity}: `{unit}` is not a unit, and there is no other comma in a quantity"
    );
    Quantity { case, quantity }
}

/// Units of quantities.
pub const UNITS: &[&str] = &[
    "%",
    "1/h",
    "1/m",
    "1/s",
    "Hz",
    "J",
    "J/m²",
    "J/m³",
    "MPa",
    "N",
    "N/kg",
    "N/m",
    "N/m^1.5",
    "N·m",
    "N·m/m",
    "Pa",
    "deg",
    "deg/30 m",
    "ft·lbf",
    "in",
    "kN·m",
    "lbf",
    "m",
    "m/s",
    "m²",
    "m³/N²",
    "m³/m",
    "psi",
    "rad",
    "rad/s",
    "rev/min",
    "s",
    "standard errors",
    "°",
];

/// Unit of a quantity, from its name; empty if it has none.
pub fn unit(quantity: &str) -> &str {
    quantity.rsplit_once(", ").map_or("", |(_, unit)| unit)
}

/// A number of a case that is to be checked.
///
/// The reason of each tolerance names its source: a convergence study, or the source's own
/// precision.
#[derive(Debug, Clone)]
pub struct Quantity<'a> {
    case: &'a str,
    quantity: Cow<'a, str>,
}

impl<'a> Quantity<'a> {
    /// Allows this difference relative to the expected value.
    pub fn relative(self, most: f64, reason: &'a str) -> Check<'a> {
        self.within(Tolerance::Relative(most), reason)
    }

    /// Allows this difference in its unit.
    pub fn absolute(self, most: f64, reason: &'a str) -> Check<'a> {
        self.within(Tolerance::Absolute(most), reason)
    }

    /// Requires at least the expected value.
    pub fn at_least(self, reason: &'a str) -> Check<'a> {
        self.within(Tolerance::AtLeast, reason)
    }

    /// Reports the value without a limit.
    pub fn any(self, reason: &'a str) -> Check<'a> {
        self.within(Tolerance::Any, reason)
    }

    /// A tolerance of whichever kind.
    pub fn within(self, tolerance: Tolerance, reason: &'a str) -> Check<'a> {
        Check { quantity: self, tolerance, reason }
    }
}

/// A number of a case with its tolerance.
#[derive(Debug, Clone)]
pub struct Check<'a> {
    quantity: Quantity<'a>,
    tolerance: Tolerance,
    reason: &'a str,
}

impl<'a> Check<'a> {
    /// Expected and computed values as a row for [`report_worst`].
    pub fn row(self, expected: f64, computed: f64) -> Row<'a> {
        let Check { quantity: Quantity { case, quantity }, tolerance, reason } = self;
        Row { case, quantity, expected, computed, tolerance, reason }
    }

    /// Checks the computed value against the expected one, and reports it.
    ///
    /// # Panics
    /// As [`Row::report`] does.
    #[track_caller]
    pub fn report(self, expected: f64, computed: f64) {
        self.row(expected, computed).report();
    }
}

/// One number, compared with another.
#[derive(Debug, Clone, PartialEq)]
pub struct Row<'a> {
    case: &'a str,
    quantity: Cow<'a, str>,
    expected: f64,
    computed: f64,
    tolerance: Tolerance,
    reason: &'a str,
}

impl Row<'_> {
    /// Difference of the two values in the unit of the tolerance, or relative to the expected value
    /// if it is unlimited.
    pub fn error(&self) -> f64 {
        error(self.expected, self.computed, self.tolerance)
    }

    /// The error over the tolerance; more than 1 fails, and so does NaN.
    fn strain(&self) -> f64 {
        match self.tolerance {
            Tolerance::Any if self.computed.is_finite() => 0.0,
            Tolerance::Any => f64::NAN,
            // An infinite value is the result of a division by zero, and proves nothing.
            Tolerance::AtLeast if self.computed.is_infinite() => f64::NAN,
            Tolerance::AtLeast if self.computed <= 0.0 => f64::INFINITY,
            Tolerance::AtLeast => self.expected / self.computed,
            // An error of zero meets a tolerance of zero.
            Tolerance::Relative(_) | Tolerance::Absolute(_) if self.error() == 0.0 => 0.0,
            Tolerance::Relative(most) | Tolerance::Absolute(most) => self.error() / most,
        }
    }

    /// Checks it and reports it.
    ///
    /// # Panics
    /// If the error exceeds its tolerance, or the file for the rows cannot be written.
    #[track_caller]
    pub fn report(self) {
        report_worst([self]);
    }

    #[track_caller]
    fn check(&self) {
        let Row { case, quantity, expected, computed, tolerance, .. } = self;
        assert!(
            self.strain() <= 1.0,
            "{case}, {quantity}: {computed} for {expected}, {:.2e} apart, {tolerance:?} is held",
            self.error()
        );
    }
}

/// Difference of `computed` and `expected` in the unit of the tolerance, or relative to the
/// expected value if the tolerance is unlimited.
pub fn error(expected: f64, computed: f64, tolerance: Tolerance) -> f64 {
    let apart = (computed - expected).abs();
    match tolerance {
        Tolerance::Absolute(_) => apart,
        _ if apart == 0.0 => 0.0,
        Tolerance::Relative(_) | Tolerance::AtLeast | Tolerance::Any => apart / expected.abs(),
    }
}

/// Checks many similar rows, and reports the one nearest to its tolerance for all of them.
///
/// # Panics
/// As [`Row::report`] does, and if there is none.
#[track_caller]
pub fn report_worst<'a>(rows: impl IntoIterator<Item = Row<'a>>) {
    let mut count = 0;
    let mut worst: Option<Row<'a>> = None;
    for row in rows {
        row.check();
        count += 1;
        let nearer = worst.as_ref().is_none_or(|worst| row.strain() >= worst.strain());
        if nearer {
            worst = Some(row);
        }
    }
    let worst = worst.expect("there is something to check");
    append(&Line {
        case: worst.case.into(),
        quantity: worst.quantity,
        expected: worst.expected,
        computed: worst.computed,
        tolerance: worst.tolerance,
        reason: worst.reason.into(),
        of: count,
    });
}

/// A reported row in the file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Line<'a> {
    /// As in [`verify`].
    pub case: Cow<'a, str>,
    /// As in [`verify`].
    pub quantity: Cow<'a, str>,
    /// Expected value.
    pub expected: f64,
    /// Computed value.
    pub computed: f64,
    /// Tolerance.
    pub tolerance: Tolerance,
    /// Reason of the tolerance.
    pub reason: Cow<'a, str>,
    /// Number of values of which it is the worst.
    pub of: usize,
}

fn append(line: &Line<'_>) {
    let Some(path) = std::env::var_os(FILE) else {
        return;
    };
    let mut text = serde_json::to_string(line).expect("numbers and words");
    text.push('\n');
    // Tests run in parallel: a single write to the end of the file is not interleaved.
    OpenOptions::new()
        .create(true)
        .append(true)
        .open(&path)
        .and_then(|mut file| file.write_all(text.as_bytes()))
        .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(expected: f64, computed: f64, tolerance: Tolerance) -> Row<'static> {
        verify("X01", "a number").within(tolerance, "a test").row(expected, computed)
    }

    #[test]
    fn a_unit_stands_behind_the_only_comma() {
        assert_eq!(unit("climb at friction 0.25, rad"), "rad");
        assert_eq!(unit("climb"), "");
    }

    #[test]
    #[should_panic(expected = "`at friction 0.25` is not a unit")]
    fn what_stands_behind_a_comma_and_is_no_unit_is_told() {
        let _ = verify("X01", "climb, at friction 0.25");
    }

    #[test]
    fn what_is_near_enough_passes() {
        for (expected, computed, tolerance) in [
            (2.0, 2.002, Tolerance::Relative(1.01e-3)),
            (-2.0, -2.002, Tolerance::Relative(1.01e-3)),
            (0.0, 0.1, Tolerance::Absolute(0.1)),
            (3.0, 3.0, Tolerance::Relative(0.0)),
            (0.0, 0.0, Tolerance::Relative(1e-9)),
            (0.3, 0.3, Tolerance::AtLeast),
            (0.3, 7.0, Tolerance::AtLeast),
            (1.0, 7.0, Tolerance::Any),
        ] {
            row(expected, computed, tolerance).check();
        }
    }

    #[test]
    fn what_is_too_far_off_fails() {
        for (expected, computed, tolerance) in [
            (2.0, 2.002, Tolerance::Relative(0.99e-3)),
            (2.0, -2.0, Tolerance::Relative(1e-3)),
            (0.0, 0.1, Tolerance::Relative(0.5)),
            (0.0, -0.11, Tolerance::Absolute(0.1)),
            (1.0, f64::NAN, Tolerance::Relative(1e-3)),
            (1.0, f64::NAN, Tolerance::Any),
            (0.3, 0.29, Tolerance::AtLeast),
            (0.3, -7.0, Tolerance::AtLeast),
            (0.3, f64::INFINITY, Tolerance::AtLeast),
            (0.3, f64::NAN, Tolerance::AtLeast),
            (f64::INFINITY, 1.0, Tolerance::Relative(1e-3)),
        ] {
            let row = row(expected, computed, tolerance);
            let caught = std::panic::catch_unwind(|| row.check());
            assert!(caught.is_err(), "{row:?}");
        }
    }

    #[test]
    #[should_panic(expected = "X01, a number: 3 for 2, 5.00e-1 apart")]
    fn one_of_many_is_enough_to_fail() {
        report_worst([2.0, 3.0, 2.0].map(|x| row(2.0, x, Tolerance::Relative(0.1))));
    }
}
