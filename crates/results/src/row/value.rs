//! Values of the cells of a row.

use wholestring::{
    operation::OperationKind,
    outcome::{Buckling, ModelKind},
    statics::assembly::Touching,
    well::FrictionLevel,
};
use wholestring_judge::{CheckKind, DepthLimit, Severity, Verdict};
use wholestring_vibration::torsional_stability::LiesBy;

/// A value of a column of numbers.
pub(crate) trait Number {
    /// Whether rows without a number are possible.
    const MAY_BE_NONE: bool = false;

    /// The number; `None` where there is none.
    fn number(&self) -> Option<f64>;
}

/// A number that is read back from its column.
pub(crate) trait FromNumber: Number + Sized {
    /// Expected numbers, in an error.
    const EXPECTED: &'static str = "a number";

    /// The value; `None` for a number that it cannot have.
    fn from_number(number: Option<f64>) -> Option<Self>;
}

/// A value of a column of words.
pub(crate) trait Word {
    /// Whether rows without a word are possible.
    const MAY_BE_NONE: bool = false;

    /// The word; empty where there is none.
    fn word(&self) -> &str;
}

/// A word that is read back from its column.
pub(crate) trait FromWord: Word + Sized {
    /// Expected words, in an error.
    const EXPECTED: &'static str;

    /// The value; `None` for a word that it does not have.
    fn from_word(word: &str) -> Option<Self>;
}

/// A field whose own parts are columns.
pub(crate) trait Part {
    /// Type that has the parts.
    type Whole: ?Sized;

    /// The field; `None` where it has no value.
    fn whole(&self) -> Option<&Self::Whole>;
}

impl Number for f64 {
    fn number(&self) -> Option<f64> {
        Some(*self)
    }
}

/// No number is read as one that is not finite, because such a number is written as none.
impl FromNumber for f64 {
    fn from_number(number: Option<f64>) -> Option<Self> {
        Some(number.unwrap_or(f64::NAN))
    }
}

impl Number for usize {
    fn number(&self) -> Option<f64> {
        Some(*self as f64)
    }
}

impl FromNumber for usize {
    const EXPECTED: &'static str = "a whole number from 0";

    fn from_number(number: Option<f64>) -> Option<Self> {
        let number = number?;
        let whole = number as Self;
        (whole as f64 == number).then_some(whole)
    }
}

impl Number for u64 {
    fn number(&self) -> Option<f64> {
        Some(*self as f64)
    }
}

/// 1 where it holds, else 0.
impl Number for bool {
    fn number(&self) -> Option<f64> {
        Some(f64::from(u8::from(*self)))
    }
}

impl FromNumber for bool {
    const EXPECTED: &'static str = "1 or 0";

    fn from_number(number: Option<f64>) -> Option<Self> {
        match number? {
            1.0 => Some(true),
            0.0 => Some(false),
            _ => None,
        }
    }
}

impl<N: Number> Number for &N {
    const MAY_BE_NONE: bool = N::MAY_BE_NONE;

    fn number(&self) -> Option<f64> {
        N::number(self)
    }
}

impl<N: Number> Number for Option<N> {
    const MAY_BE_NONE: bool = true;

    fn number(&self) -> Option<f64> {
        self.as_ref().and_then(N::number)
    }
}

impl<N: FromNumber> FromNumber for Option<N> {
    const EXPECTED: &'static str = N::EXPECTED;

    fn from_number(number: Option<f64>) -> Option<Self> {
        match number {
            Some(_) => N::from_number(number).map(Some),
            None => Some(None),
        }
    }
}

impl Word for str {
    fn word(&self) -> &str {
        self
    }
}

impl Word for String {
    fn word(&self) -> &str {
        self
    }
}

impl FromWord for String {
    const EXPECTED: &'static str = "a word";

    fn from_word(word: &str) -> Option<Self> {
        Some(word.to_owned())
    }
}

/// `yes` or `no`.
impl Word for bool {
    fn word(&self) -> &str {
        if *self { "yes" } else { "no" }
    }
}

impl FromWord for bool {
    const EXPECTED: &'static str = "yes or no";

    fn from_word(word: &str) -> Option<Self> {
        match word {
            "yes" => Some(true),
            "no" => Some(false),
            _ => None,
        }
    }
}

impl<W: Word + ?Sized> Word for &W {
    const MAY_BE_NONE: bool = W::MAY_BE_NONE;

    fn word(&self) -> &str {
        W::word(self)
    }
}

impl<W: Word> Word for Option<W> {
    const MAY_BE_NONE: bool = true;

    fn word(&self) -> &str {
        self.as_ref().map_or("", W::word)
    }
}

impl<W: FromWord> FromWord for Option<W> {
    const EXPECTED: &'static str = W::EXPECTED;

    fn from_word(word: &str) -> Option<Self> {
        match word {
            "" => Some(None),
            _ => W::from_word(word).map(Some),
        }
    }
}

/// Types whose values have names; those that are read back also with the search for a name and its
/// description in an error.
macro_rules! named {
    ($($type:ty: $name:ident $(, $expected:literal, $from_name:expr)?;)+) => {$(
        impl $crate::row::Word for $type {
            fn word(&self) -> &str {
                Self::$name(*self)
            }
        }

        $(impl $crate::row::FromWord for $type {
            const EXPECTED: &'static str = $expected;

            fn from_word(word: &str) -> Option<Self> {
                $from_name(word)
            }
        })?
    )+};
}
pub(crate) use named;

named! {
    ModelKind: name, "a method", ModelKind::named;
    OperationKind: name, "an operation", OperationKind::from_name;
    FrictionLevel: name, "a level of friction",
        |word| FrictionLevel::ALL.into_iter().find(|level| level.name() == word);
    Severity: name, "a severity",
        |word| Severity::ALL.into_iter().find(|severity| severity.name() == word);
    CheckKind: name, "a kind of check",
        |word| CheckKind::ALL.iter().copied().find(|kind| kind.name() == word);
    DepthLimit: name, "a limit of a reach", DepthLimit::named;
    Buckling: name, "a state of buckling",
        |word| [Buckling::None, Buckling::Sinusoidal, Buckling::Helical]
            .into_iter().find(|state| state.name() == word);
    Verdict: words;
    LiesBy: name;
    Touching: name;
}

impl<T> Part for Option<T> {
    type Whole = T;

    fn whole(&self) -> Option<&T> {
        self.as_ref()
    }
}

impl<T, const N: usize> Part for [T; N] {
    type Whole = Self;

    fn whole(&self) -> Option<&Self> {
        Some(self)
    }
}

/// Structures whose parts are columns.
macro_rules! parts {
    ($($type:ty),+) => {$(
        impl $crate::row::Part for $type {
            type Whole = Self;

            fn whole(&self) -> Option<&Self> {
                Some(self)
            }
        }
    )+};
}
pub(crate) use parts;
