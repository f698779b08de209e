//! Checks of the string's rotation: stall, stick-slip and whirl.

use wholestring::{
    dynamics::{DynamicsSettings, StickSlip, Whirl},
    outcome::{Column, TIME_SERIES, TimeSeries, samples::mean},
};

use crate::{
    Check, CheckKind, Recent, Severity,
    check::MARGINAL,
    window::{Window, share},
};

/// A top drive slower than this part of its set speed counts as not turning.
const NOT_TURNING: f64 = 0.1;

/// A top drive that does not turn for more than this share of the time stalls.
const STALLED: f64 = 0.5;

/// A torque of this part of the limit counts as the limit: the rest is the inertia of the drive.
const AT_LIMIT: f64 = 0.98;

/// A share of the time at the limit that is reported.
const OFTEN: f64 = 0.01;

/// A severity of stick-slip that is reported.
const SEVERE: f64 = 0.5;

/// A severity at which the bit just stops.
const STOPS: f64 = 1.0;

/// A bit that is stuck for more than this share of the time counts as not turning.
const STUCK: f64 = 0.95;

/// Returns the checks of all parts that rotate.
pub fn checks(settings: &DynamicsSettings, window: &Window<'_>) -> Vec<Check> {
    let mut found = Vec::new();
    let limit = top_drive(settings, window);
    let stalled = limit.as_ref().is_some_and(|check| check.kind == CheckKind::TopDriveStalled);
    found.extend(limit);
    let indicators = window.run().indicators;
    // The effect of a stalled drive on the bit is not stick-slip.
    let of_bit = indicators.stick_slip.filter(|_| !stalled);
    found.extend(of_bit.and_then(|found| stick_slip(&found)));
    let speed = window.statistic("bit_rotary_speed_rad_per_s");
    let speed = speed.map_or(0.0, |statistic| statistic.mean);
    for (kind, severity, whirl) in [
        (CheckKind::BackwardWhirl, whirl_severity(true), &indicators.backward_whirl),
        (CheckKind::ForwardWhirl, whirl_severity(false), &indicators.forward_whirl),
    ] {
        found.extend(whirl.map(|whirl| of_whirl(kind, severity, &whirl, speed)));
    }
    found
}

const SET_SPEED: &Column<TimeSeries> = Column::named(TIME_SERIES, "rotary_speed_set_rad_per_s");
const SPEED: &Column<TimeSeries> = Column::named(TIME_SERIES, "rotary_speed_rad_per_s");
const TORQUE: &Column<TimeSeries> = Column::named(TIME_SERIES, "surface_torque_N_m");

/// A top drive that delivers its full torque.
fn top_drive(settings: &DynamicsSettings, window: &Window<'_>) -> Option<Check> {
    let limit_N_m = settings.top_drive.torque_limit_N_m()?;
    let [set, speed, torque_N_m] = [SET_SPEED, SPEED, TORQUE].map(|column| window.scalar(column));
    let stopped_share = window.share_of(
        [SET_SPEED, SPEED],
        |[set, _]| set > 0.0,
        |[set, speed]| speed < NOT_TURNING * set,
    );
    let at_limit = share(&torque_N_m, |torque| torque.abs() >= AT_LIMIT * limit_N_m);
    let found = |kind, severity, torque_N_m: f64| {
        Some(Check::reported(kind, severity).value(torque_N_m).limit(limit_N_m))
    };
    let mean_N_m = mean(&torque_N_m).abs();
    if stopped_share > STALLED && mean_N_m >= NOT_TURNING * limit_N_m {
        return found(CheckKind::TopDriveStalled, Severity::Error, mean_N_m);
    }
    if at_limit > OFTEN {
        let slow = mean(&speed) < (1.0 - NOT_TURNING) * mean(&set);
        let severity = if slow { Severity::Error } else { Severity::Warning };
        let largest_N_m = window.largest_torque_N_m();
        return found(CheckKind::TopDriveAtLimit, severity, largest_N_m);
    }
    None
}

/// Time over which a top drive of a live string is found to stall, s.
const STALLED_S: f64 = 2.0;

