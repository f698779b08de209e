//! Columns of rows: their declarations, and access to their values.

use std::borrow::Cow;

use super::{
    method::ModelKind,
    quantity::{Quantity, is_same},
};

/// The values of a column.
#[derive(Debug, Clone, PartialEq)]
pub enum Values<'a> {
    /// Numbers; NaN where the value does not apply.
    Numbers(Cow<'a, [f64]>),
    /// Words.
    Words(Vec<&'static str>),
}

impl Values<'_> {
    /// Number of values.
    pub fn len(&self) -> usize {
        match self {
            Self::Numbers(values) => values.len(),
            Self::Words(values) => values.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The numbers; none of words.
    pub fn numbers(&self) -> &[f64] {
        match self {
            Self::Numbers(values) => values,
            Self::Words(_) => &[],
        }
    }
}

impl<'a> Values<'a> {
    /// The numbers as they are stored; none for words and for a column with gaps.
    pub(crate) fn kept(self) -> Option<&'a [f64]> {
        match self {
            Self::Numbers(Cow::Borrowed(values)) => Some(values),
            Self::Numbers(Cow::Owned(_)) | Self::Words(_) => None,
        }
    }
}

/// A quantity of which a `T` has a value in each of its rows, and the access to those values.
#[derive(Debug)]
pub struct Column<T: 'static> {
    /// Declaration of the quantity.
    pub quantity: Quantity,
    /// Its values; none where the method that made the `T` does not provide the quantity.
    pub of: fn(&T) -> Values<'_>,
    /// The same from a row on, counted from zero, without reading those before it.
    pub rows_from: fn(&T, usize) -> Values<'_>,
    /// Drops the first rows of it.
    pub(crate) drop_first: fn(&mut T, usize),
    /// Its statistics over a window; none where none are taken.
    pub statistics: Option<WindowStatistics>,
}

impl<T> Column<T> {
    /// The declaration of the column of that name.
    ///
    /// # Panics
    /// Where there is none: in a constant this is a compile error.
    pub const fn declared(columns: &'static [Self], name: &str) -> &'static Quantity {
        &Self::named(columns, name).quantity
    }

    /// The column of that name.
    ///
    /// # Panics
    /// Where there is none: in a constant this is a compile error.
    pub const fn named(columns: &'static [Self], name: &str) -> &'static Self {
        let mut place = 0;
        while place < columns.len() {
            if is_same(columns[place].quantity.name, name) {
                return &columns[place];
            }
            place += 1;
        }
        panic!("no column of that name is declared")
    }
}

/// Statistics of a column over a window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WindowStatistics {
    /// Its place among all statistics, counted from one.
    pub place: usize,
    /// Scale of its drift.
    pub scale: DriftScale,
}

/// Scale on which a drift of a scalar is measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DriftScale {
    /// The largest force along the string: hook load, axial friction or weight on bit.
    Force,
    /// The largest torque.
    Torque,
    /// Its own magnitude, but at least this value, in its unit.
    Own(f64),
}

/// Storage of a column of rows.
pub(crate) trait Rows {
    fn values_from(&self, row: usize) -> Values<'_>;

    /// Drops the first rows.
    fn drop_first(&mut self, rows: usize);
}

impl Rows for Vec<f64> {
    fn values_from(&self, row: usize) -> Values<'_> {
        Values::Numbers(Cow::Borrowed(self.get(row..).unwrap_or_default()))
    }

    fn drop_first(&mut self, rows: usize) {
        self.drain(..rows.min(self.len()));
    }
}

impl Rows for Vec<Option<f64>> {
    fn values_from(&self, row: usize) -> Values<'_> {
        let rows = self.get(row..).unwrap_or_default();
        Values::Numbers(rows.iter().map(|value| value.unwrap_or(f64::NAN)).collect())
    }

    fn drop_first(&mut self, rows: usize) {
        self.drain(..rows.min(self.len()));
    }
}

