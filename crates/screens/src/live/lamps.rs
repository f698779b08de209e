//! Lamps of the driller's seat: stick-slip, whirl and top drive.
//!
//! A lamp has the severity of the judge's alarms of its kinds, so that lamps and alarms agree. All
//! are dark until enough time is measured, as at the start and after a rewind. While the top drive
//! stalls, the other two are dark, because neither is measured on a string that does not turn.

use wholestring::dynamics::{Indicators, Whirl};
use wholestring_judge::{Check, CheckKind, Quantity, Severity, top_drive_severity};

use super::{
    lamp::Lamp,
    watched::{MOVES_S, Watched},
};

fn percent(part: f64) -> String {
    format!("{:.0} %", 100.0 * part)
}

/// The most severe alarm of these kinds.
fn alarm<'a>(alarms: &'a [Check], kinds: &[CheckKind]) -> Option<&'a Check> {
    // Alarms are ordered by severity.
    alarms.iter().find(|check| kinds.contains(&check.kind))
}

const OF_TOP_DRIVE: [CheckKind; 4] = [
    CheckKind::TopDriveStalled,
    CheckKind::TopDriveAtLimit,
    CheckKind::TopDrivePeak,
    CheckKind::TopDrive,
];

/// The lamps of a motion with these alarms. `limit_N_m` is the largest torque of the top drive.
pub(super) fn lamps(
    watched: &Watched,
    indicators: &Indicators,
    alarms: &[Check],
    limit_N_m: Option<f64>,
) -> Vec<Lamp> {
    const NAMES: [&str; 3] = ["Stick-slip", "Whirl", "Top drive"];
    if watched.measured_s() < MOVES_S {
        let text = format!("Measured from {MOVES_S:.0} s of motion on");
        return NAMES.map(|name| Lamp::dark(name, &text)).into();
    }
    let stalls = alarm(alarms, &[CheckKind::TopDriveStalled]).is_some();
    let of_motion = if stalls {
        NAMES[..2]
            .iter()
            .map(|name| Lamp::dark(name, "Not measured while the top drive stalls"))
            .collect()
    } else {
        vec![stick_slip(watched, indicators, alarms), whirl(indicators, alarms)]
    };
    of_motion.into_iter().chain([top_drive(watched, alarms, limit_N_m)]).collect()
}

fn stick_slip(watched: &Watched, indicators: &Indicators, alarms: &[Check]) -> Lamp {
    const NAME: &str = "Stick-slip";
    if !watched.rotates() {
        return Lamp::dark(NAME, "The string does not rotate in this operation");
    }
    let Some(found) = &indicators.stick_slip else {
        return Lamp::dark(NAME, "The bit does not rotate");
    };
    let value = found.severity.map_or("–".to_owned(), percent);
    match alarm(alarms, &[CheckKind::StickSlip]) {
        Some(check) => Lamp::new(NAME, Some(check.severity), value, wording(check)),
        None if found.severity.is_none() => Lamp::dark(NAME, "The bit does not rotate"),
        None => {
            let text = "Half the range of the bit's rotary speed over its mean";
            Lamp::new(NAME, Some(Severity::Ok), value, text.to_owned())
        }
    }
}

fn whirl(indicators: &Indicators, alarms: &[Check]) -> Lamp {
    const NAME: &str = "Whirl";
    let of_direction = |word: &str, kind, found: &Whirl| {
        let check = alarm(alarms, &[kind])?;
        let text = format!(
            "{:.1} times the rotary speed at {}, {} of the string",
            found.ratio.abs(),
            Quantity::depth(found.md_m),
            percent(found.length_fraction)
        );
        Some(Lamp::new(NAME, Some(check.severity), word.to_owned(), text))
    };
    let backward = indicators.backward_whirl.as_ref();
    let forward = indicators.forward_whirl.as_ref();
    backward
        .and_then(|found| of_direction("backward", CheckKind::BackwardWhirl, found))
        .or_else(|| {
            forward.and_then(|found| of_direction("forward", CheckKind::ForwardWhirl, found))
        })
        .unwrap_or_else(|| {
            let text = "No part of the string circles in the hole";
            Lamp::new(NAME, Some(Severity::Ok), "none".to_owned(), text.to_owned())
        })
}

fn top_drive(watched: &Watched, alarms: &[Check], limit_N_m: Option<f64>) -> Lamp {
    const NAME: &str = "Top drive";
    let Some(limit_N_m) = limit_N_m else {
        return Lamp::dark(NAME, "The case gives no torque of the top drive");
    };
    let torque_use = watched.largest_torque_N_m() / limit_N_m;
    let severity = top_drive_severity(torque_use, false);
    let text = format!("{} of the top drive's torque is used", percent(torque_use));
    match alarm(alarms, &OF_TOP_DRIVE) {
        Some(check) => {
            Lamp::new(NAME, Some(check.severity.max(severity)), percent(torque_use), wording(check))
        }
        None => Lamp::new(NAME, Some(severity), percent(torque_use), text),
    }
}

/// The sentence of a check with its quantities marked.
fn wording(check: &Check) -> String {
    match check.wording.is_empty() {
        true => check.sentence.clone(),
        false => check.wording.to_string(),
    }
}
