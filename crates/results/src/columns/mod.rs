//! Columns of the tables of a run. The engine declares the quantities of its answers itself; this
//! module declares the tables made of them, and the columns that several tables share.
//!
//! Rows of other commands are declared with their columns: [`crate::row::rows`].

mod contact;
mod frames;
mod nodes;
mod time;
mod wear;

pub use self::{contact::CONTACT, frames::FRAMES, nodes::NODES, time::TIME, wear::WEAR};
use wholestring::outcome;

/// Name, unit and meaning of a column.
pub type ColumnSpec = outcome::Quantity;

/// Model of the rows.
pub(crate) const MODEL: ColumnSpec = ColumnSpec::text("model", outcome::ModelKind::LISTED);

/// Level of friction of the rows.
pub(crate) const FRICTION: ColumnSpec = ColumnSpec::text("friction", "`low`, `expected` or `high`");

/// Operation of the rows.
pub(crate) const OPERATION: ColumnSpec = ColumnSpec::text("operation", "`trip_out`, `drill`, ...");

/// The columns of a table: the quantities that the engine declares, between the columns that
/// identify the rows and those added to them.
///
/// # Panics
/// If `N` is not the total number of columns.
const fn table<T, const N: usize>(
    whose: &[ColumnSpec],
    declared: &[outcome::Column<T>],
    added: &[ColumnSpec],
) -> [ColumnSpec; N] {
    assert!(whose.len() + declared.len() + added.len() == N);
    let mut all = [OPERATION; N];
    let mut place = 0;
    while place < N {
        all[place] = if place < whose.len() {
            whose[place]
        } else if place < whose.len() + declared.len() {
            declared[place - whose.len()].quantity
        } else {
            added[place - whose.len() - declared.len()]
        };
        place += 1;
    }
    all
}

#[cfg(test)]
mod tests {
    use wholestring::dynamics::{Channel, FRAME};

    #[test]
    fn every_column_of_a_frame_is_of_one_channel() {
        let mut names: Vec<&str> =
            Channel::ALL.iter().flat_map(|channel| channel.columns()).copied().collect();
        names.push("md_m");
        names.sort_unstable();
        let mut declared: Vec<&str> = FRAME.iter().map(|column| column.quantity.name).collect();
        declared.sort_unstable();
        assert_eq!(names, declared);
    }
}