/// Names of the columns that in the table of a method differ from their declaration: columns that
/// the method provides and that are shorter or longer than the others, and columns that it has
/// though it does not provide them.
pub(crate) fn unlike_declared<T>(
    columns: &'static [Column<T>],
    table: &T,
    model: ModelKind,
) -> Vec<&'static str> {
    let lengths: Vec<usize> = columns.iter().map(|column| (column.of)(table).len()).collect();
    let rows = lengths.iter().copied().max().unwrap_or(0);
    let declared = |column: &Column<T>| match column.quantity.is_known_by(model) {
        true => rows,
        false => 0,
    };
    let columns = columns.iter().zip(lengths);
    columns
        .filter(|(column, length)| *length != declared(column))
        .map(|(column, _)| column.quantity.name)
        .collect()
}

/// Declares a structure of columns and the list of their [`Column`]s at once, in the order of the
/// files: a column is a stored field (`name: Vec<f64>`), or texts that follow from the others
/// (`name = |table| ..`), its kind and its meaning, its label where that differs from its name,
/// and, where it is not available in all rows of all methods, the methods that provide it and the
/// rows without a value; for a scalar whose statistics are taken, its place among them and the
/// scale of its drift. Fields after `beside` are no columns.
macro_rules! columns {
    (
        $(#[$about:meta])*
        pub struct $name:ident, $list_about:literal $list:ident {
            $(
                $column:ident $(: $type:ty)? $(= $words:expr)? => $kind:ident, $meaning:literal
                $(, label $label:literal)? $(, known_by $known_by:expr)? $(, null_where $null_where:literal)?
                $(, statistics $place:literal on $scale:expr)?;
            )*
        }
        $(beside { $($(#[$other_about:meta])* $other:ident: $other_type:ty;)* })?
    ) => {
        $(#[$about])*
        pub struct $name {
            $($(
                #[doc = $meaning]
                #[doc = ""]
                #[doc = concat!("Kind: `", stringify!($kind), "`.")]
                pub $column: $type,
            )?)*
            $($($(#[$other_about])* pub $other: $other_type,)*)?
        }

        #[doc = $list_about]
        pub const $list: &[$crate::outcome::Column<$name>] = &[$(
            $crate::outcome::Column {
                quantity: columns!(@quantity $column, $kind, $meaning $(, words $words)?)
                    $(.labelled($label))? $(.of($known_by))? $(.null_where($null_where))?,
                of: columns!(@values $column $(: $type)? $(= $words)?),
                rows_from: columns!(@rows_from $column $(: $type)? $(= $words)?),
                drop_first: columns!(@drop_first $column $(: $type)? $(= $words)?),
                statistics: columns!(@statistics $($place on $scale)?),
            },
        )*];
    };
    (@quantity $column:ident, $kind:ident, $meaning:literal, words $words:expr) => {
        $crate::outcome::Quantity::text(stringify!($column), $meaning)
    };
    (@quantity $column:ident, $kind:ident, $meaning:literal) => {
        $crate::outcome::Quantity::number(
            stringify!($column),
            $crate::outcome::QuantityKind::$kind,
            $meaning,
        )
    };
    (@statistics) => {
        None
    };
    (@statistics $place:literal on $scale:expr) => {
        Some($crate::outcome::WindowStatistics { place: $place, scale: $scale })
    };
    (@values $column:ident: $type:ty) => {
        |table| $crate::outcome::Rows::values_from(&table.$column, 0)
    };
    (@values $column:ident = $words:expr) => {
        |table| $crate::outcome::Values::Words($words(table))
    };
    (@rows_from $column:ident: $type:ty) => {
        |table, row| $crate::outcome::Rows::values_from(&table.$column, row)
    };
    (@rows_from $column:ident = $words:expr) => {
        |table, row| $crate::outcome::Values::Words($words(table).into_iter().skip(row).collect())
    };
    (@drop_first $column:ident: $type:ty) => {
        |table, rows| $crate::outcome::Rows::drop_first(&mut table.$column, rows)
    };
    (@drop_first $column:ident = $words:expr) => {
        |_, _| ()
    };
}
pub(crate) use columns;
