//! The page of small motions as one file that needs nothing else.

use super::{
    Modes,
    figures::{modes_plots, order_name},
};
use crate::{
    Grid, StudyPage, StudyPart,
    grid_cells::{heads, row},
    plots::Shown,
    study::study_html_in_units,
};

/// What the numbers stand for.
const ABOUT: &str = "Small motions about the string at rest: natural frequencies and shapes, and \
    the rotary speeds at which something that pushes once or several times a turn meets them. \
    Nodes that touch the wall at rest are held by it, nodes that do not are free, and friction \
    does not hold: the string slides as it turns.";

/// The page as the text of an HTML file. No name in it can end the element that it stands in.
pub fn modes_html(modes: &Modes) -> String {
    study_html_in_units(&modes.head.units, |units| page(modes, units))
}

fn page(modes: &Modes, units: &str) -> StudyPage {
    let shown = Shown::new(&modes.head.dimensions, units);
    let facts = modes.head.facts.iter().filter_map(|fact| shown.fact(fact));
    let mut description = format!("{}.\n\n{ABOUT}", facts.collect::<Vec<_>>().join("; "));
    if !modes.stable {
        description += "\n\nThe string at rest is not stable: what it would leave that state by \
                        has no frequency and is left out.";
    }
    if let Some(message) = &modes.message {
        description += &format!("\n\n{message}.");
    }
    if modes.stability_map.is_none() {
        let reasons = modes.stability.iter();
        description.extend(reasons.map(|why| format!("\n\nNo map of torsional stability: {why}.")));
    }
    let mut parts = vec![modes_part(modes, shown), critical_part(modes, shown)];
    let captions = [
        (
            "campbell",
            "Campbell diagram",
            "Natural frequencies against rotary speed, dotted where the mode goes round against \
             the rotation; dashed what pushes once, or so many times, a turn. Where they meet is a \
             critical speed.",
            "campbell",
        ),
        (
            "mode_shapes",
            "Shapes of the assembly's lateral modes",
            "Displacement over the largest one, towards the high side and to the right of it, and \
             the same a quarter of a period later: a mode that goes to and fro has none of that.",
            "mode_shapes",
        ),
        (
            "string_shapes",
            "Shapes of the string's axial and torsional modes",
            "Displacement along the hole and turn about the axis, over the largest one.",
            "string_shapes",
        ),
        (
            "response",
            "Response to a force that rotates with the string",
            "How far the assembly goes from where it rests, and the bending stress that this adds, \
             with the damping of steel, wall and mud. Where it goes farther than the clearance it \
             would hit the wall.",
            "response",
        ),
        (
            "stability",
            "Torsional stability",
            "Rotary speeds and weights on bit at which a small swing of the string that drills grows \
             until it sticks and slips, and how fast.",
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
            "response" => format!("{caption} It is {}.", modes.forcing),
            "stability" => format!("{caption} {}", modes.stability.join(" ")),
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

fn place(shown: Shown<'_>, of: &(f64, String)) -> [String; 2] {
    [shown.depth(of.0), of.1.clone()]
}

fn modes_part(modes: &Modes, shown: Shown<'_>) -> StudyPart {
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
    let rows = modes.modes.iter().map(|of| {
        let [md, component] = place(shown, &of.most_strained);
        let energy = of.energy.map(|part| format!("{:.0}", 100.0 * part)).join(", ");
        let speed = std::f64::consts::TAU * of.frequency_Hz;
        row(vec![
            of.family.clone(),
            of.number.to_string(),
            format!("{:.4}", of.frequency_Hz),
            format!("{:.3}", 1.0 / of.frequency_Hz),
            format!("{:.1} {}", shown.value(speed, "rotary speed"), shown.symbol("rotary speed")),
            of.whirl.clone().unwrap_or_default(),
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

fn critical_part(modes: &Modes, shown: Shown<'_>) -> StudyPart {
    let heads = heads(&[
        ("rotary speed", false),
        ("order", false),
        ("family", true),
        ("mode", false),
        ("frequency, Hz", false),
        ("strained most at MD", false),
        ("component", true),
    ]);
    let rows = modes.critical.iter().map(|of| {
        let [md, component] = place(shown, &of.most_strained);
        let speed = shown.value(of.rotary_rad_per_s, "rotary speed");
        row(vec![
            format!("{speed:.1} {}", shown.symbol("rotary speed")),
            order_name(of.order),
            of.family.clone(),
            of.number.to_string(),
            format!("{:.4}", of.frequency_Hz),
            md,
            component,
        ])
    });
    StudyPart::Table {
        title: "Critical speeds".into(),
        caption: "Where an order of the rotation meets a natural frequency.".into(),
        grid: Grid { heads, rows: rows.collect() },
        files: "critical_speeds".into(),
        endings: &["csv", "parquet"],
    }
}
