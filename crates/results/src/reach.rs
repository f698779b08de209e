//! `summary.json` of a reach: the depth that a well can reach, and the limit that stops it.

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use wholestring::operation::OperationKind;
use wholestring_judge::{Check, DepthLimit};

use crate::{
    ResultsError, Row, Table, UncertainSummary,
    json::{read_versioned, write_json},
    row::rows,
};

/// Version of the layout of the files of a reach; raised when a key changes or is removed. 2:
/// `checks`. All versions are read.
pub const REACH_VERSION: u32 = 2;

/// `summary.json` of a reach.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReachSummary {
    /// [`REACH_VERSION`] of the program that wrote it.
    pub schema_version: u32,
    /// Name of the case.
    pub case: String,
    /// The case's settings with all defaults filled in.
    pub settings: Value,
    /// First depth of the bit that was examined, m.
    pub from_m: f64,
    /// Last depth of the bit, m.
    pub to_m: f64,
    /// Inclination of the direction in which the well continues, rad.
    pub inclination_rad: f64,
    /// Whether the wall force of a helix causes friction.
    pub helix_side_force: bool,
    /// Whether the string counts as stopped where its helix begins, although it would continue
    /// buckled.
    #[serde(default)]
    pub stop_at_helix: bool,
    /// Operations that were left out, and the reasons, a sentence for each.
    pub left_out: Vec<String>,
    /// Limits that were not checked, and the missing numbers, a phrase for each.
    #[serde(default)]
    pub unchecked: Vec<String>,
    /// The answers, a friction after the other.
    pub frictions: Vec<ReachOfFriction>,
    /// A check for each operation at each friction: the depth that it reaches, and the limit that
    /// stops it.
    #[serde(default)]
    pub checks: Vec<ReachCheck>,
    /// Effect of uncertain numbers; none where all are exact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uncertain: Option<UncertainSummary>,
}

/// A check of an operation at one friction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReachCheck {
    /// The operation: `drill`, `slide`, ...
    pub operation: OperationKind,
    /// Friction factor of all sections; none where the sections have the case's own.
    pub friction: Option<f64>,
    /// The check; its value is the depth that the bit reaches, m, its limit the last depth that was
    /// tried.
    #[serde(flatten)]
    pub check: Check,
}

/// Reach of the well at one friction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReachOfFriction {
    /// Friction factor of all sections; none where the sections have the case's own.
    pub friction: Option<f64>,
    /// Axial friction factor of the section in which the well continues.
    pub friction_at_bit: f64,
    /// Inclination, rad, to which a string slides down by its own weight at that friction,
    /// `atan(1/μ)`; none without friction.
    #[serde(default)]
    pub critical_inclination_rad: Option<f64>,
    /// Limit that stops it first; none where nothing does.
    pub first: Option<ReachStop>,
    /// Each limit of each operation.
    pub limits: Vec<ReachLimit>,
    /// Operations that were not solved because the work was interrupted: one of them may stop the
    /// well earlier.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub missing: Vec<OperationKind>,
}

/// Limit that stops a well.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReachStop {
    /// The operation: `drill`, `slide`, ...
    pub operation: OperationKind,
    /// The limit: `top_drive`, `hook_load_zero`, ...
    pub limit: DepthLimit,
    /// Depth of the bit, m.
    pub depth_m: f64,
}

rows! {
    /// A limit of an operation.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct ReachLimit {
        operation: OperationKind => Words, "As in `reach.parquet`";
        limit: DepthLimit => Words, "As in `reach.parquet`";
        friction = |_| friction => Ratio,
            "As in `reach.parquet`, `null` where the sections have the case's own",
            null_where "the sections have the case's own";
        title: String, "The limit in words";
        stops: bool => Ratio, "1 where the string stops there, 0 where it continues buckled";
        depth_m: Option<f64> => Depth,
            "Depth of the bit where it is first reached, `null` where it is not reached",
            null_where "it is not reached";
        already: bool => Ratio, "1 where it is reached at the first depth already, else 0";
        #[serde(default)]
        locked_up_m: Option<f64> => Depth,
            "Depth of the bit where the string locks up before it reaches the limit, `null` where \
             it does not",
            null_where "the string does not lock up before";
        margin_at_from: Option<f64> => Ratio,
            "`margin` at the first depth, `null` for a string that is locked up",
            null_where "the string is locked up";
        margin_at_to: Option<f64> => Ratio,
            "`margin` at the last depth, `null` for a string that is locked up",
            null_where "the string is locked up";
        at_md_m: Option<f64>, "As `md_m` in `reach_limits.parquet`";
        md_m = |limit| limit.at_md_m => Depth,
            "Measured depth of the smallest margin in the string at that depth of the bit, or at \
             the last depth where it is not reached; `null` for a limit at the surface",
            null_where "it is a limit at the surface, or nothing is compressed";
    }

    /// Columns of `reach_limits.parquet`: a row for each limit of each operation and friction.
    pub const REACH_LIMITS with friction: Option<f64>;
}

