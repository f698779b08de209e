//! The page of a calibration as one self-contained file.

use wholestring_results::{DynamicCheck, EstimateFound};

use super::{
    Calibration, dimension,
    figures::{calibration_plots, reading_words},
};
use crate::{
    Grid, StudyPage, StudyPart, Verdict,
    cell::four,
    grid_cells::{head, heads, row},
    plots::DisplayUnits,
    study::study_html_in_units,
};

/// Meaning of the page's numbers.
const ABOUT: &str = "Friction derived from readings at the surface: the parameters that make the \
    readings most likely, their uncertainty, and predicted readings at other depths.";

/// Returns the page as the text of an HTML file. No name in it can end the element that contains
/// it.
pub fn calibration_html(calibration: &Calibration) -> String {
    study_html_in_units(&calibration.head.units, |units| page(calibration, units))
}

fn page(calibration: &Calibration, units: &str) -> StudyPage {
    let display = DisplayUnits::new(&calibration.head.dimensions, units);
    let facts = calibration.head.facts.iter().filter_map(|fact| display.fact(fact));
    let set = display.unit_set();
    let summary = &calibration.summary;
    let status = calibration.text(&summary.status, set);
    let band = Some(status).filter(|band| !band.is_empty());
    let facts = facts.chain(band.map(|band| format!("band {band}")));
    let mut description = format!("{}.\n\n{ABOUT}", facts.collect::<Vec<_>>().join("; "));
    let warnings = summary.warnings.iter().map(|text| calibration.text(text, set));
    description.extend(warnings.map(|text| format!("\n\nWarning: {text}.")));
    let [interval, band] = [summary.confidence, summary.band_confidence]
        .map(|confidence| format!("{:.0} %", 100.0 * confidence));
    let captions = [
        (
            "Measured and predicted",
            format!(
                "Lines: the model with the fitted parameters. Dark: the {band} band of the model's \
                 value, from the uncertainty of the parameters. Light: the band that contains \
                 {band} of readings. Points: the readings."
            ),
        ),
        (
            "Residuals against depth",
            format!(
                "Measured less predicted, over its standard error after the fit. A trend with \
                 depth is an effect that the model leaves out. {}",
                outliers_caption(calibration)
            ),
        ),
        (
            "Profiles of the likelihood",
            format!(
                "Increase of the sum of squared residuals with each parameter fixed and all others \
                 fitted. Rules: the ends of the interval of {interval}. Where the two curves \
                 differ, the standard error alone is misleading."
            ),
        ),
    ];
    let mut parts = vec![estimates(calibration, display, &interval)];
    parts.extend(comparison(calibration, display));
    for (plot, (title, caption)) in calibration_plots(calibration, units).into_iter().zip(captions)
    {
        parts.push(StudyPart::Figure {
            title: title.to_owned(),
            caption,
            files: plot.name,
            figure: Some(Box::new(plot.figure)),
            painted: false,
        });
    }
    parts.extend(dynamics(calibration, display));
    parts.push(correlations(calibration));
    parts.push(readings(calibration, display));
    parts.extend(notes(calibration, display));
    StudyPage {
        program: calibration.head.program.clone(),
        title: calibration.head.title.clone(),
        description,
        parts,
    }
}

/// Caption of the outliers. With a comparison, those of the robust fit are measured by its scale,
/// which wrong readings do not widen, so that a reading can be an outlier of that fit within the rules.
fn outliers_caption(calibration: &Calibration) -> String {
    let beyond = calibration.summary.outlier_beyond;
    match &calibration.summary.comparison {
        Some(comparison) => format!(
            "Rules: {beyond} standard errors of this fit, beyond which a reading is marked. The \
             outliers under \"With and without outliers\" are these and those of the fit with {}'s \
             loss, over the scale of its own residuals, which is smaller than the standard error \
             here: the latter may be within the rules.",
            comparison.loss
        ),
        None => format!("Beyond {beyond} a reading is an outlier."),
    }
}

