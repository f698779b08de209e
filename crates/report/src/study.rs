//! The page of a study as one file that needs nothing else.

use crate::page::{document, escaped};

/// A study as its page shows it.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyPage {
    /// Name and version of the program.
    pub program: String,
    /// Name of the study.
    pub title: String,
    /// What it asks and how; paragraphs are parted by blank lines.
    pub description: String,
    /// Figures and tables in their order.
    pub parts: Vec<StudyPart>,
}

/// A figure or a table.
#[derive(Debug, Clone, PartialEq)]
pub enum StudyPart {
    /// A picture.
    Figure {
        /// What stands over it.
        title: String,
        /// What stands under it; may be empty.
        caption: String,
        /// The picture as SVG; none where no case has answered yet.
        svg: Option<String>,
        /// Its files beside the page, without their endings.
        files: String,
    },
    /// Numbers.
    Table {
        /// What stands over it.
        title: String,
        /// What stands under it; may be empty.
        caption: String,
        /// The numbers.
        grid: Grid,
        /// Its files beside the page, without their endings.
        files: String,
    },
}

/// A table for people.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// Heads of the columns.
    pub heads: Vec<String>,
    /// Rows of cells.
    pub rows: Vec<Vec<(String, Verdict)>>,
}

/// What comes of a comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Nothing was compared.
    None,
    /// Within what is allowed.
    Agrees,
    /// Not within it.
    Differs,
}

/// What the page may do: show what is in it.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src data:";

const LOOKS: &str = "\
:root{color-scheme:light dark}
body{font:16px/1.5 system-ui,sans-serif;max-width:1000px;margin:2rem auto;padding:0 1rem;color:#1e1e1e;background:#fff}
h1{font-size:1.7rem}h2{font-size:1.15rem;margin:2.5rem 0 .5rem}
figure{margin:0}svg{max-width:100%;height:auto;background:#fff;border-radius:6px}
.note{color:#5f5f5f;font-size:.9rem}
.scroll{overflow-x:auto}
table{border-collapse:collapse;font-size:.9rem;font-variant-numeric:tabular-nums}
th,td{padding:.3rem .7rem;border-bottom:1px solid #ccc;text-align:right}
th{vertical-align:bottom}th:first-child,td:first-child,td.words{text-align:left}
td:not(.words,:first-child){white-space:nowrap}
td.agrees::after{content:' \\2713';color:#00714f}
td.differs{font-weight:600;background:#fbe3d5}
td.differs::after{content:' \\2717';color:#a63c00}
a{color:#00578a}
@media(prefers-color-scheme:dark){body{color:#e6e6e6;background:#16181b}.note{color:#a5a5a5}
th,td{border-color:#444}td.differs{background:#4d2a17}td.agrees::after{color:#4fd1a5}td.differs::after{color:#ff9f6b}a{color:#7cc4f0}}
@media print{body{margin:0;max-width:none}section{break-inside:avoid}}
";

/// The page as the text of an HTML file. No name in it can end the element that it stands in.
pub fn study_html(page: &StudyPage) -> String {
    let title = escaped(&page.title);
    let program = escaped(&page.program);
    let about = paragraphs(&page.description);
    let parts: String = page
        .parts
        .iter()
        .enumerate()
        .map(|(index, of)| part(index, of))
        .collect();
    let body = format!("<h1>{title}</h1>\n{about}{parts}<p class=\"note\">{program}</p>");
    document(&page.title, &page.program, POLICY, LOOKS, &body)
}

fn paragraphs(text: &str) -> String {
    let blocks = text.replace("\r\n", "\n");
    let blocks = blocks
        .split("\n\n")
        .map(str::trim)
        .filter(|block| !block.is_empty());
    blocks
        .map(|block| format!("<p>{}</p>\n", escaped(block)))
        .collect()
}

/// A figure or a table, `index` of the page.
fn part(index: usize, part: &StudyPart) -> String {
    let (title, caption, body, files, endings) = match part {
        StudyPart::Figure {
            title,
            caption,
            svg,
            files,
        } => {
            let body = match svg {
                // What stands before the element is of no use within a page, and each needs names of its own there.
                Some(svg) => {
                    let element = svg.find("<svg").map_or("", |at| &svg[at..]);
                    let own = |place: &str| format!("{place}figure-{index}-");
                    let element = ["id=\"", "url(#"]
                        .iter()
                        .fold(element.to_owned(), |text, place| {
                            text.replace(place, &own(place))
                        });
                    format!("<figure>{element}</figure>")
                }
                None => "<p class=\"note\">No case has answered yet.</p>".to_owned(),
            };
            (title, caption, body, files, ["svg", "csv"])
        }
        StudyPart::Table {
            title,
            caption,
            grid,
            files,
        } => (
            title,
            caption,
            format!("<div class=\"scroll\">{}</div>", table(grid)),
            files,
            ["md", "csv"],
        ),
    };
    let links = endings.map(|ending| {
        let address = address(&format!("{files}.{ending}"));
        format!("<a href=\"{address}\">{}</a>", ending.to_uppercase())
    });
    format!(
        "<section>\n<h2>{}</h2>\n{body}\n{}<p class=\"note\">{}</p>\n</section>\n",
        escaped(title),
        paragraphs(caption),
        links.join(" · ")
    )
}

fn table(grid: &Grid) -> String {
    let heads: String = grid
        .heads
        .iter()
        .map(|head| format!("<th>{}</th>", escaped(head)))
        .collect();
    let rows: String = grid
        .rows
        .iter()
        .map(|row| format!("<tr>{}</tr>\n", cells(row)))
        .collect();
    format!("<table>\n<thead><tr>{heads}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table>")
}

fn cells(row: &[(String, Verdict)]) -> String {
    let cell = |(text, verdict): &(String, Verdict)| {
        let class = match verdict {
            Verdict::None if !text.contains(|letter: char| letter.is_ascii_digit()) => {
                " class=\"words\""
            }
            Verdict::None => "",
            Verdict::Agrees => " class=\"agrees\"",
            Verdict::Differs => " class=\"differs\"",
        };
        format!("<td{class}>{}</td>", escaped(text))
    };
    row.iter().map(cell).collect()
}

/// A path as an address within a page.
fn address(path: &str) -> String {
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
                        heads: vec![nasty.clone()],
                        rows: vec![vec![(nasty.clone(), Verdict::Differs)]],
                    },
                    files: nasty.clone(),
                },
                StudyPart::Figure {
                    title: nasty.clone(),
                    caption: nasty,
                    svg: None,
                    files: "figures/a b".into(),
                },
            ],
        });
        assert!(!page.contains("<script"), "{page}");
        assert_eq!(page.matches("</title>").count(), 1);
        assert!(page.contains("href=\"figures/a%20b.svg\""));
        assert!(page.contains("class=\"differs\""));
    }
    /// Pictures are cut to their own frames: no two elements of the page have one name.
    #[test]
    fn figures_keep_their_own_names() {
        let figure = || StudyPart::Figure {
            title: String::new(),
            caption: String::new(),
            svg: Some(
                "<?xml?><svg><clipPath id=\"clip-0\"/><path clip-path=\"url(#clip-0)\"/></svg>"
                    .into(),
            ),
            files: String::new(),
        };
        let page = study_html(&StudyPage {
            program: String::new(),
            title: String::new(),
            description: String::new(),
            parts: vec![figure(), figure()],
        });
        for index in 0..2 {
            let name = format!("figure-{index}-clip-0");
            assert_eq!(page.matches(&format!("id=\"{name}\"")).count(), 1);
            assert_eq!(page.matches(&format!("url(#{name})")).count(), 1);
        }
    }
}
