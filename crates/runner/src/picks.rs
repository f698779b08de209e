//! The page of weights that were picked from a log.

use wholestring_import::picking::{Channel, Detail, Estimate, Kind, Picks, Trace, Window, Work};
use wholestring_report::{
    self as report, PickedKind, PickedLog, PickedStand, PickedTrace, PickedValue, PickedWindow,
};
use wholestring_units::UnitSet;

use crate::page;

/// The page of picked weights as the text of an HTML file, which opens with these units.
pub fn picks_html(of: &Picks, units: UnitSet) -> String {
    report::picks_html(&picked_log(of, units))
}

/// Picked weights as a page shows them.
pub fn picked_log(of: &Picks, units: UnitSet) -> PickedLog {
    let notes = of.notes().into_iter().map(|note| {
        let text = note.text();
        let mut letters = text.chars();
        let first = letters.next().map(|letter| letter.to_uppercase().collect::<String>());
        format!("{}{}", first.unwrap_or_default(), letters.as_str())
    });
    let name = of.file.rsplit(['/', '\\']).next().unwrap_or(&of.file);
    let head = page::head(format!("Weights picked from {name}"), Some(units), None, Vec::new());
    PickedLog {
        head,
        trace: trace(&of.overview),
        windows: of.windows.iter().map(window).collect(),
        stands: of.details.iter().map(stand).collect(),
        slips_N: of.block.slips_N,
        added_N: of.block.added_N(),
        notes: notes.collect(),
    }
}

fn stand(of: &Detail) -> PickedStand {
    let work = match of.work {
        Work::Drilled => "drilled",
        Work::TrippedOut => "pulled out",
        Work::TrippedIn => "run in",
        Work::Other => "held off bottom",
    };
    let refused = of.refused.iter();
    let refused =
        refused.map(|of| (kind(of.kind), [of.from_s, of.to_s], of.why.words().to_owned()));
    PickedStand {
        stand: of.stand,
        work: work.to_owned(),
        trace: trace(&of.trace),
        windows: of.windows.iter().map(window).collect(),
        refused: refused.collect(),
    }
}

fn trace(of: &Trace) -> PickedTrace {
    PickedTrace {
        block: of.points(Channel::Block),
        bit_depth: of.points(Channel::BitDepth),
        hook_load: of.points(Channel::HookLoad),
        torque: of.points(Channel::Torque),
        rotary: of.points(Channel::Rotary),
    }
}

fn window(of: &Window) -> PickedWindow {
    let value = |of: Estimate| PickedValue { value: of.value, standard_error: of.standard_error };
    PickedWindow {
        kind: kind(of.kind),
        stand: of.stand,
        time_s: [of.from_s, of.to_s],
        bit_depth_m: of.bit_depth_m,
        speed_m_per_s: of.speed_m_per_s,
        rotary_rad_per_s: of.rotary_rad_per_s,
        weight_N: of.weight_N.map(value),
        torque_N_m: of.torque_N_m.map(value),
    }
}

fn kind(of: Kind) -> PickedKind {
    match of {
        Kind::PickUp => PickedKind::PickUp,
        Kind::SlackOff => PickedKind::SlackOff,
        Kind::Rotating => PickedKind::Rotating,
        Kind::Drilling => PickedKind::Drilling,
    }
}
