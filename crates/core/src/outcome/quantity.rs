//! What a quantity of an answer is: its name, unit and meaning, who knows it, and where it comes
//! from.

use std::borrow::Cow;

use super::method::ModelKind;

/// Kind of a quantity (ISO 80000-1), as far as engineers read them in different units.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum QuantityKind {
    /// A ratio or a count.
    Ratio,
    /// A length, an offset or a displacement, m.
    Length,
    /// A measured depth, m.
    Depth,
    /// A force, N.
    Force,
    /// A torque or a bending moment, N·m.
    Torque,
    /// A force per length, N/m.
    ForcePerLength,
    /// A torque per length, N·m/m.
    TorquePerLength,
    /// A work per length, J/m.
    WorkPerLength,
    /// A power per length, W/m.
    PowerPerLength,
    /// A pressure, a stress or a work per volume, Pa.
    Pressure,
    /// An angle, rad.
    Angle,
    /// A curvature, rad/m.
    Curvature,
    /// A rotary speed or another angular velocity, rad/s.
    RotarySpeed,
    /// A speed, m/s.
    Speed,
    /// A rate of penetration, m/s.
    RateOfPenetration,
    /// A flow rate, m³/s.
    FlowRate,
    /// A time, s.
    Time,
    /// A frequency, Hz.
    Frequency,
}

impl QuantityKind {
    /// Symbol of its SI unit; empty of a ratio.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Ratio => "",
            Self::Length | Self::Depth => "m",
            Self::Force => "N",
            Self::Torque => "N·m",
            Self::ForcePerLength => "N/m",
            Self::TorquePerLength => "N·m/m",
            Self::WorkPerLength => "J/m",
            Self::PowerPerLength => "W/m",
            Self::Pressure => "Pa",
            Self::Angle => "rad",
            Self::Curvature => "rad/m",
            Self::RotarySpeed => "rad/s",
            Self::Speed | Self::RateOfPenetration => "m/s",
            Self::FlowRate => "m³/s",
            Self::Time => "s",
            Self::Frequency => "Hz",
        }
    }

    /// What the name of a quantity of this kind ends in: `_N_per_m`.
    pub fn suffix(self) -> String {
        match self.unit() {
            "" => String::new(),
            unit => {
                let ascii = unit.replace('·', "_").replace('/', "_per_");
                format!("_{}", ascii.replace('³', "3"))
            }
        }
    }
}

/// Name, unit and meaning of a quantity that answers hold, and who knows it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Quantity {
    /// Name in results, with the unit in it.
    pub name: &'static str,
    /// Unit symbol; empty where there is none.
    pub unit: &'static str,
    /// What it is, in one sentence.
    pub meaning: &'static str,
    /// Its kind; of words a ratio.
    pub kind: QuantityKind,
    /// Whether it is words rather than numbers.
    pub text: bool,
    /// The methods that know it; the others leave it out.
    pub known_by: &'static [ModelKind],
    /// Where a method that knows it has no value all the same (a text: empty); nothing where there
    /// always is one.
    pub null_where: Option<&'static str>,
}

/// The methods that answer in time.
pub(crate) const IN_TIME: &[ModelKind] = &[ModelKind::Dynamic];

impl Quantity {
    /// Words, which every method knows.
    pub const fn text(name: &'static str, meaning: &'static str) -> Self {
        Self { text: true, ..Self::number(name, QuantityKind::Ratio, meaning) }
    }

    /// Numbers, which every method knows.
    pub const fn number(name: &'static str, kind: QuantityKind, meaning: &'static str) -> Self {
        Self {
            name,
            unit: kind.unit(),
            meaning,
            kind,
            text: false,
            known_by: ModelKind::ALL,
            null_where: None,
        }
    }

    /// The same, known by these methods alone.
    pub const fn of(self, known_by: &'static [ModelKind]) -> Self {
        Self { known_by, ..self }
    }

    /// The same, without a value there.
    pub const fn null_where(self, place: &'static str) -> Self {
        Self { null_where: Some(place), ..self }
    }

    /// Whether a method has values of it.
    pub fn is_known_by(&self, model: ModelKind) -> bool {
        self.known_by.contains(&model)
    }

    /// Its name without the unit: `hook_load`.
    pub fn stem(&self) -> &'static str {
        self.name.strip_suffix(&self.kind.suffix()).unwrap_or(self.name)
    }
}

/// The values of a column.
#[derive(Debug, Clone, PartialEq)]
pub enum Values<'a> {
    /// Numbers; what is not one does not apply.
    Numbers(Cow<'a, [f64]>),
    /// Words.
    Words(Vec<&'static str>),
}

impl Values<'_> {
    /// How many there are.
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
}

/// A quantity that a `T` has a value of in each of its rows, and where they are.
#[derive(Debug)]
pub struct Column<T: 'static> {
    /// What it is.
    pub quantity: Quantity,
    /// Its values; none where the method that made the `T` leaves the quantity out.
    pub of: fn(&T) -> Values<'_>,
}

/// What a column of rows is kept as.
pub(crate) trait Rows {
    fn values(&self) -> Values<'_>;
}

impl Rows for Vec<f64> {
    fn values(&self) -> Values<'_> {
        Values::Numbers(Cow::Borrowed(self))
    }
}

impl Rows for Vec<Option<f64>> {
    fn values(&self) -> Values<'_> {
        let numbers = self.iter().map(|value| value.unwrap_or(f64::NAN));
        Values::Numbers(numbers.collect())
    }
}

/// The columns that a `T` of a method does not have as they are declared: one that the method knows
/// and that is shorter or longer than the others, and one that it does not know but has. By their
/// names.
pub(crate) fn unlike_declared<T>(
    columns: &'static [Column<T>],
    of: &T,
    model: ModelKind,
) -> Vec<&'static str> {
    let lengths: Vec<usize> = columns.iter().map(|column| (column.of)(of).len()).collect();
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
/// files: a column is a field that is kept (`name: Vec<f64>`), or words that follow from the others
/// (`name = |of| ..`), its kind and its meaning, and, where it is not so in all rows of all
/// methods, who knows it and where there is no value. What stands behind `beside` is no column.
macro_rules! columns {
    (
        $(#[$about:meta])*
        pub struct $name:ident, $list_about:literal $list:ident {
            $(
                $column:ident $(: $type:ty)? $(= $words:expr)? => $kind:ident, $meaning:literal
                $(, known_by $known_by:expr)? $(, null_where $null_where:literal)?;
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
                    $(.of($known_by))? $(.null_where($null_where))?,
                of: columns!(@of $column $(: $type)? $(= $words)?),
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
    (@of $column:ident: $type:ty) => {
        |of| $crate::outcome::Rows::values(&of.$column)
    };
    (@of $column:ident = $words:expr) => {
        |of| $crate::outcome::Values::Words($words(of))
    };
}
pub(crate) use columns;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn those_in_time_are_as_the_methods_say() {
        let all = ModelKind::ALL.iter().copied();
        let in_time: Vec<ModelKind> = all.filter(|of| of.in_time()).collect();
        assert_eq!(in_time, IN_TIME);
    }

    #[test]
    fn a_name_without_its_unit() {
        for (name, kind, stem) in [
            ("hook_load_N", QuantityKind::Force, "hook_load"),
            ("friction_torque_N_m_per_m", QuantityKind::TorquePerLength, "friction_torque"),
            ("flow_rate_m3_per_s", QuantityKind::FlowRate, "flow_rate"),
            ("contact_fraction", QuantityKind::Ratio, "contact_fraction"),
        ] {
            assert_eq!(Quantity::number(name, kind, "").stem(), stem);
        }
    }
}
