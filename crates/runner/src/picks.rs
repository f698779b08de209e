//! The page of weights picked from a log.

use wholestring_import::picking::{Channel, Detail, Estimate, Kind, Picks, Trace, Window, Work};
use wholestring_report::{
    self as report, PageHead, PickedKind, PickedLog, PickedStand, PickedTrace, PickedValue,
    PickedWindow,
};
use wholestring_units::UnitSet;

/// The page of picked weights as HTML text, which opens in these units.
pub fn picks_html(picks: &Picks, units: UnitSet) -> String {
    report::picks_html(&picked_log(picks, units))
}

/// Picked weights in the form of a page.
pub fn picked_log(picks: &Picks, units: UnitSet) -> PickedLog {
    let notes = picks.notes().into_iter().map(|note| {
        let text = note.text();
        let mut letters = text.chars();
        let first = letters.next().map(|letter| letter.to_uppercase().collect::<String>());
        format!("{}{}", first.unwrap_or_default(), letters.as_str())
    });
    let name = picks.file.rsplit(['/', '\\']).next().unwrap_or(&picks.file);
    let head = PageHead::new(format!("Weights picked from {name}"), Some(units), None, Vec::new());
    PickedLog {
        head,
        trace: trace(&picks.overview),
        windows: picks.windows.iter().map(window).collect(),
        stands: picks.details.iter().map(stand).collect(),
        slips_N: picks.block.slips_N,
        added_N: picks.block.added_N(),
        notes: notes.collect(),
    }
}

fn stand(detail: &Detail) -> PickedStand {
    let work = match detail.work {
        Work::Drilled => "drilled",
        Work::TrippedOut => "pulled out",
        Work::TrippedIn => "run in",
        Work::Other => "held off bottom",
    };
    let refused = detail.refused.iter();
    let refused = refused.map(|refused| {
        (kind(refused.kind), [refused.from_s, refused.to_s], refused.why.words().to_owned())
    });
    PickedStand {
        stand: detail.stand,
        work: work.to_owned(),
        trace: trace(&detail.trace),
        windows: detail.windows.iter().map(window).collect(),
        refused: refused.collect(),
    }
}

fn trace(trace: &Trace) -> PickedTrace {
    PickedTrace {
        block: trace.points(Channel::Block),
        bit_depth: trace.points(Channel::BitDepth),
        hook_load: trace.points(Channel::HookLoad),
        torque: trace.points(Channel::Torque),
        rotary: trace.points(Channel::Rotary),
    }
}

fn window(window: &Window) -> PickedWindow {
    let value = |estimate: Estimate| PickedValue {
        value: estimate.value,
        standard_error: estimate.standard_error,
    };
    PickedWindow {
        kind: kind(window.kind),
        stand: window.stand,
        time_s: [window.from_s, window.to_s],
        bit_depth_m: window.bit_depth_m,
        speed_m_per_s: window.speed_m_per_s,
        rotary_rad_per_s: window.rotary_rad_per_s,
        weight_N: window.weight_N.map(value),
        torque_N_m: window.torque_N_m.map(value),
    }
}

fn kind(kind: Kind) -> PickedKind {
    match kind {
        Kind::PickUp => PickedKind::PickUp,
        Kind::SlackOff => PickedKind::SlackOff,
        Kind::Rotating => PickedKind::Rotating,
        Kind::Drilling => PickedKind::Drilling,
    }
}