fn estimates(calibration: &Calibration, display: DisplayUnits<'_>, interval: &str) -> StudyPart {
    let interval = format!("interval of {interval}");
    let heads =
        heads(&[("number", true), ("value", false), ("standard error", false), (&interval, false)]);
    let rows = calibration.summary.estimates.iter().map(|estimate| {
        // A factor in four digits; a weight in the usual ones.
        let say = |value: f64| match dimension(estimate) {
            "" => format!("{value:.4}"),
            dimension => display.quantity(value, dimension),
        };
        let end = |end: Option<f64>| end.map_or("not found".to_owned(), say);
        row(vec![
            estimate.words.clone(),
            say(estimate.value),
            estimate.standard_error.map_or("at its bound".to_owned(), say),
            format!("{} to {}", end(estimate.interval[0]), end(estimate.interval[1])),
        ])
    });
    let errors = calibration.summary.errors.iter().map(|error| {
        let dimension = if error.is_torque { "torque" } else { "force" };
        let how = if error.given { "as given" } else { "estimated" };
        let size = display.quantity(error.standard_error, dimension);
        format!("{} {}: {size} ({how})", error.count, error.readings)
    });
    StudyPart::Table {
        title: "Fitted parameters".into(),
        caption: format!(
            "Standard errors of the readings: {}.",
            errors.collect::<Vec<_>>().join("; ")
        ),
        grid: Grid { heads, rows: rows.collect() },
        files: "summary".into(),
        endings: &["json"],
    }
}

/// Comparison of the estimates from all readings with those without the outliers.
fn comparison(calibration: &Calibration, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let other = calibration.summary.comparison.as_ref()?;
    let heads = heads(&[("number", true), ("all readings", false), ("without outliers", false)]);
    let rows = calibration.summary.estimates.iter().map(|own| {
        let say = |value: f64| match dimension(own) {
            "" => format!("{value:.4}"),
            dimension => display.quantity(value, dimension),
        };
        let text = |estimate: &EstimateFound| match estimate.standard_error {
            Some(error) => format!("{} ± {}", say(estimate.value), say(error)),
            None => say(estimate.value),
        };
        let same = other.estimates.iter().find(|estimate| estimate.words == own.words);
        let same = same.map_or("–".to_owned(), text);
        let own_text = text(own);
        let [all, without] = if other.left_out { [same, own_text] } else { [own_text, same] };
        row(vec![own.words.clone(), all, without])
    });
    Some(StudyPart::Table {
        title: "With and without outliers".into(),
        caption: format!(
            "Outliers: {}. The result above is that {}.",
            other.outliers.join(", "),
            if other.left_out { "without them" } else { "of all readings" }
        ),
        grid: Grid { heads, rows: rows.collect() },
        files: "summary".into(),
        endings: &["json"],
    })
}

fn dynamics(calibration: &Calibration, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let heads = heads(&[
        ("reading", true),
        ("place", true),
        ("bit depth", false),
        ("measured", false),
        ("fitted", false),
        ("dynamic run", false),
        ("±", false),
        ("", true),
    ]);
    let rows = calibration.summary.dynamics.iter().map(|check| {
        let dimension = if check.is_torque { "torque" } else { "force" };
        let quantity = |value: f64| display.quantity(value, dimension);
        let [mean, std] = match check.dynamic {
            Some(motion) => [motion.mean, motion.std].map(quantity),
            None => ["no answer".to_owned(), "–".to_owned()],
        };
        row(vec![
            reading_words(&check.reading).to_owned(),
            check.place.clone(),
            display.quantity(check.bit_depth_m, "length"),
            quantity(check.measured),
            quantity(check.predicted),
            mean,
            std,
            remark(calibration, check, display),
        ])
    });
    let grid = Grid { heads, rows: rows.collect() };
    (!calibration.summary.dynamics.is_empty()).then(|| StudyPart::Table {
        title: "Checked by the dynamics".into(),
        caption: "Dynamic run of the whole string with the fitted parameters: mean and standard \
                  deviation over time. Weights include the block."
            .into(),
        grid,
        files: "calibration_dynamic".into(),
        endings: &["csv", "parquet"],
    })
}

