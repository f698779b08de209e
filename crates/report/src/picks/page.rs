//! The page of weights picked from a log as one self-contained file.

use wholestring_import::picking::{Detail, Estimate, Picks, Window};
use wholestring_units::UnitSet;

use super::{
    PickedLog,
    figures::{depth_figure, log_figure, stand_figure},
    number_and_work,
};
use crate::{
    Grid, StudyPage, StudyPart,
    cell::capital,
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

/// Returns the page of weights picked from a log, which opens in these units, as the text of an HTML
/// file. No name in it can end the element that contains it.
pub fn picks_html(picks: &Picks, units: UnitSet) -> String {
    let log = PickedLog::new(picks, units);
    study_html_in_units(units.name(), |units| page(&log, units))
}

fn page(log: &PickedLog<'_>, units: &str) -> StudyPage {
    let display = DisplayUnits::new(&log.head.dimensions, units);
    let mut description = ABOUT.to_owned();
    for note in log.picks.notes() {
        description += &format!("\n\n{}.", capital(note.text()));
    }
    let block = if log.picks.block.added_N() != 0.0 {
        "Hook loads of the curve and of the points are as logged. The picked weights have the \
         block's weight added, less the indicator's value in slips."
    } else {
        "Hook loads are as logged, with the block."
    };
    let mut parts = vec![
        part("The log", block, log_figure(log, units)),
        part(
            "Picked against depth",
            "Each point is a window; bars reach one standard error to either side. Weights are \
             those of a weight indicator and include the block.",
            depth_figure(log, units),
        ),
    ];
    parts.extend(log.picks.details.iter().map(|stand| {
        let title = format!("Stand {}", number_and_work(stand));
        part(&title, &caption(stand), stand_figure(log, stand, units))
    }));
    parts.push(table(log, display));
    StudyPage {
        program: log.head.program.clone(),
        title: log.head.title.clone(),
        description,
        parts,
    }
}

fn caption(stand: &Detail) -> String {
    let mut text = "Coloured: the windows, each with its picked value.".to_owned();
    let refused = stand.refused.iter();
    let refused =
        refused.map(|refused| format!("{}: {}", refused.kind.words(), refused.why.words()));
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

fn table(log: &PickedLog<'_>, display: DisplayUnits<'_>) -> StudyPart {
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
    let quantity = |picked: Option<Estimate>, dimension: &str| {
        let Some(Estimate { value, standard_error, .. }) = picked else { return "–".to_owned() };
        let error = display.value(standard_error, dimension);
        // As many digits as give the error two.
        let digits = (1.0 - error.abs().max(1e-9).log10().floor()).clamp(0.0, 3.0) as usize;
        let value = display.value(value, dimension);
        format!("{value:.digits$} ± {error:.digits$} {}", display.symbol(dimension))
    };
    let line = |window: &Window| {
        let Window { from_s, to_s, .. } = *window;
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
    let listed = log.picks.windows.iter().take(LISTED).map(line).collect();
    let rest = log.picks.windows.len().saturating_sub(LISTED);
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
