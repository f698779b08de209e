//! Columns of samples and of frames, in the order of sending.

use serde::Serialize;
use utoipa::ToSchema;
use wholestring::{
    dynamics::{FRAME, Frame},
    outcome::{Column, TIME_SERIES, TimeSeries, Values},
};

/// Columns of the strip charts, by their names in `time.parquet`.
const SAMPLED: [&str; 16] = [
    "hook_load_N",
    "surface_torque_N_m",
    "bit_torque_N_m",
    "rotary_speed_rad_per_s",
    "rotary_speed_set_rad_per_s",
    "bit_rotary_speed_rad_per_s",
    "weight_on_bit_N",
    "weight_on_bit_set_N",
    "rate_of_penetration_m_per_s",
    "pump_pressure_Pa",
    "flow_rate_m3_per_s",
    "block_velocity_m_per_s",
    "block_velocity_set_m_per_s",
    "bit_depth_m",
    "friction_torque_N_m",
    "motor_speed_rad_per_s",
];

/// Columns of a frame, by their names in `frames.parquet`.
const FRAMED: [&str; 9] = [
    "md_m",
    "offset_high_m",
    "offset_right_m",
    "velocity_high_m_per_s",
    "velocity_right_m_per_s",
    "rotary_speed_rad_per_s",
    "torque_N_m",
    "tension_N",
    "contact_force_N",
];

/// Number of columns of a sample.
pub(super) const SAMPLE_COLUMNS: usize = SAMPLED.len();

/// Number of columns of a frame.
pub(super) const FRAME_COLUMNS: usize = FRAMED.len();

/// A column of samples or of frames.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub struct Channel {
    /// Its name, with the SI unit in it.
    name: &'static str,
    /// Its name for display.
    label: String,
    /// Its dimension, whose display units are in `units` of the layout.
    dimension: &'static str,
    /// Its meaning.
    meaning: &'static str,
}

fn declared<T>(columns: &'static [Column<T>], name: &str) -> Option<&'static Column<T>> {
    columns.iter().find(|column| column.quantity.name == name)
}

fn channels<T>(columns: &'static [Column<T>], names: &[&str]) -> Vec<Channel> {
    let known = names.iter().filter_map(|name| declared(columns, name));
    let channel = |column: &'static Column<T>| Channel {
        name: column.quantity.name,
        label: column.quantity.label(),
        dimension: column.quantity.kind.dimension(),
        meaning: column.quantity.meaning,
    };
    known.map(channel).collect()
}

/// The columns of a sample.
pub(super) fn sampled() -> Vec<Channel> {
    channels(TIME_SERIES, &SAMPLED)
}

/// The columns of a frame.
pub(super) fn framed() -> Vec<Channel> {
    channels(FRAME, &FRAMED)
}

/// The numbers of a column from this row on; missing values are NaN.
fn numbers<'a, T>(
    columns: &'static [Column<T>],
    name: &str,
    table: &'a T,
    row: usize,
) -> Option<std::borrow::Cow<'a, [f64]>> {
    match (declared(columns, name)?.rows_from)(table, row) {
        Values::Numbers(numbers) => Some(numbers),
        Values::Words(_) => None,
    }
}

/// The rows of a series from this one on, one after the other.
pub(super) fn sample_rows(series: &TimeSeries, row: usize) -> Vec<f32> {
    let rows = series.time_s.len().saturating_sub(row);
    let mut values = vec![f32::NAN; rows * SAMPLE_COLUMNS];
    for (place, name) in SAMPLED.iter().enumerate() {
        let column = numbers(TIME_SERIES, name, series, row);
        for (value, number) in values[place..]
            .iter_mut()
            .step_by(SAMPLE_COLUMNS)
            .zip(column.as_deref().unwrap_or_default())
        {
            *value = *number as f32;
        }
    }
    values
}

/// The columns of a frame, one after the other.
pub(super) fn frame_columns(frame: &Frame) -> Vec<f32> {
    let mut values = Vec::with_capacity(frame.md_m.len() * FRAME_COLUMNS);
    for name in FRAMED {
        if let Some(column) = numbers(FRAME, name, frame, 0) {
            values.extend(column.iter().map(|number| *number as f32));
        }
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_column_is_declared() {
        assert_eq!(sampled().len(), SAMPLE_COLUMNS);
        assert_eq!(framed().len(), FRAME_COLUMNS);
    }

    #[test]
    fn a_row_has_its_numbers_in_the_order_of_the_columns() {
        let mut series = TimeSeries { time_s: vec![0.1, 0.2], ..TimeSeries::default() };
        series.hook_load_N = vec![1e6, 2e6];
        series.pump_pressure_Pa = vec![None, Some(3e5)];
        let rows = sample_rows(&series, 1);
        assert_eq!(rows.len(), SAMPLE_COLUMNS);
        let rows =
            |name: &str| rows[SAMPLED.iter().position(|column| *column == name).expect("a column")];
        assert_eq!((rows("hook_load_N"), rows("pump_pressure_Pa")), (2e6, 3e5));
        assert!(rows("bit_depth_m").is_nan());
        let before = sample_rows(&series, 0);
        assert!(
            before[SAMPLED.iter().position(|column| *column == "pump_pressure_Pa").unwrap()]
                .is_nan()
        );
    }
}
