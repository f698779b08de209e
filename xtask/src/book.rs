//! The book: the text that commands write into its pages, and its site, built by mdBook.

use std::{
    collections::{BTreeMap, BTreeSet},
    env, fs,
    path::{Path, PathBuf},
    process::Command,
};

use crate::{
    command::{cargo, copy, files, read, relative, root, run, succeeds, target, with},
    outcome::{Failure, Finding},
};

/// The release that builds the book. Serving and watching are left out because they take long to
/// compile.
const MDBOOK: &str = "mdbook@0.5.4";

/// Ends of the text that commands write, and of the place of the app.
const END: &str = "<!-- end -->\n";
const APP: [&str; 2] = ["<!-- playground: begin -->", "<!-- playground: end -->"];

/// The app, from the root of the book's site.
const FOLDER: &str = "playground";

/// Replaces the text that describes how to build the app, which is fetched when it becomes visible.
const SHOWN: &str = "\
<iframe class=\"app-alone\" src=\"playground/index.html\" loading=\"lazy\" title=\"The app of \
wholestring, in this browser alone\"></iframe>
<p><a href=\"playground/index.html\">Open it in a window of its own</a>. It needs a server of files: \
where the book is opened from a folder, the frame stays empty.</p>
";

/// Pages without their own addresses: mdBook makes them from the others, or by itself.
const MADE: [&str; 3] = ["print.html", "toc.html", "404.html"];

fn begin(command: &str) -> String {
    format!("<!-- written by `cargo xtask {command}`: begin -->\n")
}

/// Splits a page into the text before a command's text, that text, and the text after it.
pub(crate) fn parts<'a>(page: &'a str, command: &str) -> Result<[&'a str; 3], Failure> {
    let begin = begin(command);
    let missing = || Failure::new(format!("the page lacks {}", begin.trim_end()));
    let (before, rest) = page.split_once(&begin).ok_or_else(missing)?;
    let (written, after) = rest.split_once(END).ok_or_else(missing)?;
    Ok([before, written, after])
}

/// A page has the text that a command would write.
pub(crate) fn check(page: &Path, command: &str, text: &str) -> Result<Finding, Failure> {
    let old = read(page)?;
    let written = parts(&old, command)?[1].trim();
    if written == text.trim() {
        return Ok(Finding::Done);
    }
    let [there, expected] = [written, text].map(|text| text.lines().collect::<BTreeSet<_>>());
    let line = expected.difference(&there).next().or(there.difference(&expected).next());
    let (page, line) = (page.display(), line.unwrap_or(&"the order of lines"));
    Err(Failure::new(format!("{page} is out of date: {line}; run `cargo xtask {command}`")))
}

/// Replaces a command's earlier text in a page.
pub(crate) fn write(page: &Path, command: &str, text: &str) -> Result<Finding, Failure> {
    let text = replaced(&read(page)?, command, text)?;
    fs::write(page, text).map_err(Failure::at(page)).map(Finding::from)
}

fn replaced(page: &str, command: &str, text: &str) -> Result<String, Failure> {
    let [before, _, after] = parts(page, command)?;
    Ok(format!("{before}{}\n{text}\n{END}{after}", begin(command)))
}

/// The book builds: each page in its summary exists, each equation can be converted, and each link
/// has a target. It includes the app that runs in a browser alone, if that has been built.
pub(crate) fn build() -> Result<Finding, Failure> {
    with(mdbook(), |mdbook| {
        let mut build = Command::new(mdbook);
        run(build.current_dir(root()).args(["build", "docs"]), "the book must build")?;
        let site = target().join("book");
        add_app(&site)?;
        let broken = broken_links(&site)?.into_iter().collect::<Vec<_>>().join("\n");
        if broken.is_empty() {
            return Ok(());
        }
        Err(Failure::new(format!("the targets of these pages do not exist:\n{broken}")))
    })
}

/// Adds the app to the pages, if it has been built.
fn add_app(site: &Path) -> Result<(), Failure> {
    let app = target().join(FOLDER);
    if app.join("index.html").is_file() {
        copy(&app, &site.join(FOLDER)).map_err(Failure::at(&app))?;
        for name in ["alone.html", "print.html"].map(|name| site.join(name)) {
            fs::write(&name, with_app(&read(&name)?)?).map_err(Failure::at(&name))?;
        }
        println!("{}, with the app that runs in a browser alone", site.display());
    }
    Ok(())
}

/// mdBook of this version or of the system, otherwise installed once in the folder of builds.
fn mdbook() -> Result<PathBuf, String> {
    let folder = target().join("tools");
    let own = folder.join("bin").join(format!("mdbook{}", env::consts::EXE_SUFFIX));
    let starts = |program: &PathBuf| succeeds(Command::new(program).arg("--version"));
    if let Some(found) = [own.clone(), "mdbook".into()].into_iter().find(starts) {
        return Ok(found);
    }
    let mut install = cargo();
    install.args(["install", "--quiet", "--locked", MDBOOK, "--debug"]);
    install.args(["--no-default-features", "--features", "search", "--root"]);
    // Its dependencies are not ours: they would be compiled repeatedly in the same folder.
    install.arg(&folder).arg("--target-dir").arg(folder.join("build"));
    install.env("CARGO_PROFILE_DEV_DEBUG", "0");
    let reason = format!("there is no mdbook, and `cargo install {MDBOOK}` fails here");
    if succeeds(&mut install) { Ok(own) } else { Err(reason) }
}

