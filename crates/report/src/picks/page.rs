//! The page of weights picked from a log as one file that needs nothing else.

use super::{
    PickedLog, PickedStand, PickedValue, PickedWindow,
    figures::{picked_depth_figure, picked_log_figure, picked_stand_figure},
};
use crate::{
    Grid, StudyPage, StudyPart,
    figure::Figure,
    grid_cells::{heads, row},
    plots::Shown,
    study::study_html_in_units,
};

/// What the pictures show.
const ABOUT: &str = "Weights and torques picked from a log: where the string moved or turned \
    steadily, off slips, and what the sensors said there. Look whether the windows lie where they \
    should before the numbers are used.";

/// Windows that the table lists; the file of measured weights has all.
const LISTED: usize = 200;

/// The page as the text of an HTML file. No name in it can end the element that it stands in.
pub fn picks_html(of: &PickedLog) -> String {
    study_html_in_units(&of.head.units, |units| page(of, units))
}

fn page(of: &PickedLog, units: &str) -> StudyPage {
    let shown = Shown::new(&of.head.dimensions, units);
    let mut description = ABOUT.to_owned();
    let facts: Vec<String> = of.head.facts.iter().filter_map(|fact| shown.fact(fact)).collect();
    if !facts.is_empty() {
        description = format!("{}.\n\n{description}", facts.join("; "));
    }
    description.extend(of.notes.iter().map(|note| format!("\n\n{note}.")));
    let block = if of.added_N != 0.0 {
        "Hook loads of the curve are as they were logged, and so are the points here. The picked \
         weights have the block's weight added, less what the indicator shows in slips."
    } else {
        "Hook loads are as they were logged, with the block."
    };
    let mut parts = vec![
        part("The log", block, picked_log_figure(of, units)),
        part(
            "Picked against depth",
            "Each point is a window; bars reach one standard error to either side. Weights are those \
             of a weight indicator: the block's weight is in them.",
            picked_depth_figure(of, units),
        ),
    ];
    parts.extend(of.stands.iter().map(|stand| {
        let title = format!("Stand {}, {}", stand.stand, stand.work);
        part(&title, &caption(stand), picked_stand_figure(of, stand, units))
    }));
    parts.push(table(of, shown));
    StudyPage { program: of.head.program.clone(), title: of.head.title.clone(), description, parts }
}

fn caption(stand: &PickedStand) -> String {
    let mut text = "Coloured: the windows, each with what was picked of it.".to_owned();
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

fn table(of: &PickedLog, shown: Shown<'_>) -> StudyPart {
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
    let quantity = |of: Option<PickedValue>, dimension: &str| {
        let Some(PickedValue { value, standard_error }) = of else { return "–".to_owned() };
        let error = shown.value(standard_error, dimension);
        // As many digits as its error has two of.
        let digits = (1.0 - error.abs().max(1e-9).log10().floor()).clamp(0.0, 3.0) as usize;
        let value = shown.value(value, dimension);
        format!("{value:.digits$} ± {error:.digits$} {}", shown.symbol(dimension))
    };
    let line = |window: &PickedWindow| {
        let [from_s, to_s] = window.time_s;
        let speed = |of: f64, dimension: &str| {
            if of.is_finite() {
                let symbol = shown.symbol(dimension);
                format!("{:.3} {symbol}", shown.value(of, dimension)).replace('-', "\u{2212}")
            } else {
                "–".to_owned()
            }
        };
        let turns = if window.rotary_rad_per_s.is_finite() {
            let symbol = shown.symbol("rotary speed");
            format!("{:.0} {symbol}", shown.value(window.rotary_rad_per_s, "rotary speed"))
        } else {
            "–".to_owned()
        };
        row(vec![
            window.stand.to_string(),
            window.kind.words().to_owned(),
            format!("{:.3}", from_s / 3600.0),
            format!("{:.0} s", to_s - from_s),
            shown.depth(window.bit_depth_m),
            speed(window.speed_m_per_s, "speed"),
            turns,
            quantity(window.weight_N, "force"),
            quantity(window.torque_N_m, "torque"),
        ])
    };
    let listed = of.windows.iter().take(LISTED).map(line).collect();
    let rest = of.windows.len().saturating_sub(LISTED);
    let mut caption = "Values with their standard errors, which hold the noise within a window; \
        windows of one depth differ by more."
        .to_owned();
    if rest > 0 {
        caption += &format!(" The first {LISTED}; {rest} more are not listed.");
    }
    StudyPart::Table {
        title: "What was picked".to_owned(),
        caption,
        grid: Grid { heads, rows: listed },
        files: String::new(),
        endings: &[],
    }
}
