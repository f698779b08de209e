//! The page of weights picked from a log as one self-contained file.

use super::{
    PickedLog, PickedStand, PickedValue, PickedWindow,
    figures::{picked_depth_figure, picked_log_figure, picked_stand_figure},
};
use crate::{
    Grid, StudyPage, StudyPart,
    figure::Figure,
    grid_cells::{heads, row},
    plots::DisplayUnits,
    study::study_html_in_units,
};

/// Meaning of the pictures.
const ABOUT: &str = "Weights and torques picked from a log: windows in which the string moved or \
    rotated steadily, off slips, and the sensor readings in them. Check the places of the windows \
    before the numbers are used.";

/// Windows that the table lists; the file of measured weights has all.
const LISTED: usize = 200;

/// Returns the page as the text of an HTML file. No name in it can end the element that contains
/// it.
pub fn picks_html(log: &PickedLog) -> String {
    study_html_in_units(&log.head.units, |units| page(log, units))
}

fn page(log: &PickedLog, units: &str) -> StudyPage {
    let display = DisplayUnits::new(&log.head.dimensions, units);
    let mut description = ABOUT.to_owned();
    let facts: Vec<String> = log.head.facts.iter().filter_map(|fact| display.fact(fact)).collect();
    if !facts.is_empty() {
        description = format!("{}.\n\n{description}", facts.join("; "));
    }
    description.extend(log.notes.iter().map(|note| format!("\n\n{note}.")));
    let block = if log.added_N != 0.0 {
        "Hook loads of the curve and of the points are as logged. The picked weights have the \
         block's weight added, less the indicator's value in slips."
    } else {
        "Hook loads are as logged, with the block."
    };
    let mut parts = vec![
        part("The log", block, picked_log_figure(log, units)),
        part(
            "Picked against depth",
            "Each point is a window; bars reach one standard error to either side. Weights are \
             those of a weight indicator and include the block.",
            picked_depth_figure(log, units),
        ),
    ];
    parts.extend(log.stands.iter().map(|stand| {
        let title = format!("Stand {}, {}", stand.stand, stand.work);
        part(&title, &caption(stand), picked_stand_figure(log, stand, units))
    }));
    parts.push(table(log, display));
    StudyPage {
        program: log.head.program.clone(),
        title: log.head.title.clone(),
        description,
        parts,
    }
}

fn caption(stand: &PickedStand) -> String {
    let mut text = "Coloured: the windows, each with its picked value.".to_owned();
    let refused = stand.refused.iter().map(|(kind, _, why)| format!("{}: {why}", kind.words()));
    let mut refused: Vec<String> = refused.collect();
    refused.dedup();
    if !refused.is_empty() {
        text += &format!(" Grey: refused, {}.", refused.join("; "));
    }
    text
}

/// A picture without files of its own.
fn part(title: &str, caption: &str, figure: Figure) -> StudyPart {
    StudyPart::Figure {
        title: title.to_owned(),
        caption: caption.to_owned(),
        figure: Some(Box::new(figure)),
        files: String::new(),
        painted: false,
    }
}

fn table(log: &PickedLog, display: DisplayUnits<'_>) -> StudyPart {
    let heads = heads(&[
        ("stand", false),
        ("picked for", true),
        ("time, h", false),
        ("lasts", false),
        ("bit depth", false),
        ("block speed", false),
        ("rotary speed", false),
        ("hook load", false),
        ("torque", false),
    ]);
    let quantity = |picked: Option<PickedValue>, dimension: &str| {
        let Some(PickedValue { value, standard_error }) = picked else { return "–".to_owned() };
        let error = display.value(standard_error, dimension);
        // As many digits as give the error two.
        let digits = (1.0 - error.abs().max(1e-9).log10().floor()).clamp(0.0, 3.0) as usize;
        let value = display.value(value, dimension);
        format!("{value:.digits$} ± {error:.digits$} {}", display.symbol(dimension))
    };
    let line = |window: &PickedWindow| {
        let [from_s, to_s] = window.time_s;
        let speed = |value: f64, dimension: &str| {
            if value.is_finite() {
                let symbol = display.symbol(dimension);
                format!("{:.3} {symbol}", display.value(value, dimension)).replace('-', "\u{2212}")
            } else {
                "–".to_owned()
            }
        };
        let turns = if window.rotary_rad_per_s.is_finite() {
            let symbol = display.symbol("rotary speed");
            format!("{:.0} {symbol}", display.value(window.rotary_rad_per_s, "rotary speed"))
        } else {
            "–".to_owned()
        };
        row(vec![
            window.stand.to_string(),
            window.kind.words().to_owned(),
            format!("{:.3}", from_s / 3600.0),
            format!("{:.0} s", to_s - from_s),
            display.depth(window.bit_depth_m),
            speed(window.speed_m_per_s, "speed"),
            turns,
            quantity(window.weight_N, "force"),
            quantity(window.torque_N_m, "torque"),
        ])
    };
    let listed = log.windows.iter().take(LISTED).map(line).collect();
    let rest = log.windows.len().saturating_sub(LISTED);
    let mut caption = "Values with their standard errors, which include only the noise within a \
        window; windows at one depth differ by more."
        .to_owned();
    if rest > 0 {
        caption += &format!(" The first {LISTED}; {rest} more are not listed.");
    }
    StudyPart::Table {
        title: "Picked values".to_owned(),
        caption,
        grid: Grid { heads, rows: listed },
        files: String::new(),
        endings: &[],
    }
}
