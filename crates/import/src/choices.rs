//! Choices of the user that files do not contain.

use std::{
    cell::RefCell,
    collections::{BTreeMap, BTreeSet},
};

use wholestring_units::{Dimension, Unit};

use crate::{error::ImportErrorKind, fragment::Value};

/// Units and values that files do not give, and selections where a file holds several items.
///
/// On the command line they are `--unit NAME=UNIT`, `--value NAME=QUANTITY` and `--pick WHAT=NAME`.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Choices {
    units: BTreeMap<String, String>,
    values: BTreeMap<String, String>,
    picks: BTreeMap<String, String>,
    /// Names of the choices that a file used.
    used: RefCell<BTreeSet<String>>,
}

impl Choices {
    /// Sets a unit: `md` is in `ft`.
    pub fn unit(mut self, name: impl Into<String>, unit: impl Into<String>) -> Self {
        self.units.insert(name.into(), unit.into());
        self
    }

    /// Sets a value: `block-weight` is `25 tf`.
    pub fn value(mut self, name: impl Into<String>, quantity: impl Into<String>) -> Self {
        self.values.insert(name.into(), quantity.into());
        self
    }

    /// Picks one of several: the `tubular` called `BHA 7`.
    pub fn pick(mut self, what: impl Into<String>, name: impl Into<String>) -> Self {
        self.picks.insert(what.into(), name.into());
        self
    }

    /// Returns the unit given for a quantity, by the first of its names that has one.
    ///
    /// # Errors
    /// The unit given does not have the dimension.
    pub(crate) fn unit_of(
        &self,
        names: &[&str],
        dimension: Dimension,
    ) -> Result<Option<&'static Unit>, ImportErrorKind> {
        let Some((name, symbol)) = names.iter().find_map(|name| self.said(name)) else {
            return Ok(None);
        };
        let unit = dimension.find_unit(symbol);
        let wrong = || ImportErrorKind::SaidUnit {
            name: name.to_owned(),
            said: symbol.to_owned(),
            dimension,
        };
        unit.map(Some).ok_or_else(wrong)
    }

    /// Returns the text of `--unit NAME=` for a name, as written.
    pub(crate) fn said(&self, name: &str) -> Option<(&str, &str)> {
        let (name, symbol) = self.units.get_key_value(name)?;
        self.used.borrow_mut().insert(format!("--unit {name}"));
        Some((name, symbol))
    }

    /// Returns the value given for a name, in the unit given.
    ///
    /// # Errors
    /// The value given is not a quantity of the dimension.
    pub(crate) fn quantity(
        &self,
        name: &str,
        dimension: Dimension,
    ) -> Result<Option<Value>, ImportErrorKind> {
        let Some(said) = self.values.get(name) else { return Ok(None) };
        self.used.borrow_mut().insert(format!("--value {name}"));
        match dimension.read(said) {
            Ok(written) => Ok(Some(Value::quantity(written.number, written.unit))),
            Err(error) => Err(ImportErrorKind::SaidValue {
                name: name.to_owned(),
                said: said.clone(),
                reason: error.to_string(),
            }),
        }
    }

    /// Returns the picked name of one of several.
    pub(crate) fn picked(&self, what: &str) -> Option<&str> {
        let name = self.picks.get(what)?;
        self.used.borrow_mut().insert(format!("--pick {what}"));
        Some(name)
    }

    /// Returns the choices that no file used, as options.
    pub(crate) fn unused(&self) -> Vec<String> {
        let units = self.units.keys().map(|name| format!("--unit {name}"));
        let values = self.values.keys().map(|name| format!("--value {name}"));
        let all = units.chain(values).chain(self.picks.keys().map(|what| format!("--pick {what}")));
        let used = self.used.borrow();
        all.filter(|option| !used.contains(option)).collect()
    }
}
