//! The page of a reach as one self-contained file.

use wholestring_results::{ReachCheck, ReachLimit, ReachOfFriction};

use super::{Reach, end_of_limit, figures::reach_plots, is_first, reach_answers, sentences};
use crate::{
    Grid, StudyPage, StudyPart, Verdict, grid_cells::head, plots::DisplayUnits,
    study::study_html_in_units, uncertain,
};

/// Method, and meaning of the margins.
const METHOD: &str = "The well is continued in its last direction, and the string is lengthened at \
    its top. At each depth the soft string is compared with the limits of rig and string. A margin \
    is the remaining part of a limit, 0 % where it is reached: for the top drive and the hoist \
    relative to their capacities, for the hook load and the push relative to the hanging weight \
    without friction, for yield and buckling relative to the yield or critical load; for the \
    absorbed push it is the part of an added push that reaches the bit.";

/// Caption of the picture of the margins.
const MARGINS: &str = "A colour for each limit, a stroke for each friction factor. A limit is \
    reached where its curve is zero; the diamond marks the limit that stops the well first, a \
    grey point the beginning of buckling that stops nothing. Margins that stay at 100 % have no \
    curve. For uncertain numbers, a band and a bar contain 90 % of the samples: the band those of \
    the margins of limits that stop the well, the bar those of the depth where the limit is \
    reached.";

/// Returns the page as the text of an HTML file. No name in it can end the element that contains
/// it.
pub fn reach_html(reach: &Reach) -> String {
    study_html_in_units(&reach.head.units, |units| page(reach, units))
}

fn page(reach: &Reach, units: &str) -> StudyPage {
    let display = DisplayUnits::new(&reach.head.dimensions, units);
    let facts = reach.head.facts.iter().filter_map(|fact| display.fact(fact));
    let facts = format!("{}.", facts.collect::<Vec<_>>().join("; "));
    let mut answers = reach_answers(&reach.summary, display.unit_set());
    answers.push(facts);
    let mut parts: Vec<StudyPart> = verdicts(reach, display).into_iter().collect();
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
    if let Some(samples) = reach.uncertain() {
        parts.extend(uncertain::inputs(samples));
        parts.extend(uncertain::stops(samples));
        parts.extend(uncertain::bands(samples, display));
        parts.extend(uncertain::owed(samples));
    }
    parts.push(limits(reach, display));
    let mut notes = vec![METHOD.to_owned()];
    notes.extend(sentences::assumptions(&reach.summary, display.unit_set()));
    parts.push(StudyPart::Text { title: "Notes".into(), text: notes.join("\n\n") });
    StudyPage {
        program: reach.head.program.clone(),
        title: reach.head.title.clone(),
        description: answers.join("\n\n"),
        parts,
    }
}

/// The reach of each operation at each friction, the most severe first.
fn verdicts(reach: &Reach, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let several = reach.has_frictions();
    let mut heads = vec![head("operation", true), head("reach", true)];
    heads.extend(several.then(|| head("friction", true)));
    let mut checks: Vec<&ReachCheck> = reach.summary.checks.iter().collect();
    checks.sort_by_key(|row| std::cmp::Reverse(row.check.severity));
    let row = |row: &ReachCheck| {
        let sentence = row.check.sentence_in(display.unit_set());
        let (operation, reached) = sentence.split_once(": ").unwrap_or(("", &sentence));
        let mut cells = vec![
            (operation.to_owned(), Verdict::Judged(row.check.severity)),
            (reached.to_owned(), Verdict::None),
        ];
        cells.extend(several.then(|| (sentences::friction_words(row.friction), Verdict::None)));
        cells
    };
    let rows: Vec<_> = checks.into_iter().map(row).collect();
    let mut caption = format!(
        "How far each operation goes, the most severe first: short of the planned depth is an \
         error. {}",
        sentences::SOFT
    );
    if !reach.summary.unchecked.is_empty() {
        let unchecked = reach.summary.unchecked.join("; ");
        caption += &format!(" Not checked for want of data: {unchecked}.");
    }
    (!rows.is_empty()).then(|| StudyPart::Table {
        title: "Verdict".into(),
        caption,
        grid: Grid { heads, rows },
        files: "summary".into(),
        endings: &["json"],
    })
}

fn limits(reach: &Reach, display: DisplayUnits<'_>) -> StudyPart {
    let summary = &reach.summary;
    let [from, to] = [summary.from_m, summary.to_m].map(|depth_m| display.depth(depth_m));
    // A single friction is given above, for the whole page.
    let several = reach.has_frictions();
    // The depth is the answer: it is in sight on a narrow page too.
    let mut heads =
        vec![head("limit", true), head("reached with the bit at", false), head("operation", true)];
    heads.extend(several.then(|| head("friction", true)));
    heads.extend([
        head(format!("margin at {from}, %"), false),
        head(format!("margin at {to}, %"), false),
        head("worst at MD", false),
        head("then", true),
    ]);
    let row = |(reach, row): (&ReachOfFriction, &ReachLimit)| -> Vec<(String, Verdict)> {
        let depth = end_of_limit(row, summary, |depth_m| display.depth(depth_m));
        let [at_from, at_to] = [row.margin_at_from, row.margin_at_to].map(|margin| match margin {
            Some(margin) => format!("{:.1}", 100.0 * margin).replace('-', "\u{2212}"),
            None => "locked up".to_owned(),
        });
        let md = row.at_md_m.map(|md_m| display.depth(md_m));
        let (word, verdict) = match (is_first(reach, row), row.stops) {
            (true, _) => ("stops the well first", Verdict::Differs),
            (false, false) if row.depth_m.is_some() => ("continues buckled", Verdict::None),
            _ => ("", Verdict::None),
        };
        let mut cells = vec![row.title.clone(), depth, row.operation.words().to_owned()];
        cells.extend(several.then(|| sentences::friction(reach)));
        cells.extend([at_from, at_to, md.unwrap_or_default()]);
        let cells = cells.into_iter().map(|cell| (cell, Verdict::None));
        cells.chain([(word.to_owned(), verdict)]).collect()
    };
    StudyPart::Table {
        title: "Limits".into(),
        caption: "The first depth of the bit at which a limit is reached; the margins at both \
                  ends; and the place of the smallest margin in the string. A negative margin: the \
                  load exceeds the limit."
            .into(),
        grid: Grid { heads, rows: reach.limits().map(row).collect() },
        files: "reach_limits".into(),
        endings: &["csv", "parquet"],
    }
}
