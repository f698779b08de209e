//! The page of a study as one self-contained file.

use crate::{
    draw::palette,
    figure::Figure,
    page::{NARROW_MM, STYLES, document, escaped},
    page_head::PROGRAM,
    plots::SETS,
};
use wholestring_judge::Severity;
use wholestring_study::Study;

/// A study as its page shows it.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyPage {
    /// Name and version of the program.
    pub program: String,
    /// Name of the study.
    pub title: String,
    /// Question and method; paragraphs are separated by blank lines.
    pub description: String,
    /// Figures and tables in their order.
    pub parts: Vec<StudyPart>,
}

impl StudyPage {
    /// The page of a study with these figures and tables.
    pub fn new(study: &Study, parts: Vec<StudyPart>) -> Self {
        Self {
            program: PROGRAM.into(),
            title: study.name.clone(),
            description: study.description.clone(),
            parts,
        }
    }
}

/// A figure or a table.
#[derive(Debug, Clone, PartialEq)]
pub enum StudyPart {
    /// A picture.
    Figure {
        /// Its title.
        title: String,
        /// Its caption; may be empty.
        caption: String,
        /// The picture; `None` where no case has a result yet.
        figure: Option<Box<Figure>>,
        /// Its files next to the page, without their extensions; empty where there are none.
        files: String,
        /// Whether it was also written as PNG.
        painted: bool,
    },
    /// Numbers.
    Table {
        /// Its title.
        title: String,
        /// Its caption; may be empty.
        caption: String,
        /// The numbers.
        grid: Grid,
        /// Its files next to the page, without their extensions.
        files: String,
        /// The extensions of those files.
        endings: &'static [&'static str],
    },
    /// Words.
    Text {
        /// Its title.
        title: String,
        /// Paragraphs, separated by an empty line.
        text: String,
    },
    /// A part that the reader unfolds.
    Folded(Box<StudyPart>),
}

impl StudyPart {
    /// Its title.
    fn title(&self) -> &str {
        match self {
            Self::Figure { title, .. } | Self::Table { title, .. } | Self::Text { title, .. } => {
                title
            }
            Self::Folded(part) => part.title(),
        }
    }
}

/// A table for readers.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// Heads of the columns.
    pub heads: Vec<Head>,
    /// Rows of cells.
    pub rows: Vec<Vec<(String, Verdict)>>,
}

/// The head of a column.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Head {
    /// Its text.
    pub text: String,
    /// Whether the column holds words rather than numbers.
    pub words: bool,
}

/// Result of a comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Nothing was compared.
    None,
    /// Within the tolerance.
    Agrees,
    /// Within it, but not by much.
    Near,
    /// Not within it.
    Differs,
    /// A check with the severity that the judge gave it.
    Judged(Severity),
}

/// Permissions of the page: it shows its contents.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src data:";

/// The styles of a run's page, dark where the reader's system is, because this page has no program
/// for a switch.
fn styles() -> String {
    format!("{}{STYLES}", palette::css_by_window())
}

/// Returns the page as the text of an HTML file. No name in it can end the element that contains
/// it.
pub fn study_html(page: &StudyPage) -> String {
    whole(page, "", &paragraphs(&page.description), &contents_and_parts(page, ""))
}

/// Name of each set of units for readers.
const UNITS: [&str; 3] = ["SI", "Metric", "US field"];

