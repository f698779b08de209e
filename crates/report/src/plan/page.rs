//! The page of a plan as one file that needs nothing else.

use super::{Plan, campaign, figures::plan_plots, limits, measured, overlay, peaks, tables};
use crate::{
    StudyPage, StudyPart,
    plots::{SETS, Shown},
    study::study_html_in_units,
    uncertain,
};

/// Meaning of the page's numbers.
const ABOUT: &str = "Hook load and surface torque against the depth of the bit: the string, cut at \
    the surface at each depth, in each operation with low, expected and high friction. The \
    workbook plan.xlsx has every table, with charts of its own.";

/// Title and caption of each picture.
const PICTURES: [(&str, &str, &str); 6] = [
    (
        "hook_load",
        "Hook load",
        "Trip in to the left, rotate off bottom in the middle, trip out to the right; the friction is at \
         the end of each line. Where a line ends early, the string has no answer below. Dotted \
         across: casing shoes. Dashed down: what the hook load may come to, as the limits judge it: \
         the hoist's capacity over its factor less the block, the tensile yield of the topmost pipe \
         over its factor.",
    ),
    (
        "torque",
        "Surface torque",
        "Of what turns; the friction is at the end of each line. Dashed down: what the torque \
         may come to, as the limits judge it: top drive, make-up and torsional yield of the topmost \
         pipe, each over its factor.",
    ),
    (
        "buckling_weight",
        "Weight to buckle",
        "The least weight on bit under which the string begins to be a sinusoid, or a helix, \
         somewhere: left turning, right sliding, where friction takes a part of the push on the way \
         down.",
    ),
    (
        "hydraulics",
        "Mud",
        "Pressure at the standpipe, and the density that weighs as much as mud and friction at the bit and \
         at the deepest casing shoe: circulating, and tripping at the case's speed with mud shut out of \
         the string or streaming through it. The limit of the pump is its own, without a factor.",
    ),
    ("uncertain", "Sensitivity", uncertain::CAPTION),
    (
        "peaks",
        "Setting in motion",
        "By the dynamics: a string that hangs at rest is lifted from the slips or lowered, its pumps or its \
         rotary start, in the time that the plan states. A dot is the peak.",
    ),
];

/// The page as the text of an HTML file. No name in it can end the element that it stands in.
pub fn plan_html(plan: &Plan) -> String {
    study_html_in_units(&plan.head.units, |units| page(plan, units))
}

fn page(plan: &Plan, units: &str) -> StudyPage {
    let shown = Shown::new(&plan.head.dimensions, units);
    let facts = plan.head.facts.iter().filter_map(|fact| shown.fact(fact));
    let mut description = format!("{}.\n\n{ABOUT}", facts.collect::<Vec<_>>().join("; "));
    let set = SETS.iter().position(|of| *of == units).unwrap_or(0);
    if let Some(message) = &plan.message {
        description += &format!("\n\n{message}");
    }
    let plots = plan_plots(plan, units);
    let pictures = PICTURES.iter().filter_map(|(name, title, caption)| {
        let plot = plots.iter().find(|plot| plot.name == *name)?;
        let is_broomstick = ["hook_load", "torque"].contains(name);
        let measured = match !plan.measured.is_empty() && is_broomstick {
            true => " Diamonds: what was measured, grey where it is held out.",
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
    });
    let mut parts: Vec<StudyPart> = limits::verdicts(plan).into_iter().collect();
    parts.extend(limits::governing(&plan.first[set]));
    parts.extend(pictures);
    if let Some(of) = &plan.uncertain {
        parts.extend(uncertain::inputs(of));
        parts.extend(uncertain::bands(of, shown));
        parts.extend(uncertain::owed(of));
    }
    parts.extend(measured::table(plan, shown));
    parts.extend(overlay::table(plan, shown));
    parts.extend(limits::factors(plan));
    parts.extend(limits::nearest(plan, shown));
    parts.extend(peaks::table(plan, shown));
    parts.extend(campaign::parts(plan));
    parts.extend(campaign::fatigue(plan, shown));
    parts.extend(campaign::wear(plan, shown));
    parts.extend(tables::at_depth(plan, shown));
    parts.push(tables::frictions(plan));
    parts.extend(tables::against_depth(plan, shown));
    parts.extend(tables::buckling(plan, shown));
    parts.extend(tables::mud(plan, shown));
    parts.extend(tables::without_answer(plan));
    StudyPage {
        program: plan.head.program.clone(),
        title: plan.head.title.clone(),
        description,
        parts,
    }
}