/// Reason why there is no dynamic value, or a note on it.
fn remark(calibration: &Calibration, check: &DynamicCheck, display: DisplayUnits<'_>) -> String {
    match (check.dynamic.and_then(|dynamic| dynamic.steady), &check.message) {
        (_, Some(message)) => calibration.text(message, display.unit_set()),
        (Some(false), _) => "not settled".to_owned(),
        _ => String::new(),
    }
}

fn correlations(calibration: &Calibration) -> StudyPart {
    let mut names = vec![("", true)];
    names.extend(
        calibration.summary.estimates.iter().map(|estimate| (estimate.words.as_str(), false)),
    );
    let summary = &calibration.summary;
    let rows = summary.estimates.iter().zip(&summary.correlation).map(|(estimate, correlation)| {
        let mut cells = vec![estimate.words.clone()];
        cells.extend(
            correlation
                .iter()
                .map(|correlation| format!("{correlation:.3}").replace('-', "\u{2212}")),
        );
        row(cells)
    });
    StudyPart::Table {
        title: "Correlations".into(),
        caption: "Near 1 or −1 the readings determine two parameters only in combination.".into(),
        grid: Grid { heads: heads(&names), rows: rows.collect() },
        files: "summary".into(),
        endings: &["json"],
    }
}

fn readings(calibration: &Calibration, display: DisplayUnits<'_>) -> StudyPart {
    // A single case is named for the whole page.
    let several = calibration.rows.readings.windows(2).any(|pair| pair[0].case != pair[1].case);
    let mut heads = vec![head("reading", true)];
    heads.extend(several.then(|| head("case", true)));
    heads.extend([
        head("place", true),
        head("bit depth", false),
        head("measured", false),
        head("predicted", false),
        head(format!("band of {:.0} %", 100.0 * calibration.summary.band_confidence), false),
        head("residual", false),
        head("in standard errors", false),
        head("in the fit", true),
        head("in its band", true),
    ]);
    let rows = calibration.rows.readings.iter().map(|point| {
        let dimension = if point.is_torque() { "torque" } else { "force" };
        let number = |si: f64| four(display.value(si, dimension));
        let load = |si: f64| format!("{} {}", number(si), display.symbol(dimension));
        let mut cells = vec![reading_words(&point.reading).to_owned()];
        cells.extend(several.then(|| point.case.clone()));
        cells.extend([
            point.place.clone(),
            display.quantity(point.bit_depth_m, "length"),
            load(point.measured),
            load(point.predicted),
            format!("{} to {}", load(point.reading_low), load(point.reading_high)),
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
        caption: "Weights include the block. Place: the reading's place in its file. Band: the \
                  band of such readings. Residual: measured less predicted, and the same over its \
                  standard error."
            .into(),
        grid: Grid { heads, rows: rows.collect() },
        files: "calibration".into(),
        endings: &["csv", "parquet"],
    }
}

/// The settings of the readings, and the fixed parameters.
fn notes(calibration: &Calibration, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let units = display.unit_set();
    let notes = calibration.summary.notes.iter().map(|text| calibration.text(text, units));
    let rows = notes.map(|text| row(vec![text.replace('`', "")]));
    let grid = Grid { heads: heads(&[("note", true)]), rows: rows.collect() };
    (!grid.rows.is_empty()).then(|| StudyPart::Table {
        title: "Notes".into(),
        caption: "Settings from the file of readings, and assumptions.".into(),
        grid,
        files: "summary".into(),
        endings: &["json"],
    })
}
