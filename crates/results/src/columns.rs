//! Columns of the tables of a run. The engine declares the quantities of its answers itself; this
//! module declares the tables made of them, and the columns that several tables share.
//!
//! Rows of other commands are declared with their columns: [`crate::row::rows`].

use wholestring::{
    dynamics::FRAME,
    outcome::{self, CONTACT_MAP, HOLE_WEAR, PROFILE, QuantityKind, TIME_SERIES},
};

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

// Columns of `nodes.parquet`.

/// Columns of `nodes.parquet`: the profile along the string, one row per node, from the surface to
/// the bit, for each model and operation.
pub const NODES: &[ColumnSpec] =
    &table::<_, { PROFILE.len() + 2 }>(&[MODEL, OPERATION], PROFILE, &[]);

// Columns of `time.parquet`.

/// Note of the schedule's line for a row.
const NOTE: ColumnSpec =
    ColumnSpec::text("note", "Note of the line of the schedule that began last; empty without one")
        .null_where("no line of the schedule with a note has begun");

/// Columns of `time.parquet`: the scalars against time, one row per sample, for each operation that
/// was solved by dynamics.
pub const TIME: &[ColumnSpec] =
    &table::<_, { TIME_SERIES.len() + 2 }>(&[OPERATION], TIME_SERIES, &[NOTE]);

// Columns of `wear.parquet`.

/// Columns of `wear.parquet`: the work of friction on the hole, one row per 5 m of hole, from the
/// surface down, for each model and operation.
pub const WEAR: &[ColumnSpec] =
    &table::<_, { HOLE_WEAR.len() + 2 }>(&[MODEL, OPERATION], HOLE_WEAR, &[]);

// Columns of `contact.parquet`.

/// Columns of `contact.parquet`: contact over depth and time, coarse, for each operation that was
/// solved by dynamics.
pub const CONTACT: &[ColumnSpec] =
    &table::<_, { CONTACT_MAP.len() + 1 }>(&[OPERATION], CONTACT_MAP, &[]);

// Columns of `frames.parquet`.

const TIME_S: ColumnSpec = ColumnSpec::number(
    "time_s",
    QuantityKind::Time,
    "Simulated time from the start, settling included",
);

const NODE: ColumnSpec =
    ColumnSpec::number("node", QuantityKind::Ratio, "Number of the node, from 0 at the surface");

/// Columns of `frames.parquet`: the whole string, a row per node of every frame. Channels that were
/// not requested have no column.
pub const FRAMES: &[ColumnSpec] =
    &table::<_, { FRAME.len() + 3 }>(&[OPERATION, TIME_S, NODE], FRAME, &[]);

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
