//! The pages of a run, of a sweep and of a bit test, each one self-contained file.

use serde::Serialize;
use wholestring::outcome::Method;

use crate::{
    Bha, BitTest, BottomPicture, CheckRow, PageHead, PageTable, Plot, Report, Sweep, bha_plots,
    bit_test_plots,
    draw::palette,
    plots::{
        SETS,
        catalogue::{
            ContactPlot, DrillOffPlot, NodeChannel, RULES, Rules, StringColour, TimePlot, Track,
            bit_plots, contact_plots, drill_off_plots, node_channels, string_colours, time_plots,
            tracks,
        },
        models,
    },
    sweep::SweepVerdict,
    sweep_plots,
};

/// The programs of the pages and their styles, bundled from `web/` by `npm run bundle`.
const PROGRAM: &str = include_str!("../assets/report.js");
const SWEEP_PROGRAM: &str = include_str!("../assets/sweep.js");
pub(crate) const STYLES: &str = include_str!("../assets/report.css");
/// Licences of the bundled code.
const LICENCES: &str = include_str!("../assets/licences.txt");

/// Permissions of the page: it runs its own scripts and nothing else, and never accesses the
/// network.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; \
                      img-src data: blob:";

/// Data of a run's page: the report, and the plots made of it.
#[derive(Serialize)]
struct Data<'a> {
    #[serde(flatten)]
    report: &'a Report,
    models: Vec<Model>,
    tracks: Vec<Track>,
    rules: Rules,
    time_plots: Vec<TimePlot>,
    bit_plots: Vec<TimePlot>,
    drill_off_plots: [DrillOffPlot; 3],
    contact_plots: [ContactPlot; 2],
    node_channels: Vec<NodeChannel>,
    string_colours: Vec<StringColour>,
}

/// Data of a method on a run's page; the most detailed comes first.
#[derive(Serialize)]
struct Model {
    name: &'static str,
    long_name: &'static str,
    in_time: bool,
}

impl Model {
    fn of(method: &Method) -> Self {
        Self { name: method.name, long_name: method.long_name, in_time: method.in_time }
    }
}

/// The report of a run as the text of an HTML file.
///
/// No name in it can end the element that contains it, whatever its text.
pub fn report_html(report: &Report) -> String {
    let data = Data {
        report,
        models: models(|name| report.solved.iter().any(|solved| solved.model == name))
            .into_iter()
            .map(Model::of)
            .collect(),
        tracks: tracks(),
        rules: RULES,
        time_plots: time_plots(),
        bit_plots: bit_plots(),
        drill_off_plots: drill_off_plots(),
        contact_plots: contact_plots(),
        node_channels: node_channels(),
        string_colours: string_colours(),
    };
    page(&report.head.title, &report.head.program, &data, &licences(), PROGRAM)
}

/// The licences for the page's own reader.
fn licences() -> String {
    format!("<template id=\"licences\">{}</template>", escaped(LICENCES))
}

/// Data of a sweep's page.
#[derive(Serialize)]
struct SweepData<'a> {
    #[serde(flatten)]
    head: &'a PageHead,
    verdict: Option<SweepVerdict>,
    page_table: PageTable,
    rows: Vec<Spot<'a>>,
}

/// Text of a point of a sweep's figure: a row of its table.
#[derive(Serialize)]
struct Spot<'a> {
    checks: [usize; 2],
    check: &'a [String; 3],
    page: Option<&'a str>,
}

/// The report of a sweep as the text of an HTML file: its figure in every set of units, and the
/// table.
///
/// No name in it can end the element that contains it, whatever its text.
pub fn sweep_html(sweep: &Sweep) -> String {
    let data = SweepData {
        head: &sweep.head,
        verdict: sweep.verdict(),
        page_table: sweep.page_table(),
        rows: sweep
            .rows
            .iter()
            .map(|row| Spot {
                checks: [row.errors, row.warnings],
                check: &row.check,
                page: row.page.as_deref(),
            })
            .collect(),
    };
    let figures =
        SETS.map(|units| templates("figure", units, sweep_plots(sweep, units).into_iter().next()));
    let rest = figures.join("\n");
    page(&sweep.head.title, &sweep.head.program, &data, &rest, SWEEP_PROGRAM)
}

/// Width of a figure with one column of panels, mm.
pub(crate) const NARROW_MM: f64 = 85.0;

/// A picture in a set of units for a wide screen, and for a narrow one, there with all panels one
/// below the other.
fn templates(name: &str, units: &str, plot: Option<Plot>) -> String {
    let narrow = plot.clone().map(|mut plot| {
        plot.figure.layout.columns = 1;
        plot.figure.layout.width_mm = NARROW_MM;
        plot
    });
    template(name, units, plot) + &template(&format!("{name}-narrow"), units, narrow)
}

