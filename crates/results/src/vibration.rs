//! Rows of the tables of linear vibration that the summary does not contain.

use crate::row::rows;

rows! {
    /// Displacement of a node in a natural mode.
    #[derive(Debug, Clone, PartialEq)]
    pub struct ModeShapeRow {
        family: String => Words, "As in `modes.parquet`";
        number: usize => Ratio, "As in `modes.parquet`";
        md_m: f64 => Depth, "Measured depth of the node";
        high_m: f64 => Length,
            "Displacement towards the high side, in phase with the largest; the largest is 1 m, \
             for a torsional mode the largest turn is 1 rad";
        right_m: f64 => Length,
            "Displacement to the right of it as one looks down the hole, in phase";
        high_later_m: f64 => Length,
            "Displacement towards the high side a quarter of a period later";
        right_later_m: f64 => Length, "Displacement to the right a quarter of a period later";
        along_m: f64 => Length, "Axial displacement, in phase";
        turn_rad: f64 => Angle, "Turn about the axis, in phase";
    }

    /// Columns of `mode_shapes.parquet`: a row for each mode at each node that moves with it.
    pub const MODE_SHAPES, read;
}

rows! {
    /// Natural frequency of a branch at a rotary speed.
    #[derive(Debug, Clone, PartialEq)]
    pub struct CampbellRow {
        branch: usize => Ratio, "Number of the branch, from 0: lateral ones first";
        family: String => Words, "As in `modes.parquet`";
        number: usize => Ratio, "Number within the family, from 1";
        whirl: Option<String> => Words,
            "At the fastest speed: `forward`, `backward` or `planar`; empty for other families",
            null_where "the mode is not lateral";
        rotary_speed_rad_per_s: f64 => RotarySpeed, "Rotary speed";
        frequency_Hz: f64 => Frequency, "Natural frequency";
    }

    /// Columns of `campbell.parquet`: a row for each branch at each rotary speed.
    pub const CAMPBELL, read;
}

rows! {
    /// Response of the assembly at a rotary speed.
    #[derive(Debug, Clone, PartialEq)]
    pub struct ResponseRow {
        rotary_speed_rad_per_s: f64 => RotarySpeed, "Rotary speed";
        amplitude_m: f64 => Length,
            "Largest displacement of a node of the assembly from its position at rest";
        amplitude_md_m: f64 => Depth, "Measured depth of that node";
        bending_stress_Pa: f64 => Stress, "Largest bending stress added by the vibration";
        bending_stress_md_m: f64 => Depth, "Measured depth of that stress";
        component: String => Words, "The component of that stress";
    }

    /// Columns of `response.parquet`: a row for each rotary speed.
    pub const RESPONSE, read;
}