/// The same page in every set of units; it opens with the set of the name `opens`, and the reader
/// can choose others. It needs no program: all are in the file, and one is visible.
pub(crate) fn study_html_in_units(opens: &str, page: impl Fn(&str) -> StudyPage) -> String {
    let opens = if SETS.contains(&opens) { opens } else { SETS[0] };
    let mut choices = String::new();
    let (mut about, mut body) = (String::new(), String::new());
    for (units, title) in SETS.into_iter().zip(UNITS) {
        let (page, is_first) = (page(units), units == opens);
        let (checked, first) = if is_first { (" checked", " opens") } else { ("", "") };
        choices += &format!(
            "<label><input type=\"radio\" name=\"units\" id=\"units-{units}\"\
             {checked}>{title}</label>\n"
        );
        let within =
            |what: &str| format!("<div class=\"in-units in-{units}{first}\">\n{what}</div>\n");
        about += &within(&paragraphs(&page.description));
        body += &within(&contents_and_parts(&page, &format!("{units}-")));
    }
    let switch = format!(
        "<fieldset class=\"choice units noprint\">\n<legend>Units</legend>\n{choices}</fieldset>\n"
    );
    whole(&page(opens), &switch, &about, &body)
}

/// A page with its head: title with `switch`, `about` below.
fn whole(page: &StudyPage, switch: &str, about: &str, body: &str) -> String {
    let (title, program) = (escaped(&page.title), escaped(&page.program));
    let body = format!(
        "<main class=\"study\">\n<header>\n<div class=\"title-line\"><h1>{title}</h1>\n{switch}</div>\n\
         {about}</header>\n{body}<footer><p>Made by {program}. The files next to this page have \
         every digit.</p></footer>\n</main>"
    );
    document(&page.title, &page.program, POLICY, &styles(), &body)
}

/// The table of contents, and all parts; names of elements begin with `prefix`.
fn contents_and_parts(page: &StudyPage, prefix: &str) -> String {
    let parts: String = page
        .parts
        .iter()
        .enumerate()
        .map(|(index, content)| part(index, prefix, content))
        .collect();
    let links: String = page
        .parts
        .iter()
        .enumerate()
        .map(|(index, content)| {
            format!("<a href=\"#{prefix}part-{index}\">{}</a>\n", escaped(content.title()))
        })
        .collect();
    format!("<nav class=\"contents noprint\" aria-label=\"Contents\">\n{links}</nav>\n{parts}")
}

fn paragraphs(text: &str) -> String {
    let blocks = text.replace("\r\n", "\n");
    let blocks = blocks.split("\n\n").map(str::trim).filter(|block| !block.is_empty());
    blocks.map(|block| format!("<p>{}</p>\n", escaped(block))).collect()
}

/// A section of the page, the `index`th; its name begins with `prefix`.
fn part(index: usize, prefix: &str, part: &StudyPart) -> String {
    let heading = format!("<h2>{}</h2>", escaped(part.title()));
    let within = match part {
        StudyPart::Folded(content) => {
            let within = contents(index, prefix, content);
            format!("<details>\n<summary>{heading}</summary>\n{within}</details>\n")
        }
        content => format!("{heading}\n{}", contents(index, prefix, content)),
    };
    format!("<section id=\"{prefix}part-{index}\">\n{within}</section>\n")
}

/// A figure, a table or words, without its heading.
fn contents(index: usize, prefix: &str, part: &StudyPart) -> String {
    let (caption, body, files, endings) = match part {
        StudyPart::Figure { title: _, caption, figure, files, painted } => {
            let body = match figure {
                // The title is on the page already.
                Some(figure) => {
                    let mut figure = figure.clone();
                    figure.title.clear();
                    figures(&mut figure, &format!("{prefix}figure-{index}"))
                }
                None => "<p class=\"note\">No case has answered yet.</p>".to_owned(),
            };
            let endings = ["svg", "png", "csv"];
            let endings = endings
                .into_iter()
                .filter(|ending| !files.is_empty() && (*ending != "png" || *painted));
            (caption, body, files, endings.collect::<Vec<_>>())
        }
        StudyPart::Table { title: _, caption, grid, files, endings } => (
            caption,
            format!("<div class=\"scrolls\">{}</div>", table(grid)),
            files,
            endings.to_vec(),
        ),
        StudyPart::Text { title: _, text } => return paragraphs(text),
        StudyPart::Folded(content) => return contents(index, prefix, content),
    };
    let links: Vec<String> = endings
        .into_iter()
        .map(|ending| {
            let address = address(&format!("{files}.{ending}"));
            format!("<a href=\"{address}\">{}</a>", ending.to_uppercase())
        })
        .collect();
    format!("{body}\n{}<p class=\"note noprint\">{}</p>\n", paragraphs(caption), links.join(" · "))
}

