//! The page of a plan as one self-contained file.

use super::{
    Plan, along, broomstick, buckling, campaign, limits, measured, mud, overlay, peaks, roadmap,
    tables,
};
use crate::{
    Plot, StudyPage, StudyPart,
    plots::{DisplayUnits, named},
    study::study_html_in_units,
    uncertain,
};

/// Meaning of the page's numbers.
const ABOUT: &str = "Hook load and surface torque against the depth of the bit: the string, cut at \
    the surface at each depth, in each operation with low, expected and high friction. The \
    workbook plan.xlsx has every table, with charts of its own.";

/// Name, title and caption of the pictures of operations against depth.
const BROOMSTICKS: [(&str, &str, &str); 2] = [
    (
        "hook_load",
        "Hook load",
        "Trip in to the left, rotate off bottom in the middle, trip out to the right; the friction \
         is at the end of each line. Where a line ends early, there is no answer below. Dotted \
         across: casing shoes. Dashed down: the allowable hook load: the hoist's capacity over its \
         factor less the block, the tensile yield of the topmost pipe over its factor.",
    ),
    (
        "torque",
        "Surface torque",
        "Operations that rotate; the friction is at the end of each line. Dashed down: the \
         allowable torque: top drive, make-up and torsional yield of the topmost pipe, each over \
         its factor.",
    ),
];

/// Name, title and caption of the other pictures.
const PICTURES: [(&str, &str, &str); 4] = [
    (
        "buckling_weight",
        "Weight to buckle",
        "The least weight on bit at which part of the string buckles to a sinusoid, or to a helix: \
         a chart for the string that rotates, and one for the string that slides, where friction \
         reduces the push on the way down.",
    ),
    (
        "hydraulics",
        "Mud",
        "Pressure at the standpipe, and the equivalent density of mud and friction at the bit and \
         at the deepest casing shoe: circulating, and tripping at the case's speed with the string \
         closed or open to the mud. The limit of the pump is its own, without a factor.",
    ),
    ("uncertain", "Sensitivity", uncertain::CAPTION),
    (
        "peaks",
        "Setting in motion",
        "By the dynamics: a string that hangs at rest is lifted from the slips or lowered, or its \
         pumps or its rotary start, in the time that the plan gives. A dot is the peak.",
    ),
];

/// Returns the page as the text of an HTML file. No name in it can end the element that contains
/// it.
pub fn plan_html(plan: &Plan) -> String {
    study_html_in_units(&plan.head.units, |units| page(plan, units))
}

fn page(plan: &Plan, units: &str) -> StudyPage {
    let display = DisplayUnits::new(&plan.head.dimensions, units);
    let facts = plan.head.facts.iter().filter_map(|fact| display.fact(fact));
    let mut description = format!("{}.\n\n{ABOUT}", facts.collect::<Vec<_>>().join("; "));
    if let Some(message) = plan.message() {
        description += &format!("\n\n{message}");
    }
    let plots = plan_plots(plan, units);
    let picture = |(name, title, caption): &(&str, &str, &str)| {
        let plot = plots.iter().find(|plot| plot.name == *name)?;
        let is_broomstick = BROOMSTICKS.iter().any(|broomstick| broomstick.0 == *name);
        let measured = match !plan.summary.measured.is_empty() && is_broomstick {
            true => " Diamonds: readings, grey where they are held out.",
            false => "",
        };
        let overlay = match *name {
            "hook_load" | "torque" => overlay::caption(plan, *name == "torque"),
            _ => String::new(),
        };
        Some(StudyPart::Figure {
            title: (*title).to_owned(),
            caption: format!("{caption}{measured}{overlay}"),
            figure: Some(Box::new(plot.figure.clone())),
            files: (*name).to_owned(),
            painted: false,
        })
    };
    // Whether it can be done, then what the rig floor needs, then everything else.
    let mut parts: Vec<StudyPart> = limits::verdicts(plan, display).into_iter().collect();
    parts.extend(limits::factors(plan, display));
    parts.extend(BROOMSTICKS.iter().filter_map(picture));
    parts.extend(roadmap::table(plan, display));
    parts.extend(PICTURES.iter().filter_map(picture));
    if let Some(samples) = plan.samples() {
        parts.extend(uncertain::inputs(samples));
        parts.extend(uncertain::bands(samples, display));
        parts.extend(uncertain::owed(samples));
    }
    parts.extend(measured::table(plan, display));
    parts.extend(overlay::table(plan, display));
    parts.extend(limits::nearest(plan, display));
    parts.extend(peaks::table(plan, display));
    parts.extend(campaign::parts(plan, display));
    parts.extend(campaign::fatigue(plan, display));
    parts.extend(campaign::wear(plan, display));
    parts.extend(tables::at_depth(plan, display));
    parts.push(tables::frictions(plan));
    parts.extend(tables::against_depth(plan, display));
    parts.extend(tables::buckling(plan, display));
    parts.extend(tables::mud(plan, display));
    parts.extend(along::tables(plan, display));
    parts.extend(tables::without_answer(plan, display));
    StudyPage {
        program: plan.head.program.clone(),
        title: plan.head.title.clone(),
        description,
        parts,
    }
}

// All pictures of a plan.

/// Names of the pictures of a plan.
pub const PLAN_PICTURES: [&str; 6] =
    ["hook_load", "torque", "buckling_weight", "hydraulics", "uncertain", "peaks"];

/// Returns every picture of a plan with content, in a set of units (`si`, `metric` or `field`).
pub fn plan_plots(plan: &Plan, units: &str) -> Vec<Plot> {
    let display = DisplayUnits::new(&plan.head.dimensions, units);
    let owed = plan.samples();
    let figures = [
        broomstick::hook_load(plan, display),
        broomstick::torque(plan, display),
        buckling::figure(plan, display),
        mud::figure(plan, display),
        owed.and_then(|samples| uncertain::figure(samples, &plan.head.title)),
        peaks::figure(plan, display),
    ];
    named(PLAN_PICTURES, figures)
}
