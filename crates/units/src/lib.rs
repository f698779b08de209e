//! Quantities as engineers write them: `"5-1/2 in"`, `"1.2 sg"`, `"3 deg/30m"`, `"60 kN"`.
//!
//! The engine works in SI and radians. All input and output passes through a [`Dimension`], which
//! reads text into SI and prints SI in the units of a [`UnitSet`].
//!
//! ```
//! use wholestring_units::{Dimension, UnitSet};
//!
//! assert_eq!(Dimension::Diameter.parse("5-1/2 in")?, 0.1397);
//! assert_eq!(Dimension::Density.parse("1.2 sg")?, 1200.0);
//! assert_eq!(Dimension::Force.format(266_893.3, UnitSet::Field), "60 klbf");
//! # Ok::<(), wholestring_units::QuantityError>(())
//! ```
//!
//! A quantity of another dimension, an unknown unit or a number without a unit is refused with a
//! sentence:
//!
//! ```
//! use wholestring_units::Dimension;
//!
//! let error = Dimension::Force.parse("6 bar").unwrap_err();
//! assert!(error.to_string().starts_with("'bar' is a unit of pressure; a force was expected"));
//! assert_eq!(error.span, 2..5);
//! ```
//!
//! # Ambiguous symbols
//! - `sg`, specific gravity, is relative to fresh water of exactly 1000 kg/m3, as mud reports use
//!   it.
//! - `psi/ft` and `kPa/m` as densities are the pressure gradient of a fluid at rest under standard
//!   gravity, 9.80665 m/s2.
//! - `lb` is a pound of mass where a mass is requested and a pound-force where a force is; `t` is
//!   1000 kg or their weight under standard gravity in the same way.
//! - `ton` is not accepted: it may be 2000 lb or 1000 kg. Write `t` or `tonfUS`.
//! - `MT` is a metric ton where a force or a mass is requested, `F` is feet where a length is, as
//!   in LAS and WITS.
//! - `20,000 ft` is twenty thousand: with field units a comma separates thousands. `1,500 m` may be
//!   either and is refused; `1,500,000 N` and `1 500 m` are unambiguous.
//! - `Hz` is one turn per second as a rotary speed, and 1/s as a frequency or rate.
//! - `usft` is the US survey foot, 1200/3937 m; `ft` is the international foot, 0.3048 m.
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod dimension;
mod error;
mod nearest;
mod number;
mod print;
mod symbol;
mod table;
mod thousands;
mod unit;
mod unit_set;

pub use dimension::Dimension;
pub use error::{QuantityError, QuantityErrorKind};
pub use print::{number_text, significant, without_trailing_zeros};
pub use unit::{Unit, Written};
pub use unit_set::{UnitSet, UnknownUnitSet};