rows! {
    /// Margin of a limit at a depth of the bit.
    #[derive(Debug, Clone, PartialEq)]
    pub struct ReachMargin {
        operation: OperationKind => Words, "`trip_out`, `drill`, ...";
        limit: DepthLimit => Words,
            "`top_drive`, `breakaway`, `hoist`, `pump_pressure`, `hook_load_zero`, `push_spent`, \
             `push_absorbed`, `make_up`, `torsion`, `yield_strength`, `strength`, `helix`, \
             `sinusoid`, `vertical_helix` or `vertical_sinusoid`";
        friction: Option<f64> => Ratio,
            "Friction factor of all sections, `null` where they have the case's own",
            null_where "the sections have the case's own";
        bit_depth_m: f64 => Depth, "Measured depth of the bit";
        margin: f64 => Ratio,
            "Remaining part of the limit, zero where it is reached and negative beyond; for \
             `push_absorbed` the part of an added push that reaches the bit; `null` for a string \
             that is locked up",
            null_where "the string is locked up";
        force_N: Option<f64> => Force,
            "Force compared with a limit: hook load, with the block for `hoist`, with the push for \
             `push_spent`; compression; else `null`",
            null_where "the limit is no force, or the string is locked up";
        force_limit_N: Option<f64> => Force,
            "Its limit: capacity, zero, critical load; else `null`",
            null_where "the limit is no force, nothing is compressed, or the string is locked up";
        torque_N_m: Option<f64> => Torque,
            "Torque compared with a limit: at the surface for `top_drive` and `breakaway`, at \
             `md_m` for `make_up` and `torsion`; else `null`",
            null_where "the limit is no torque, or the string is locked up";
        torque_limit_N_m: Option<f64> => Torque,
            "Its limit: rated or peak torque of the top drive, capacity of connection or pipe, \
             over the required factor; else `null`",
            null_where "the limit is no torque, or no component with a known capacity turns";
        md_m: Option<f64> => Depth,
            "Measured depth of the smallest margin in the string, `null` for a limit at the \
             surface",
            null_where "it is a limit at the surface, or nothing is compressed";
    }

    /// Columns of `reach.parquet`: a row for each limit of each operation at each depth and
    /// friction.
    pub const REACH, read;
}

impl ReachSummary {
    /// `reach_limits.parquet`: a row for each limit.
    pub fn limits_table(&self) -> Table {
        let rows = self
            .frictions
            .iter()
            .flat_map(|reach| reach.limits.iter().map(|limit| (limit, reach.friction)));
        Row::table(rows)
    }

    /// Writes the summary as indented JSON.
    pub fn write(&self, path: &Path) -> Result<(), ResultsError> {
        write_json(self, path)
    }

    /// Reads back a summary, and refuses one of another [`REACH_VERSION`].
    pub fn read(path: &Path) -> Result<Self, ResultsError> {
        read_versioned(path, 1..=REACH_VERSION)
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::{Column, Data, ReadRow};

    fn margins(limit: &str) -> Result<Vec<ReachMargin>, ResultsError> {
        let mut table = Table::with_columns(REACH);
        let words: &[(&str, &[&str])] = &[("operation", &["drill"]), ("limit", &[limit])];
        table.append(words, &[("bit_depth_m", &[1000.0]), ("margin", &[0.5])]);
        ReachMargin::read(&table, Path::new("reach.parquet"))
    }

    /// Names of limits in summary and table, those of earlier versions included; others are errors.
    #[test]
    fn a_limit_is_read_by_its_name() {
        let stop = |limit: &str| {
            let stop = json!({"operation": "slide", "limit": limit, "depth_m": 1000.0});
            serde_json::from_value::<ReachStop>(stop)
        };
        for (name, expected) in [
            ("hoist", DepthLimit::Hoist),
            ("push_absorbed", DepthLimit::PushAbsorbed),
            ("lock_up", DepthLimit::PushAbsorbed),
        ] {
            assert_eq!(stop(name).expect("a limit").limit, expected);
            assert_eq!(margins(name).expect("a limit")[0].limit, expected);
        }
        assert_eq!(
            serde_json::to_value(stop("lock_up").unwrap()).unwrap()["limit"],
            "push_absorbed"
        );
        let error = stop("patience").expect_err("no limit").to_string();
        assert!(error.contains("`patience` is no limit of a reach"), "{error}");
        let error = margins("patience").expect_err("no limit").to_string();
        assert!(error.contains("`limit` is 'patience' in row 1"), "{error}");
        let rows = margins("hoist").expect("a limit");
        let written = ReachMargin::table(&rows);
        let Some(Column { data: Data::Text(words), .. }) = written.column("limit") else {
            panic!("words")
        };
        assert_eq!(words, &["hoist"]);
    }
}
