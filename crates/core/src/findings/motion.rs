//! How the string turns: stalls, stick-slip, whirl.

use super::{
    Finding, Kind, Level,
    window::{Window, mean, share},
};
use crate::dynamics::{DynamicOutcome, DynamicsSettings, StickSlip, Whirl};

/// A top drive slower than this part of its set speed does not turn, ...
const STANDS: f64 = 0.1;

/// ... and stalls where it stands for more than this share of the time.
const STALLED: f64 = 0.5;

/// A torque of this part of the limit is the limit: what is left is the inertia of the drive.
const AT_LIMIT: f64 = 0.98;

/// A share of the time at the limit that is reported.
const OFTEN: f64 = 0.01;

/// A severity of stick-slip that is reported.
const SEVERE: f64 = 0.5;

/// A severity at which the bit just stops.
const STOPS: f64 = 1.0;

/// A bit that stands for more than this share of the time does not turn.
const STUCK: f64 = 0.95;

/// Of all that turns.
pub fn findings(
    settings: &DynamicsSettings,
    outcome: &DynamicOutcome,
    window: &Window<'_>,
) -> Vec<Finding> {
    let mut found = Vec::new();
    let limit = top_drive(settings, window);
    let stalled = limit.is_some_and(|of| of.kind == Kind::TopDriveStalled);
    found.extend(limit);
    let of = &outcome.indicators;
    // What a stalled drive does to the bit is no stick-slip.
    found.extend(of.stick_slip.filter(|_| !stalled).and_then(|of| stick_slip(&of)));
    let speed = window.statistic("bit_rotary_speed_rad_per_s");
    let speed = speed.map_or(0.0, |of| of.mean);
    for (kind, level, whirl) in [
        (Kind::BackwardWhirl, Level::Warning, &of.backward_whirl),
        (Kind::ForwardWhirl, Level::Note, &of.forward_whirl),
    ] {
        found.extend(whirl.map(|whirl| of_whirl(kind, level, &whirl, speed)));
    }
    found
}

/// A top drive that gives all that it may.
fn top_drive(settings: &DynamicsSettings, window: &Window<'_>) -> Option<Finding> {
    let limit_N_m = settings.top_drive.torque_limit_N_m()?;
    let set = window.series(|of| &of.rotary_speed_set_rad_per_s);
    let speed = window.series(|of| &of.rotary_speed_rad_per_s);
    let torque_N_m = window.series(|of| &of.surface_torque_N_m);
    let rows: Vec<usize> = (0..set.len()).filter(|row| set[*row] > 0.0).collect();
    let stands = share(&rows, |row| speed[*row] < STANDS * set[*row]);
    let at_limit = share(torque_N_m, |torque| torque.abs() >= AT_LIMIT * limit_N_m);
    let found = |kind, level, torque_N_m: f64| {
        Some(Finding::new(kind, level).value(torque_N_m).limit(limit_N_m))
    };
    let mean_N_m = mean(torque_N_m).abs();
    if stands > STALLED && mean_N_m >= STANDS * limit_N_m {
        return found(Kind::TopDriveStalled, Level::Error, mean_N_m);
    }
    if at_limit > OFTEN {
        let slow = mean(speed) < (1.0 - STANDS) * mean(set);
        let level = if slow { Level::Error } else { Level::Warning };
        let largest_N_m = window.torque_N_m()[1];
        return found(Kind::TopDriveAtLimit, level, largest_N_m);
    }
    None
}

/// Stick-slip that is worth telling: a warning where the bit stops.
fn stick_slip(of: &StickSlip) -> Option<Finding> {
    let level = |severe: bool| if severe { Level::Warning } else { Level::Note };
    match of.severity {
        Some(severity) if severity >= SEVERE => Some(
            Finding::new(Kind::StickSlip, level(severity >= STOPS))
                .value(severity)
                .limit(if severity >= STOPS { STOPS } else { SEVERE }),
        ),
        None if of.stuck_fraction > STUCK => Some(Finding::new(Kind::StickSlip, Level::Warning)),
        _ => None,
    }
}

fn of_whirl(kind: Kind, level: Level, whirl: &Whirl, rotary_speed: f64) -> Finding {
    Finding::new(kind, level).at(whirl.md_m).value(whirl.rate_rad_per_s).limit(rotary_speed)
}