/// A figure for a wide page and for a narrow one, there with its panels one below the other.
fn figures(figure: &mut Figure, name: &str) -> String {
    let wide = figure.drawing().element(name);
    if figure.layout.width_mm <= NARROW_MM {
        return format!("<figure>{wide}</figure>");
    }
    figure.layout.columns = 1;
    figure.layout.width_mm = NARROW_MM;
    let narrow = figure.drawing().element(&format!("{name}-narrow"));
    format!("<figure class=\"wide\">{wide}</figure>\n<figure class=\"narrow\">{narrow}</figure>")
}

fn table(grid: &Grid) -> String {
    let class = |head: &Head| if head.words { " class=\"words\"" } else { "" };
    let heads: String = grid
        .heads
        .iter()
        .map(|head| format!("<th{}>{}</th>", class(head), escaped(&head.text)))
        .collect();
    let rows: String =
        grid.rows.iter().map(|row| format!("<tr>{}</tr>\n", cells(&grid.heads, row))).collect();
    format!("<table>\n<thead><tr>{heads}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table>")
}

/// Number of letters beyond which words are a sentence, which is broken into lines.
const SENTENCE: usize = 40;

fn cells(heads: &[Head], row: &[(String, Verdict)]) -> String {
    let is_sentence = |text: &str| text.chars().count() > SENTENCE;
    let has_sentence = row.iter().any(|(text, _)| is_sentence(text));
    let cell = |(head, (text, verdict)): (&Head, &(String, Verdict))| {
        let mut classes = Vec::new();
        classes.extend(head.words.then_some("words"));
        classes.extend(is_sentence(text).then_some("sentence"));
        let of_severity;
        classes.extend(match verdict {
            Verdict::None => None,
            Verdict::Agrees => Some("agrees"),
            Verdict::Near => Some("near"),
            Verdict::Differs => Some("differs"),
            Verdict::Judged(severity) => {
                of_severity = format!("level-{}", severity.name());
                Some(of_severity.as_str())
            }
        });
        let class = match classes.is_empty() {
            true => String::new(),
            false => format!(" class=\"{}\"", classes.join(" ")),
        };
        // Where a sentence takes the whole width of a narrow page, the heads are in the cells.
        let name = match has_sentence && !text.is_empty() {
            true => format!(" data-head=\"{}\"", escaped(&head.text)),
            false => String::new(),
        };
        format!("<td{class}{name}>{}</td>", escaped(&kept_together(text)))
    };
    heads.iter().zip(row).map(cell).collect()
}

/// Keeps a number and its unit in one line.
fn kept_together(text: &str) -> String {
    let mut text_with_unit = String::with_capacity(text.len());
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        let follows_digit = text_with_unit.ends_with(|last: char| last.is_ascii_digit());
        let before_unit = letters.peek().is_some_and(|next| next.is_alphabetic() || *next == '°');
        text_with_unit.push(if letter == ' ' && follows_digit && before_unit {
            '\u{a0}'
        } else {
            letter
        });
    }
    text_with_unit
}

