//! Every column of every table: name, unit and meaning in one place.

mod bit_test;
mod bottom_hole;
mod contact;
mod frames;
mod nodes;
mod spectra;
mod time;
mod wear;

pub use self::{
    bit_test::BIT_TEST, bottom_hole::BOTTOM_HOLE, contact::CONTACT, frames::FRAMES, nodes::NODES,
    spectra::SPECTRA, time::TIME, wear::WEAR,
};
use wholestring::outcome::ModelKind;

/// The models that tell of a string in time.
const DYNAMIC: &[ModelKind] = &[ModelKind::Dynamic];

/// Every model.
const EVERY: &[ModelKind] = &[ModelKind::Soft, ModelKind::Dynamic];

/// Name, unit and meaning of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ColumnSpec {
    /// Name in the file, with the unit in it.
    pub name: &'static str,
    /// Unit symbol; empty where there is none.
    pub unit: &'static str,
    /// What it holds, in one sentence.
    pub meaning: &'static str,
    /// Whether it holds words rather than numbers.
    pub text: bool,
    /// The models that know it; in rows of the others it is `null`.
    pub known_by: &'static [ModelKind],
    /// Where a model that knows it has no value all the same, and it is `null` (a text: empty); nothing where there
    /// always is one.
    pub null_where: Option<&'static str>,
}

impl ColumnSpec {
    const fn text(name: &'static str, meaning: &'static str) -> Self {
        Self {
            name,
            unit: "",
            meaning,
            text: true,
            known_by: EVERY,
            null_where: None,
        }
    }

    const fn number(name: &'static str, unit: &'static str, meaning: &'static str) -> Self {
        Self {
            name,
            unit,
            meaning,
            text: false,
            known_by: EVERY,
            null_where: None,
        }
    }

    /// The same, known by these models alone.
    const fn of(self, known_by: &'static [ModelKind]) -> Self {
        Self { known_by, ..self }
    }

    /// The same, without a value there.
    const fn null_where(self, place: &'static str) -> Self {
        Self {
            null_where: Some(place),
            ..self
        }
    }

    /// Whether a model has values of it.
    pub fn is_known_by(&self, model: ModelKind) -> bool {
        self.known_by.contains(&model)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique_and_end_in_their_unit() {
        for table in [
            NODES,
            TIME,
            WEAR,
            CONTACT,
            BOTTOM_HOLE,
            FRAMES,
            SPECTRA,
            BIT_TEST,
        ] {
            for (index, column) in table.iter().enumerate() {
                assert!(
                    table[..index].iter().all(|other| other.name != column.name),
                    "{} stands twice",
                    column.name
                );
                let suffix = match column.unit {
                    "" => "",
                    "m" => "_m",
                    "s" => "_s",
                    "N" => "_N",
                    "rad" => "_rad",
                    "N·m" => "_N_m",
                    "N/m" => "_N_per_m",
                    "N·m/m" => "_N_m_per_m",
                    "J/m" => "_J_per_m",
                    "W/m" => "_W_per_m",
                    "m/s" => "_m_per_s",
                    "m³/s" => "_m3_per_s",
                    "rad/s" => "_rad_per_s",
                    "Pa" => "_Pa",
                    "Hz" => "_Hz",
                    other => panic!("{}: unknown unit {other}", column.name),
                };
                assert!(column.name.ends_with(suffix), "{}", column.name);
            }
        }
    }

    /// Whoever reads what a column means is told that it may be `null`.
    #[test]
    fn a_column_that_may_be_null_says_so() {
        let tables = [
            NODES,
            TIME,
            WEAR,
            CONTACT,
            BOTTOM_HOLE,
            FRAMES,
            SPECTRA,
            BIT_TEST,
        ];
        for column in tables.into_iter().flatten() {
            let says = column.meaning.contains("`null`") || column.meaning.contains("empty");
            assert_eq!(says, column.null_where.is_some(), "{}", column.name);
        }
    }
}
