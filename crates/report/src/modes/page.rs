//! The page of linear vibration as one self-contained file.

use wholestring_results::Spot;

use super::{
    Modes,
    figures::{modes_plots, order_name},
};
use crate::{
    Grid, StudyPage, StudyPart,
    grid_cells::{heads, row},
    plots::DisplayUnits,
    study::study_html_in_units,
};

/// Meaning of the page's numbers.
const ABOUT: &str = "Linear vibration about static equilibrium: natural frequencies and shapes, \
    and the rotary speeds at which an excitation once or several times a turn coincides with them. \
    Nodes that touch the wall in equilibrium are held by it, the others are free, and friction \
    does not hold: the string slides as it turns.";

/// Number of sentences on torsional stability that are its verdict: the speed from which the string
/// is stable, and the growth at the case's own.
const VERDICT: usize = 2;

/// Returns the page as the text of an HTML file. No name in it can end the element that contains
/// it.
pub fn modes_html(modes: &Modes) -> String {
    study_html_in_units(&modes.head.units, |units| page(modes, units))
}

fn page(modes: &Modes, units: &str) -> StudyPage {
    let display = DisplayUnits::new(&modes.head.dimensions, units);
    let facts = modes.head.facts.iter().filter_map(|fact| display.fact(fact));
    let stability = modes.stability(display.unit_set());
    let reasons = modes.summary.checks.iter();
    let reasons: Vec<String> =
        reasons.map(|check| format!("{}.", check.sentence_in(display.unit_set()))).collect();
    let mut verdict = Vec::new();
    if !modes.summary.stable {
        verdict.push(
            "The static equilibrium is not stable: the motion away from it has no frequency and is \
             left out.",
        );
        verdict.extend(reasons.iter().map(String::as_str));
    }
    if modes.stability_map.is_some() {
        verdict.extend(stability.iter().take(VERDICT).map(String::as_str));
    }
    let facts = format!("{}.", facts.collect::<Vec<_>>().join("; "));
    let mut description = [&*verdict.join(" "), &*facts, ABOUT].join("\n\n");
    if let Some(message) = modes.summary.warning() {
        description += &format!("\n\n{message}.");
    }
    if modes.stability_map.is_none() {
        let reasons = stability.iter();
        description.extend(reasons.map(|why| format!("\n\nNo map of torsional stability: {why}.")));
    }
    let mut parts = vec![modes_part(modes, display), critical_part(modes, display)];
    let captions = [
        (
            "campbell",
            "Campbell diagram",
            "Natural frequencies against rotary speed, dotted for backward whirl; dashed: \
             excitations once, or several times, a turn. Their intersections are critical speeds.",
            "campbell",
        ),
        (
            "mode_shapes",
            "Shapes of the assembly's lateral modes",
            "Displacement over the largest one, towards the high side and to the right of it, and \
             the same a quarter of a period later, which is zero for a planar mode.",
            "mode_shapes",
        ),
        (
            "string_shapes",
            "Shapes of the string's axial and torsional modes",
            "Axial displacement and rotation about the axis, over the largest one.",
            "string_shapes",
        ),
        (
            "response",
            "Response to a force that rotates with the string",
            "Displacement of the assembly from its static equilibrium, and the bending stress that \
             this adds, with the damping of steel, wall and mud. Where it exceeds the clearance, \
             the assembly would hit the wall.",
            "response",
        ),
        (
            "stability",
            "Torsional stability",
            "Rotary speeds and weights on bit at which a small torsional vibration of the drilling \
             string grows into stick-slip, and its growth rate.",
            "stability",
        ),
    ];
    for plot in modes_plots(modes, units) {
        let Some((_, title, caption, files)) =
            captions.iter().find(|(name, ..)| *name == plot.name)
        else {
            continue;
        };
        let caption = match plot.name.as_str() {
            "response" => format!("{caption} It is {}.", modes.forcing(display.unit_set())),
            "stability" => format!("{caption} {}", stability.join(" ")),
            _ => (*caption).to_owned(),
        };
        parts.push(StudyPart::Figure {
            title: (*title).to_owned(),
            caption,
            figure: Some(Box::new(plot.figure)),
            files: (*files).to_owned(),
            painted: false,
        });
    }
    StudyPage {
        program: modes.head.program.clone(),
        title: modes.head.title.clone(),
        description,
        parts,
    }
}

fn place(display: DisplayUnits<'_>, spot: &Spot) -> [String; 2] {
    [display.depth(spot.md_m), spot.component.clone()]
}

fn modes_part(modes: &Modes, display: DisplayUnits<'_>) -> StudyPart {
    let heads = heads(&[
        ("family", true),
        ("mode", false),
        ("frequency, Hz", false),
        ("period, s", false),
        ("1x at", false),
        ("whirl", true),
        ("lateral, axial, torsional energy, %", false),
        ("strained most at MD", false),
        ("component", true),
    ]);
    let rows = modes.summary.modes.iter().map(|mode| {
        let [md, component] = place(display, &mode.most_strained);
        let energy = mode.energy.map(|part| format!("{:.0}", 100.0 * part)).join(", ");
        let speed = std::f64::consts::TAU * mode.frequency_Hz;
        row(vec![
            mode.family.clone(),
            mode.number.to_string(),
            format!("{:.4}", mode.frequency_Hz),
            format!("{:.3}", 1.0 / mode.frequency_Hz),
            format!(
                "{:.1} {}",
                display.value(speed, "rotary speed"),
                display.symbol("rotary speed")
            ),
            mode.whirl.clone().unwrap_or_default(),
            energy,
            md,
            component,
        ])
    });
    StudyPart::Table {
        title: "Natural frequencies".into(),
        caption: "Lateral modes are the assembly's, axial and torsional ones the whole string's."
            .into(),
        grid: Grid { heads, rows: rows.collect() },
        files: "modes".into(),
        endings: &["csv", "parquet"],
    }
}

fn critical_part(modes: &Modes, display: DisplayUnits<'_>) -> StudyPart {
    let heads = heads(&[
        ("rotary speed", false),
        ("order", false),
        ("family", true),
        ("mode", false),
        ("frequency, Hz", false),
        ("strained most at MD", false),
        ("component", true),
    ]);
    let rows = modes.summary.critical_speeds.iter().map(|critical| {
        let [md, component] = place(display, &critical.most_strained);
        let speed = display.value(critical.rotary_speed_rad_per_s, "rotary speed");
        row(vec![
            format!("{speed:.1} {}", display.symbol("rotary speed")),
            order_name(critical.order),
            critical.family.clone(),
            critical.number.to_string(),
            format!("{:.4}", critical.frequency_Hz),
            md,
            component,
        ])
    });
    StudyPart::Table {
        title: "Critical speeds".into(),
        caption: "Rotary speeds at which an order of the rotation coincides with a natural \
            frequency."
            .into(),
        grid: Grid { heads, rows: rows.collect() },
        files: "critical_speeds".into(),
        endings: &["csv", "parquet"],
    }
}