/// A path as an address within a page.
pub fn address(path: &str) -> String {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-_./".contains(&byte);
    let bytes = path.bytes();
    bytes
        .map(|byte| match plain(byte) {
            true => char::from(byte).to_string(),
            false => format!("%{byte:02X}"),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{Axis, Ink, Layout, Mark, Panel, Range, Stroke};

    #[test]
    fn no_text_becomes_markup() {
        let nasty = "</title><script>\"&".to_owned();
        let page = study_html(&StudyPage {
            program: nasty.clone(),
            title: nasty.clone(),
            description: nasty.clone(),
            parts: vec![
                StudyPart::Table {
                    title: nasty.clone(),
                    caption: nasty.clone(),
                    grid: Grid {
                        heads: vec![Head { text: nasty.clone(), words: true }],
                        rows: vec![vec![(nasty.clone(), Verdict::Differs)]],
                    },
                    files: nasty.clone(),
                    endings: &["md", "csv"],
                },
                StudyPart::Figure {
                    title: nasty.clone(),
                    caption: nasty,
                    figure: None,
                    files: "figures/a b".into(),
                    painted: true,
                },
            ],
        });
        assert!(!page.contains("<script"), "{page}");
        assert_eq!(page.matches("</title>").count(), 1);
        for ending in ["svg", "png", "csv"] {
            assert!(page.contains(&format!("href=\"figures/a%20b.{ending}\"")));
        }
        assert!(page.contains("class=\"words differs\""));
    }
    /// Pictures are cut to their own frames: no two elements of the page have one name. They use
    /// the page's colours, which are dark where the reader requests it.
    #[test]
    fn figures_keep_their_own_names_and_follow_the_page() {
        let part = || StudyPart::Figure {
            title: String::new(),
            caption: String::new(),
            figure: Some(Box::new(figure())),
            files: String::new(),
            painted: false,
        };
        let page = study_html(&StudyPage {
            program: String::new(),
            title: String::new(),
            description: String::new(),
            parts: vec![part(), part()],
        });
        for index in 0..2 {
            let name = format!("figure-{index}-0");
            assert_eq!(page.matches(&format!("id=\"{name}\"")).count(), 1);
            assert!(page.contains(&format!("url(#{name})")));
        }
        assert!(!page.contains("Said by the page"));
        let dark =
            page.split("@media screen and (prefers-color-scheme:dark){:root{").nth(1).unwrap();
        assert!(dark.starts_with("--paper:"), "{}", &dark[..40]);
    }

    /// One file contains the page in every set of units: each name once, and it opens with the
    /// requested set.
    #[test]
    fn the_reader_chooses_the_units() {
        let made = |units: &str| StudyPage {
            program: String::new(),
            title: "A well".into(),
            description: format!("in {units}"),
            parts: vec![StudyPart::Table {
                title: format!("A table in {units}"),
                caption: String::new(),
                grid: Grid {
                    heads: vec![Head { text: "load".into(), words: false }],
                    rows: vec![vec![("12 kN".into(), Verdict::None)]],
                },
                files: "table".into(),
                endings: &["csv"],
            }],
        };
        let page = study_html_in_units("field", made);
        assert_eq!(page.matches("<h1>").count(), 1);
        for units in SETS {
            assert_eq!(page.matches(&format!("in {units}</p>")).count(), 1, "{units}");
            assert_eq!(page.matches(&format!("id=\"{units}-part-0\"")).count(), 1, "{units}");
            assert_eq!(page.matches(&format!("href=\"#{units}-part-0\"")).count(), 1, "{units}");
        }
        assert_eq!(page.matches(" opens\"").count(), 2, "what it is about, and its parts");
        assert!(page.contains("id=\"units-field\" checked"));
        assert_eq!(page.matches(" checked").count(), 1);
        assert!(page.contains("12\u{a0}kN"));
    }

    fn figure() -> Figure {
        Figure {
            title: "Said by the page".into(),
            subtitle: String::new(),
            keys: Vec::new(),
            layout: Layout::across(1, 85.0, 50.0),
            shared: Axis::new("x", Range::Tight),
            panels: vec![Panel::new(
                Axis::new("y", Range::Zero),
                vec![Mark::Curve {
                    ink: Ink::Line(0),
                    stroke: Stroke::Solid,
                    points: vec![(0.0, 0.0), (1.0, 1.0)],
                }],
            )],
            hole: Vec::new(),
        }
    }
}