/// Returns the checks of a live string's rotation over the last seconds. A stalled drive is no
/// stick-slip, and whirl is not measured on it.
pub fn recent(settings: &DynamicsSettings, recent: &Recent<'_>) -> Vec<Check> {
    let limit = recent_top_drive(settings, recent);
    if limit.as_ref().is_some_and(|check| check.kind == CheckKind::TopDriveStalled) {
        return limit.into_iter().collect();
    }
    let mut found: Vec<Check> = limit.into_iter().collect();
    let indicators = recent.indicators;
    found.extend(indicators.stick_slip.as_ref().and_then(stick_slip));
    let speed = average(recent.rotary_speed_rad_per_s);
    for (kind, severity, whirl) in [
        (CheckKind::BackwardWhirl, whirl_severity(true), &indicators.backward_whirl),
        (CheckKind::ForwardWhirl, whirl_severity(false), &indicators.forward_whirl),
    ] {
        found.extend(whirl.map(|whirl| of_whirl(kind, severity, &whirl, speed)));
    }
    found
}

fn average(samples: &[f64]) -> f64 {
    samples.iter().sum::<f64>() / samples.len().max(1) as f64
}

/// The top drive of a live string at its torque limit.
fn recent_top_drive(settings: &DynamicsSettings, recent: &Recent<'_>) -> Option<Check> {
    let limit_N_m = settings.top_drive.torque_limit_N_m()?;
    let torques_N_m = recent.surface_torque_N_m;
    let last = |samples: usize| torques_N_m.len().saturating_sub(samples);
    let from = last((STALLED_S / recent.sample_s).ceil() as usize);
    let speeds = recent.rotary_speed_rad_per_s[from..].iter();
    let turns = speeds.zip(&recent.rotary_speed_set_rad_per_s[from..]);
    let set = turns.filter(|(_, set)| **set > 0.0).collect::<Vec<_>>();
    let stopped = set.iter().filter(|(speed, set)| **speed < NOT_TURNING * **set).count();
    let largest_N_m = torques_N_m.iter().fold(0.0_f64, |most, torque| most.max(torque.abs()));
    let found = |kind, severity, torque_N_m: f64| {
        Some(Check::reported(kind, severity).value(torque_N_m).limit(limit_N_m))
    };
    let mean_N_m = average(&torques_N_m[from..]).abs();
    if stopped as f64 > STALLED * set.len() as f64 && mean_N_m >= NOT_TURNING * limit_N_m {
        return found(CheckKind::TopDriveStalled, Severity::Error, mean_N_m);
    }
    let at_limit = torques_N_m.iter().filter(|torque| torque.abs() >= AT_LIMIT * limit_N_m).count();
    if at_limit as f64 > OFTEN * torques_N_m.len() as f64 {
        let slow = average(recent.rotary_speed_rad_per_s)
            < (1.0 - NOT_TURNING) * average(recent.rotary_speed_set_rad_per_s);
        let severity = if slow { Severity::Error } else { Severity::Warning };
        return found(CheckKind::TopDriveAtLimit, severity, largest_N_m);
    }
    None
}

/// Stick-slip that is reported: a warning where the bit stops.
fn stick_slip(found: &StickSlip) -> Option<Check> {
    let level = stick_slip_severity(found).filter(|level| *level > Severity::Ok)?;
    let check = Check::reported(CheckKind::StickSlip, level);
    Some(match found.severity {
        Some(severity) => {
            check.value(severity).limit(if severity >= STOPS { STOPS } else { SEVERE })
        }
        None => check,
    })
}

/// Severity of stick-slip: a warning where the bit stops; `None` where no speed of the bit is
/// known.
fn stick_slip_severity(found: &StickSlip) -> Option<Severity> {
    match found.severity {
        Some(severity) if severity >= STOPS => Some(Severity::Warning),
        Some(severity) if severity >= SEVERE => Some(Severity::Note),
        Some(_) => Some(Severity::Ok),
        None if found.stuck_fraction > STUCK => Some(Severity::Warning),
        None => None,
    }
}

/// Severity of whirl, backward or forward.
const fn whirl_severity(is_backward: bool) -> Severity {
    if is_backward { Severity::Warning } else { Severity::Note }
}

/// Severity of a top drive's torque over its limit; an error where it stalls.
pub fn top_drive_severity(torque_use: f64, is_stalled: bool) -> Severity {
    match () {
        () if is_stalled => Severity::Error,
        () if torque_use >= AT_LIMIT => Severity::Warning,
        () if torque_use >= AT_LIMIT / MARGINAL => Severity::Note,
        () => Severity::Ok,
    }
}

fn of_whirl(kind: CheckKind, severity: Severity, whirl: &Whirl, rotary_speed: f64) -> Check {
    Check::reported(kind, severity).at(whirl.md_m).value(whirl.rate_rad_per_s).limit(rotary_speed)
}
