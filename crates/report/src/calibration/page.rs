//! The page of a calibration as one file that needs nothing else.

use super::{
    Calibration,
    figures::{calibration_plots, said},
};
use crate::{
    Grid, StudyPage, StudyPart, Verdict,
    grid_cells::{head, heads, row},
    operation_words::four,
    plots::Shown,
    study::study_html_in_units,
};

/// What the numbers stand for.
const ABOUT: &str = "What friction was, by what was read at the surface: the numbers that make the \
    readings most likely, how well the readings tell them, and what would be read at other depths.";

/// The page as the text of an HTML file. No name in it can end the element that it stands in.
pub fn calibration_html(of: &Calibration) -> String {
    study_html_in_units(&of.head.units, |units| page(of, units))
}

fn page(of: &Calibration, units: &str) -> StudyPage {
    let shown = Shown::new(&of.head.dimensions, units);
    let facts = of.head.facts.iter().filter_map(|fact| shown.fact(fact));
    let mut description = format!("{}.\n\n{ABOUT}", facts.collect::<Vec<_>>().join("; "));
    description.extend(of.warnings.iter().map(|text| format!("\n\nWarning: {text}.")));
    let [interval, band] = of.confidence.map(|of| format!("{:.0} %", 100.0 * of));
    let captions = [
        (
            "Measured and predicted",
            format!(
                "Lines: the model with the numbers found. Dark: the band of {band} within which the \
                 model's value lies, by what the readings leave open. Light: within which {band} of \
                 readings lie. Points: what was read."
            ),
        ),
        (
            "Residuals against depth",
            format!(
                "Measured less predicted, over the standard error that it has after the fit. A trend \
                 with depth is something that the model does not know. Beyond {} an outlier.",
                of.outlier_beyond
            ),
        ),
        (
            "Profiles of the likelihood",
            format!(
                "Each number held, all others at their best: how much the sum of squared residuals \
                 grows. Rules: the ends of the interval of {interval}. Where the curves part, the \
                 standard error alone misleads."
            ),
        ),
    ];
    let mut parts = vec![estimates(of, shown, &interval)];
    parts.extend(comparison(of, shown));
    for (plot, (title, caption)) in calibration_plots(of, units).into_iter().zip(captions) {
        parts.push(StudyPart::Figure {
            title: title.to_owned(),
            caption,
            files: plot.name,
            figure: Some(Box::new(plot.figure)),
            painted: false,
        });
    }
    parts.extend(dynamics(of, shown));
    parts.push(correlations(of));
    parts.push(readings(of, shown));
    parts.extend(notes(of));
    StudyPage { program: of.head.program.clone(), title: of.head.title.clone(), description, parts }
}

fn estimates(of: &Calibration, shown: Shown<'_>, interval: &str) -> StudyPart {
    let interval = format!("interval of {interval}");
    let heads =
        heads(&[("number", true), ("value", false), ("standard error", false), (&interval, false)]);
    let rows = of.estimates.iter().map(|row_of| {
        // A factor in four digits; a weight as people say it.
        let say = |value: f64| match row_of.dimension.as_str() {
            "" => format!("{value:.4}"),
            dimension => shown.quantity(value, dimension),
        };
        let end = |end: Option<f64>| end.map_or("not found".to_owned(), say);
        row(vec![
            row_of.words.clone(),
            say(row_of.value),
            row_of.standard_error.map_or("at its bound".to_owned(), say),
            format!("{} to {}", end(row_of.interval[0]), end(row_of.interval[1])),
        ])
    });
    let errors = of.errors.iter().map(|(which, error, is_torque, given, count)| {
        let dimension = if *is_torque { "torque" } else { "force" };
        let how = if *given { "as given" } else { "estimated" };
        format!("{count} {which}: {} ({how})", shown.quantity(*error, dimension))
    });
    StudyPart::Table {
        title: "What was found".into(),
        caption: format!(
            "Standard errors of the readings: {}.",
            errors.collect::<Vec<_>>().join("; ")
        ),
        grid: Grid { heads, rows: rows.collect() },
        files: "summary".into(),
        endings: &["json"],
    }
}

/// All readings beside those without the outliers.
fn comparison(of: &Calibration, shown: Shown<'_>) -> Option<StudyPart> {
    let other = of.comparison.as_ref()?;
    let heads = heads(&[("number", true), ("all readings", false), ("without outliers", false)]);
    let rows = of.estimates.iter().map(|own| {
        let say = |value: f64| match own.dimension.as_str() {
            "" => format!("{value:.4}"),
            dimension => shown.quantity(value, dimension),
        };
        let text = |value: f64, error: Option<f64>| match error {
            Some(error) => format!("{} ± {}", say(value), say(error)),
            None => say(value),
        };
        let same = other.values.iter().find(|(words, ..)| *words == own.words);
        let same = same.map_or("–".to_owned(), |(_, value, error)| text(*value, *error));
        let own_text = text(own.value, own.standard_error);
        let [all, without] = if other.left_out { [same, own_text] } else { [own_text, same] };
        row(vec![own.words.clone(), all, without])
    });
    Some(StudyPart::Table {
        title: "With and without outliers".into(),
        caption: format!(
            "Outliers, found by {}'s loss: {}. The answer above is that {}.",
            other.loss,
            other.outliers.join(", "),
            if other.left_out { "without them" } else { "of all readings" }
        ),
        grid: Grid { heads, rows: rows.collect() },
        files: "summary".into(),
        endings: &["json"],
    })
}