/// The page of the site with the app in its place.
fn with_app(page: &str) -> Result<String, Failure> {
    let missing = || Failure::new(format!("the book has no place of the app: {}", APP.join(", ")));
    let (before, rest) = page.split_once(APP[0]).ok_or_else(missing)?;
    let (_, after) = rest.split_once(APP[1]).ok_or_else(missing)?;
    Ok(format!("{before}{SHOWN}{after}"))
}

/// Links of a site to pages, pictures and headings that do not exist.
fn broken_links(site: &Path) -> Result<BTreeSet<String>, Failure> {
    let mut pages: BTreeMap<PathBuf, String> = files(site, "html")?.into_iter().collect();
    // The app is not one of the book's pages.
    pages.retain(|path, _| !path.starts_with(site.join(FOLDER)));
    let mut broken = BTreeSet::new();
    for (path, text) in &pages {
        let links = attributes(text, " href=\"").chain(attributes(text, " src=\""));
        let made = MADE.iter().any(|name| path.ends_with(name));
        for link in links.filter(|_| !made).filter(|link| !leads_elsewhere(link)) {
            let (file, heading) = link.split_once('#').unwrap_or((link, ""));
            let target = if file.is_empty() { path.clone() } else { relative(path, file) };
            let exists = match pages.get(&target) {
                Some(page) => {
                    heading.is_empty() || attributes(page, " id=\"").any(|id| id == heading)
                }
                // Targets outside are next to the sources, not next to the site.
                None => target.starts_with(site) && target.is_file(),
            };
            if !exists {
                broken.insert(format!(
                    "{}: {link}",
                    path.strip_prefix(site).unwrap_or(path).display()
                ));
            }
        }
    }
    Ok(broken)
}

fn leads_elsewhere(link: &str) -> bool {
    link.contains("://") || link.starts_with("mailto:") || link.starts_with("data:")
}

/// Values of an attribute, whose name ends with its quote. Text in code is excluded.
fn attributes<'a>(text: &'a str, name: &'static str) -> impl Iterator<Item = &'a str> {
    text.split(name).skip(1).filter_map(|rest| rest.split_once('"')).map(|(value, _)| value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_between_the_markers_is_replaced() {
        let begin = begin("a-table");
        let page = format!("before\n{begin}old\n{END}after\n");
        let new = replaced(&page, "a-table", "new\n").unwrap();
        assert_eq!(new, format!("before\n{begin}\nnew\n\n{END}after\n"));
        assert_eq!(replaced(&new, "a-table", "new\n").unwrap(), new);
        assert!(replaced(&page, "another", "new").is_err());
    }

    #[test]
    fn a_page_that_differs_is_out_of_date() {
        let page = env::temp_dir().join(format!("book-{}.md", std::process::id()));
        fs::write(&page, format!("{}\na\nb\n\n{END}", begin("a-table"))).unwrap();
        let outcome = |text| check(&page, "a-table", text).err().map(|failure| failure.reason);
        assert_eq!(outcome("a\nb\n"), None);
        assert!(outcome("a\nc\n").unwrap().contains("out of date: c; run `cargo xtask a-table`"));
        assert!(outcome("a\n").unwrap().contains("out of date: b;"));
        assert!(outcome("b\na\n").unwrap().contains("the order of lines"));
        fs::remove_file(&page).unwrap();
    }

    #[test]
    fn the_app_replaces_how_to_build_it() {
        let page = format!("a\n{}\n<p>Make it.\n{}\nb\n", APP[0], APP[1]);
        let page = with_app(&page).unwrap();
        assert!(page.starts_with("a\n<iframe") && page.ends_with("\n\nb\n"), "{page}");
        assert!(!page.contains("Make it."), "{page}");
        assert!(with_app(APP[0]).is_err());
    }

    #[test]
    fn links_without_targets_are_found() {
        let site = env::temp_dir().join(format!("site-{}", std::process::id()));
        fs::create_dir_all(site.join("a")).unwrap();
        let page = "<a class=\"x\" href=\"../b.html#there\"><a href=\"../b.html#gone\">\
            <a href=\"#own\"><p id=\"own\"><img src=\"../c.svg\"><a href=\"../d.html\">\
            <a href=\"https://example.org/#b\">";
        fs::write(site.join("a/page.html"), page).unwrap();
        fs::write(site.join("b.html"), "<h2 id=\"there\">").unwrap();
        fs::write(site.join("c.svg"), "").unwrap();
        let broken = broken_links(&site).unwrap().into_iter().collect::<Vec<_>>();
        fs::remove_dir_all(&site).unwrap();
        assert_eq!(broken, ["a/page.html: ../b.html#gone", "a/page.html: ../d.html"]);
    }
}
