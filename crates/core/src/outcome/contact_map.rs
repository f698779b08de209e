//! Contact over depth and time, declared once.

use serde::{Deserialize, Serialize};

use super::{column::columns, method::IN_TIME};

columns! {
    /// Contact over depth and time, coarse: row after row in time, each from the surface down.
    /// There is one stretch of string per column of a row, at most 200 of them, and each row is an
    /// average over the time since the one before, at most 201.
    #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
    pub struct ContactMap, "Columns of a map of contact, in the order of `contact.parquet`."
    CONTACT_MAP {
        time_s: Vec<f64> => Time,
            "Simulated time at the end of the average, settling included", known_by IN_TIME;
        md_m: Vec<f64> => Depth,
            "Measured depth of the middle of the stretch of string", known_by IN_TIME;
        side_force_N_per_m: Vec<f64> => ForcePerLength,
            "Mean side force per length since the time before; positive where the string lies on \
             the high side",
            known_by IN_TIME;
        contact_force_N_per_m: Vec<f64> => ForcePerLength,
            "Mean magnitude of the contact force per length since the time before",
            known_by IN_TIME;
    }
}
