//! Whirl, stick-slip and the use of the top drive, in a line each where there is something to tell.

use std::f64::consts::TAU;

use wholestring::dynamics::{StickSlip, TorqueUse, Whirl};
use wholestring_results::Summary;
use wholestring_units::{Dimension, UnitSet};

/// A severity of stick-slip that is told.
const SEVERE: f64 = 0.5;

/// A part of the rated torque that is told; beyond the whole of it there is a warning.
const MUCH: f64 = 0.8;

/// The lines; empty where every operation runs quietly.
pub(crate) fn notes(summary: &Summary, units: UnitSet) -> String {
    let mut lines = String::new();
    for solved in &summary.operations {
        let Some(of) = &solved.indicators else {
            continue;
        };
        let told = [
            of.stick_slip.as_ref().and_then(stick_slip),
            of.backward_whirl
                .as_ref()
                .map(|of| whirl("backward", of, units)),
            of.forward_whirl
                .as_ref()
                .map(|of| whirl("forward", of, units)),
            of.top_drive.as_ref().and_then(top_drive),
        ];
        let operation = solved.operation.replace('_', " ");
        for line in told.into_iter().flatten() {
            lines += &format!("{operation}: {line}\n");
        }
    }
    lines
}

fn stick_slip(of: &StickSlip) -> Option<String> {
    let severity = of.severity.filter(|severity| *severity >= SEVERE)?;
    let mut line = format!("stick-slip of severity {severity:.2}");
    if let Some(period_s) = of.period_s {
        line += &format!(", period {period_s:.1} s");
    }
    line += &format!(
        ", bit stuck for {:.0} % of the time and up to {:.0} rev/min fast",
        of.stuck_fraction * 100.0,
        of.bit_speed_max_rad_per_s * 60.0 / TAU,
    );
    Some(line)
}

fn whirl(direction: &str, of: &Whirl, units: UnitSet) -> String {
    format!(
        "{direction} whirl over {:.1} % of the string, fastest at {}: {:.0} rev/min, {:.1} × rotary speed",
        of.length_fraction * 100.0,
        Dimension::Length.format(of.md_m, units),
        of.rate_rad_per_s * 60.0 / TAU,
        of.ratio,
    )
}

fn top_drive(of: &TorqueUse) -> Option<String> {
    (MUCH..=1.0).contains(&of.max).then(|| {
        format!(
            "surface torque up to {:.0} % of the top drive's rated torque, 95th percentile {:.0} %",
            of.max * 100.0,
            of.p95 * 100.0,
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_worth_telling_is_told() {
        let quiet = StickSlip {
            severity: Some(0.1),
            torque_severity: Some(0.1),
            period_s: None,
            stuck_fraction: 0.0,
            bit_speed_max_rad_per_s: 8.0,
        };
        assert_eq!(stick_slip(&quiet), None);
        let severe = StickSlip {
            severity: Some(1.3),
            period_s: Some(5.25),
            stuck_fraction: 0.2,
            bit_speed_max_rad_per_s: TAU * 3.0,
            ..quiet
        };
        assert_eq!(
            stick_slip(&severe).unwrap(),
            "stick-slip of severity 1.30, period 5.2 s, bit stuck for 20 % of the time and up to 180 \
             rev/min fast"
        );
        let use_of = |max| TorqueUse { p95: 0.75, max };
        assert_eq!(top_drive(&use_of(0.79)), None);
        assert_eq!(top_drive(&use_of(1.01)), None);
        assert!(top_drive(&use_of(0.9)).is_some());
        let rolls = Whirl {
            md_m: 4290.0,
            rate_rad_per_s: -TAU * 4.0,
            ratio: -3.4,
            length_fraction: 0.012,
        };
        assert_eq!(
            whirl("backward", &rolls, UnitSet::Si),
            "backward whirl over 1.2 % of the string, fastest at 4290 m: -240 rev/min, -3.4 × rotary speed"
        );
    }
}