/// A picture in a set of units, ready to be shown under a name.
fn template(name: &str, units: &str, plot: Option<Plot>) -> String {
    let figure = plot.map_or(String::new(), |mut plot| {
        // The page has these itself.
        plot.figure.title.clear();
        plot.figure.subtitle.clear();
        let drawing = plot.figure.drawing();
        drawing.element(&format!("{name}-clip-{units}"))
    });
    format!("<template id=\"{name}-{units}\">{figure}</template>")
}

/// Data of a bit test's page.
#[derive(Serialize)]
struct BitTestData<'a> {
    #[serde(flatten)]
    head: &'a PageHead,
    message: Option<String>,
    page_tables: Vec<PageTable>,
    bottoms: Vec<TestedBottom<'a>>,
}

/// The bottom at a weight and a speed.
#[derive(Serialize)]
struct TestedBottom<'a> {
    weight_N: f64,
    rotary_rad_per_s: f64,
    bottom: &'a BottomPicture,
}

/// The page of a bit test as the text of an HTML file: its figures in every set of units, the
/// bottoms in space, and the table.
///
/// No name in it can end the element that contains it, whatever its text.
pub fn bit_test_html(test: &BitTest) -> String {
    let bottoms = test.sorted().into_iter().filter_map(|test| {
        Some(TestedBottom {
            weight_N: test.outcome.weight_borne_N,
            rotary_rad_per_s: test.outcome.rotary_speed_rad_per_s,
            bottom: test.bottom?,
        })
    });
    let data = BitTestData {
        head: &test.head,
        message: test.message(),
        page_tables: test.page_tables(),
        bottoms: bottoms.collect(),
    };
    let mut rest = licences();
    for units in SETS {
        for plot in bit_test_plots(test, units) {
            // The page draws the bottoms itself.
            if plot.name != "bottom-hole" {
                rest += "\n";
                rest += &templates(&plot.name.clone(), units, Some(plot));
            }
        }
    }
    page(&test.head.title, &test.head.program, &data, &rest, PROGRAM)
}

/// Data of an assembly's page.
#[derive(Serialize)]
struct BhaData<'a> {
    #[serde(flatten)]
    head: &'a PageHead,
    tendency: [Vec<String>; 3],
    checks: Vec<CheckRow>,
    message: Option<String>,
    page_tables: Vec<PageTable>,
    /// Name and title of each picture of a varied quantity.
    sweeps: Vec<[&'static str; 2]>,
}

/// The page of a static BHA analysis as the text of an HTML file: its figures in every set of
/// units, and the tables.
///
/// No name in it can end the element that contains it, whatever its text.
pub fn bha_html(bha: &Bha) -> String {
    let data = BhaData {
        head: &bha.head,
        tendency: bha.tendency(),
        checks: bha.summary.open_checks().map(CheckRow::new).collect(),
        message: bha.message(),
        page_tables: bha.page_tables(),
        sweeps: bha.varied().map(|varied| [varied.name, varied.title]).collect(),
    };
    let mut rest = licences();
    for units in SETS {
        for plot in bha_plots(bha, units) {
            rest += "\n";
            rest += &templates(&plot.name.clone(), units, Some(plot));
        }
    }
    page(&bha.head.title, &bha.head.program, &data, &rest, PROGRAM)
}

/// Text of the page where JavaScript does not run.
const NEEDS: &str = "this page draws its plots itself and needs JavaScript, though no network";

/// A page of data and the program that shows them, with the other parts that the program needs.
fn page(title: &str, made_by: &str, data: &impl Serialize, rest: &str, program: &str) -> String {
    let data = json(data);
    let body = format!(
        r#"<noscript><p>{0}: {NEEDS}.</p></noscript>
<main id="page"></main>
{rest}
<script type="application/json" id="report">{data}</script>
<script>
{program}</script>"#,
        escaped(title)
    );
    let styles = format!("{}{STYLES}", palette::css());
    document(title, made_by, POLICY, &styles, &body)
}

/// A whole file of one page, which opens offline: `policy` gives its permissions, `styles` its
/// appearance.
pub(crate) fn document(
    title: &str,
    made_by: &str,
    policy: &str,
    styles: &str,
    body: &str,
) -> String {
    let title = escaped(title);
    let made_by = escaped(made_by);
    format!(
        r#"<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="generator" content="{made_by}">
<link rel="icon" href="data:,">
<title>{title}</title>
<style>
{styles}</style>
</head>
<body>
{body}
</body>
</html>
"#
    )
}

/// JSON without characters that HTML interprets.
fn json(data: &impl Serialize) -> String {
    let json = serde_json::to_string(data).expect("numbers and words");
    // These occur in JSON only within strings, where an escape has the same meaning.
    json.replace('<', "\\u003c").replace('>', "\\u003e").replace('&', "\\u0026")
}

pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
pub(crate) mod tests {
    use std::collections::BTreeMap;

    use wholestring::{operation::OperationKind, outcome::ModelKind};