fn dynamics(of: &Calibration, shown: Shown<'_>) -> Option<StudyPart> {
    let heads = heads(&[
        ("reading", true),
        ("place", true),
        ("bit depth", false),
        ("measured", false),
        ("fitted", false),
        ("in motion", false),
        ("±", false),
        ("", true),
    ]);
    let rows = of.dynamics.iter().map(|check| {
        let dimension = if check.is_torque { "torque" } else { "force" };
        let quantity = |value: f64| shown.quantity(value, dimension);
        let [mean, std] = match check.dynamic {
            Some(of) => of.map(quantity),
            None => ["no answer".to_owned(), "–".to_owned()],
        };
        row(vec![
            said(&check.reading).to_owned(),
            check.place.clone(),
            shown.quantity(check.bit_depth_m, "length"),
            quantity(check.measured),
            quantity(check.predicted),
            mean,
            std,
            check.said.clone(),
        ])
    });
    let grid = Grid { heads, rows: rows.collect() };
    (!of.dynamics.is_empty()).then(|| StudyPart::Table {
        title: "Checked by the dynamics".into(),
        caption: "The whole string in motion with the numbers that were found: mean and standard deviation against \
                  time. Weights with the block's."
            .into(),
        grid,
        files: "calibration_dynamic".into(),
        endings: &["csv", "parquet"],
    })
}

fn correlations(of: &Calibration) -> StudyPart {
    let mut names = vec![("", true)];
    names.extend(of.estimates.iter().map(|of| (of.words.as_str(), false)));
    let rows = of.estimates.iter().zip(&of.correlation).map(|(estimate, correlation)| {
        let mut cells = vec![estimate.words.clone()];
        cells.extend(correlation.iter().map(|of| format!("{of:.3}").replace('-', "\u{2212}")));
        row(cells)
    });
    StudyPart::Table {
        title: "Correlations".into(),
        caption: "Near 1 or −1 the readings tell two numbers together and neither alone.".into(),
        grid: Grid { heads: heads(&names), rows: rows.collect() },
        files: "summary".into(),
        endings: &["json"],
    }
}

fn readings(of: &Calibration, shown: Shown<'_>) -> StudyPart {
    // One case is that of the whole page.
    let several = of.points.iter().any(|point| point.case != of.points[0].case);
    let mut heads = vec![head("reading", true)];
    heads.extend(several.then(|| head("case", true)));
    heads.extend([
        head("place", true),
        head("bit depth", false),
        head("measured", false),
        head("predicted", false),
        head(format!("band of {:.0} %", 100.0 * of.confidence[1]), false),
        head("residual", false),
        head("in standard errors", false),
        head("in the fit", true),
        head("in its band", true),
    ]);
    let rows = of.points.iter().map(|point| {
        let dimension = if point.is_torque { "torque" } else { "force" };
        let number = |si: f64| four(shown.value(si, dimension));
        let load = |si: f64| format!("{} {}", number(si), shown.symbol(dimension));
        let mut cells = vec![said(&point.reading).to_owned()];
        cells.extend(several.then(|| point.case.clone()));
        cells.extend([
            point.place.clone(),
            shown.quantity(point.bit_depth_m, "length"),
            load(point.measured),
            load(point.predicted),
            format!("{} to {}", load(point.reading_band[0]), load(point.reading_band[1])),
            load(point.residual),
            format!("{:.2}", point.standardised).replace('-', "\u{2212}"),
            if point.used { "yes" } else { "held out" }.to_owned(),
        ]);
        let mut cells = row(cells);
        cells.push(match (point.outlier, point.within_band) {
            (true, _) => ("outlier".to_owned(), Verdict::Differs),
            (false, true) => ("yes".to_owned(), Verdict::Agrees),
            (false, false) => ("no".to_owned(), Verdict::None),
        });
        cells
    });
    StudyPart::Table {
        title: "Readings".into(),
        caption: "Weights with the block's. Place: where the reading stands in its file. Band: \
                  within which such a reading lies. Residual: measured less predicted, and the same \
                  over its standard error."
            .into(),
        grid: Grid { heads, rows: rows.collect() },
        files: "calibration".into(),
        endings: &["csv", "parquet"],
    }
}

/// How the readings were taken, and what was held.
fn notes(of: &Calibration) -> Option<StudyPart> {
    let rows = of.notes.iter().map(|text| row(vec![text.replace('`', "")]));
    let grid = Grid { heads: heads(&[("note", true)]), rows: rows.collect() };
    (!grid.rows.is_empty()).then(|| StudyPart::Table {
        title: "Notes".into(),
        caption: "What was taken from the file of readings, and what was assumed; in the units of the case."
            .into(),
        grid,
        files: "summary".into(),
        endings: &["json"],
    })
}
