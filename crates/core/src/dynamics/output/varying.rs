//! The scalars that vary over a run, and the scales on which their drifts are measured.

use crate::outcome::{DriftScale, History, ScalarHistory, TimeSeries, VARYING};

/// A scalar that varies.
pub struct Varying<'a> {
    pub samples: &'a [f64],
    pub scale: DriftScale,
}

/// The scalars that vary, with their samples, as the columns against time declare them.
pub fn varying(series: &TimeSeries) -> [Varying<'_>; VARYING.len()] {
    VARYING.map(|column| Varying {
        samples: (column.of)(series).kept().expect("a column without gaps has statistics"),
        scale: column.statistics.expect("those that vary have statistics").scale,
    })
}

/// A scalar that varies over a run that may be too long for memory.
pub struct VaryingHistory<'a> {
    pub name: &'static str,
    pub samples: ScalarHistory<'a>,
    pub scale: DriftScale,
}

/// The scalars that vary, from a row of the history on.
pub fn varying_from(history: History<'_>, from: usize) -> [VaryingHistory<'_>; VARYING.len()] {
    VARYING.map(|column| VaryingHistory {
        name: column.quantity.name,
        samples: history.scalar(column, from),
        scale: column.statistics.expect("those that vary have statistics").scale,
    })
}

/// The scales on which drifts are measured, of scalars with these means. Forces along the string go
/// by the largest of them and by 10 kN at least, torques by the largest and by 1 kN·m: half a
/// percent of less than that is nothing that a rig shows.
pub fn scales<const N: usize>(means: [(DriftScale, f64); N]) -> [f64; N] {
    let largest = |kind: DriftScale, least: f64| {
        let alike = means.iter().filter(|(scale, _)| *scale == kind);
        alike.fold(least, |most, (_, mean)| most.max(mean.abs()))
    };
    let (force_N, torque_N_m) = (largest(DriftScale::Force, 1e4), largest(DriftScale::Torque, 1e3));
    means.map(|(scale, mean)| match scale {
        DriftScale::Force => force_N,
        DriftScale::Torque => torque_N_m,
        DriftScale::Own(least) => mean.abs().max(least),
    })
}
