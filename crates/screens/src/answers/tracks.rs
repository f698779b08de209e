//! Values along the string, for tracks against depth.

use std::collections::BTreeMap;

use serde::Serialize;
use utoipa::{
    PartialSchema, ToSchema,
    openapi::{ObjectBuilder, Ref, RefOr, Schema},
};
use wholestring_results::Table;

use super::column::Column;
use crate::words::StaticModel;

/// Columns of `nodes.parquet` that are drawn against depth.
pub const DRAWN: &[&str] = &[
    "tension_N",
    "torque_N_m",
    "side_force_N_per_m",
    "bending_moment_N_m",
    "von_mises_stress_Pa",
    "contact_fraction",
];

/// Values along the string of an operation by a model, from the surface down.
#[derive(Debug, Serialize, ToSchema)]
pub struct Track {
    /// The model.
    #[schema(value_type = StaticModel)]
    model: String,
    /// The operation: `drill`, `trip_out`, ...
    operation: String,
    /// Measured depths, m.
    md_m: Column,
    /// The other columns by their names in `nodes.parquet`; a model omits those that it does not
    /// compute.
    #[serde(flatten)]
    #[schema(value_type = TrackColumns)]
    columns: BTreeMap<&'static str, Column>,
}

/// Description of the columns of a track.
#[derive(Debug)]
pub enum TrackColumns {}

impl PartialSchema for TrackColumns {
    fn schema() -> RefOr<Schema> {
        let object = ObjectBuilder::new().description(Some("Columns that a model computes."));
        let column = || Ref::from_schema_name(Column::name());
        DRAWN.iter().fold(object, |object, name| object.property(*name, column())).into()
    }
}

impl ToSchema for TrackColumns {}

impl Track {
    /// Number of depths.
    #[cfg(test)]
    pub(super) fn rows(&self) -> usize {
        self.md_m.len()
    }
}

/// A track for each operation and model in the table of the nodes.
pub fn tracks(nodes: &Table) -> Vec<Track> {
    let (Some(models), Some(operations)) = (nodes.words("model"), nodes.words("operation")) else {
        return Vec::new();
    };
    let mut tracks = Vec::new();
    let mut from = 0;
    while from < nodes.rows() {
        let key = (&models[from], &operations[from]);
        let is_of = |row: &usize| (&models[*row], &operations[*row]) == key;
        let rows = (from..nodes.rows()).take_while(is_of).count();
        let column = |name: &str| -> Option<Column> {
            let numbers = &nodes.numbers(name)?[from..from + rows];
            Some(numbers.iter().map(|number| number.unwrap_or(f64::NAN)).collect())
        };
        let pairs = DRAWN.iter().filter_map(|name| Some((*name, column(name)?)));
        tracks.push(Track {
            model: key.0.clone(),
            operation: key.1.clone(),
            md_m: column("md_m").unwrap_or_else(|| [].into_iter().collect()),
            columns: pairs.filter(|(_, column)| !column.is_blank()).collect(),
        });
        from += rows;
    }
    tracks
}
