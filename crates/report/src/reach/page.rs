//! The page of a reach as one file that needs nothing else.

use super::{Reach, ReachRow, figures::reach_plots};
use crate::{
    Grid, StudyPage, StudyPart, Verdict,
    grid_cells::head,
    plots::{SETS, Shown},
    study::study_html_in_units,
    uncertain,
};

/// What the numbers stand for.
const ABOUT: &str = "The well is drilled on in its last direction, and the string grows at its top. At \
    each depth the soft string is held against the limits of rig and string. A margin is what is left \
    of a limit, 0 % where it is met: of the top drive and the hoist against what they carry, of the \
    hook load and the push against what hangs without friction, of yield and buckling against the \
    load that yields or buckles, of lock-up the part of an added push that arrives at the bit.";

/// What stands under the picture of the margins.
const MARGINS: &str = "A colour for each limit, a stroke for each friction factor. Where a curve meets zero \
    the limit is met; the diamond stops the well first. Of uncertain numbers, a band and a bar hold 90 % of \
    the samples: of the margins of what stops the well, and of the depth where it is met.";

/// The page as the text of an HTML file. No name in it can end the element that it stands in.
pub fn reach_html(reach: &Reach) -> String {
    study_html_in_units(&reach.head.units, |units| page(reach, units))
}

fn page(reach: &Reach, units: &str) -> StudyPage {
    let shown = Shown::new(&reach.head.dimensions, units);
    let set = SETS.iter().position(|of| *of == units).unwrap_or(0);
    let facts = reach.head.facts.iter().filter_map(|fact| shown.fact(fact));
    let facts = format!("{}.", facts.collect::<Vec<_>>().join("; "));
    let answers = reach.answers[set].iter().map(String::as_str);
    let notes = reach.notes[set].iter().map(String::as_str);
    let paragraphs = answers.chain([&*facts, ABOUT]).chain(notes);
    let mut parts = Vec::new();
    for plot in reach_plots(reach, units) {
        let (title, caption) = match plot.name.as_str() {
            "uncertain" => ("Sensitivity", uncertain::CAPTION),
            _ => ("Margins against depth", MARGINS),
        };
        parts.push(StudyPart::Figure {
            title: title.into(),
            caption: caption.into(),
            figure: Some(Box::new(plot.figure)),
            files: plot.name,
            painted: false,
        });
    }
    if let Some(of) = &reach.uncertain {
        parts.extend(uncertain::inputs(of));
        parts.extend(uncertain::stops(of));
        parts.extend(uncertain::bands(of, shown));
        parts.extend(uncertain::owed(of));
    }
    parts.push(limits(reach, shown));
    StudyPage {
        program: reach.head.program.clone(),
        title: reach.head.title.clone(),
        description: paragraphs.collect::<Vec<_>>().join("\n\n"),
        parts,
    }
}

fn limits(reach: &Reach, shown: Shown<'_>) -> StudyPart {
    let [from, to] = reach.depths_m.map(|depth_m| shown.depth(depth_m));
    // One friction is that of the whole page, which says it above.
    let several = reach.frictions.len() > 1;
    let mut heads = vec![head("operation", true), head("limit", true)];
    heads.extend(several.then(|| head("friction", true)));
    heads.extend([
        head("met with the bit at", false),
        head(format!("margin at {from}, %"), false),
        head(format!("margin at {to}, %"), false),
        head("worst at MD", false),
        head("then", true),
    ]);
    let row = |of: &ReachRow| -> Vec<(String, Verdict)> {
        let depth = match of.depth_m {
            Some(_) if of.already => format!("{from} already"),
            Some(depth_m) => shown.depth(depth_m),
            None => format!("none to {to}"),
        };
        let [at_from, at_to] = of.margins.map(|of| match of {
            Some(margin) => format!("{:.1}", 100.0 * margin).replace('-', "\u{2212}"),
            None => "locked up".to_owned(),
        });
        let md = of.md_m.map(|md_m| shown.depth(md_m));
        let (word, verdict) = match (of.first, of.stops) {
            (true, _) => ("stops the well first", Verdict::Differs),
            (false, false) if of.depth_m.is_some() => ("goes on buckled", Verdict::None),
            _ => ("", Verdict::None),
        };
        let friction = reach.frictions.get(of.friction).cloned().unwrap_or_default();
        let mut cells = vec![of.operation.clone(), of.limit.clone()];
        cells.extend(several.then_some(friction));
        cells.extend([depth, at_from, at_to, md.unwrap_or_default()]);
        let cells = cells.into_iter().map(|cell| (cell, Verdict::None));
        cells.chain([(word.to_owned(), verdict)]).collect()
    };
    StudyPart::Table {
        title: "Limits".into(),
        caption: "The first depth of the bit at which nothing is left of a limit; how much is left at both ends; \
                  and where in the string it is worst there. A negative margin: what is asked is more than \
                  the limit bears."
            .into(),
        grid: Grid { heads, rows: reach.limits.iter().map(row).collect() },
        files: "reach_limits".into(),
        endings: &["csv", "parquet"],
    }
}