    use super::*;
    use crate::{
        BottomPicture, Cell, CheckRow, DisplayUnit, Fact, KeyResult, Packed, PageTable, Part,
        Place, Section, Severity, Solved, TimeRun, Well,
    };

    const NASTY: &str = "</script><script>alert(1)</script> <!-- & \" ' \u{2028} </title>";

    /// A report with content in every part of it.
    pub(crate) fn report() -> Report {
        let column = || Packed::single([0.0, 1.0, f64::NAN]);
        let unit = |symbol: &str| DisplayUnit { symbol: symbol.into(), factor: 0.1 };
        let fact = |value| Fact { label: NASTY.into(), value };
        Report {
            head: PageHead {
                program: "wholestring".into(),
                title: NASTY.into(),
                units: "si".into(),
                dimensions: BTreeMap::from([("force".into(), ["kN", "t", "klbf"].map(unit))]),
                facts: vec![
                    fact(Cell::Text(NASTY.into())),
                    fact(Cell::Nothing),
                    fact(Cell::number(0.1 + 0.2)),
                    fact(Cell::number(f64::NAN)),
                    fact(Cell::quantity(1e300, "force")),
                ],
            },
            solved: vec![Solved {
                model: ModelKind::Soft,
                operation: OperationKind::Drill,
                message: Some([NASTY; 3].map(Into::into)),
                checks: vec![CheckRow {
                    kind: NASTY.into(),
                    label: NASTY.into(),
                    severity: Severity::Error,
                    verdict: NASTY.into(),
                    component: NASTY.into(),
                    factor: Some(1.0),
                    required: None,
                    md_m: Some(1.0),
                    to_md_m: None,
                    value: Cell::quantity(1.0, "force"),
                    limit: Cell::Nothing,
                    sentences: [NASTY; 3].map(Into::into),
                }],
                unchecked: vec![NASTY.into()],
                key_results: vec![KeyResult {
                    label: "Hook load".into(),
                    value: Cell::quantity(1.0, "force"),
                    largest: None,
                    compared: None,
                    limit: Some(2.0),
                    limit_label: NASTY.into(),
                    more: vec![fact(Cell::quantity(2.0, "force"))],
                    check_kinds: vec!["hook_load".into()],
                }],
                cutoff_depth_m: Some(500.0),
                profile: BTreeMap::from([("md_m".into(), column())]),
                wear: BTreeMap::new(),
            }],
            well: Well {
                columns: BTreeMap::from([("md_m".into(), column())]),
                high: [column(), column(), column()],
            },
            hole: vec![Section {
                kind: "open".into(),
                from_m: 0.0,
                to_m: 1.0,
                diameter_m: 0.2,
                friction: 0.3,
            }],
            string: vec![Part {
                name: NASTY.into(),
                from_m: 0.0,
                to_m: 1.0,
                od_m: 0.1,
                id_m: 0.05,
                contact_od_m: 0.1,
            }],
            runs: vec![TimeRun {
                operation: OperationKind::Drill,
                window_s: 1.0,
                samples: 3,
                history: BTreeMap::from([("time_s".into(), column())]),
                notes: vec![(0.5, NASTY.into())],
                contact: None,
                frames: None,
                drill_off: Some(BTreeMap::from([("weight_on_bit_N".into(), column())])),
                bottom: BottomPicture::new(&[0.1], &[1.0, 3.0], &[0.0, 0.01]),
                spectra: Vec::new(),
            }],
            page_tables: vec![PageTable {
                place: Place::Inputs,
                title: "Mud".into(),
                heads: Vec::new(),
                rows: vec![vec![Cell::Text(NASTY.into()), Cell::number(1.0)]],
            }],
        }
    }

    #[test]
    fn no_name_ends_its_element() {
        let nasty = report_html(&report());
        let mut tame = report();
        tame.head.title = "tame".into();
        let count = |text: &str, what: &str| text.matches(what).count();
        let page = report_html(&tame);
        for what in ["</script", "<script", "<!--", "</title", "</style", "</template"] {
            assert_eq!(count(&nasty, what), count(&page, what), "{what}");
        }
        // One element of data and one of program, each ended once.
        assert_eq!(count(&page, "</script"), 2);
        assert_eq!(count(&page, "<!--"), 0);
    }

    #[test]
    fn the_page_holds_the_report() {
        let report = report();
        let page = report_html(&report);
        let (_, rest) = page.split_once(r#"id="report">"#).unwrap();
        let (json, _) = rest.split_once("</script>").unwrap();
        assert_eq!(serde_json::from_str::<Report>(json).unwrap(), report);
    }

    #[test]
    fn the_page_names_no_other_place() {
        for scheme in ["src=\"", "href=\"h", "@import", "url(h"] {
            assert!(!STYLES.contains(scheme), "{scheme}");
        }
        assert!(LICENCES.contains("MIT"));
    }
}
