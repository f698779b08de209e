//! The app that runs in a browser alone, on its page of the book.

use std::{env, fs, path::PathBuf, process::Command};

use crate::{
    command::Failure,
    folders::{copy, target},
};

/// Place of the app on the page; the text up to the end describes how to build it.
const BEGIN: &str = "<!-- playground: begin -->\n";
const END: &str = "<!-- playground: end -->\n";

/// The app, from the root of the book's site.
const FOLDER: &str = "playground";

/// Replaces the text that describes how to build it. The app is fetched when it becomes visible.
const SHOWN: &str = "\
<iframe class=\"app-alone\" src=\"playground/index.html\" loading=\"lazy\" title=\"The app of wholestring, \
in this browser alone\"></iframe>

[Open it in a window of its own](playground/index.html). It needs a server of files: where the book is opened from a folder, the frame stays empty.
";

/// Informs the preprocessor that the app will be added to the pages: mdBook alone does not add it.
const PUT_IN: &str = "WHOLESTRING_BOOK_HAS_APP";

/// The folder that `cargo xtask playground` creates, if it exists.
fn made() -> Option<PathBuf> {
    let folder = target().join(FOLDER);
    folder.join("index.html").is_file().then_some(folder)
}

/// Makes the pages show the app, which is added later.
pub(super) fn announce(mdbook: &mut Command) {
    match made() {
        Some(_) => mdbook.env(PUT_IN, "1"),
        None => mdbook.env_remove(PUT_IN),
    };
}

/// The page with the app, if it will be added, otherwise with the text that describes how to build
/// it.
pub(super) fn shown(page: &str) -> Result<String, String> {
    shown_if(page, env::var_os(PUT_IN).is_some())
}

fn shown_if(page: &str, put_in: bool) -> Result<String, String> {
    let Some((before, rest)) = page.split_once(BEGIN) else { return Ok(page.into()) };
    let Some((how, after)) = rest.split_once(END) else {
        return Err(format!("there is no {} after {}", END.trim_end(), BEGIN.trim_end()));
    };
    Ok(format!("{before}{}{after}", if put_in { SHOWN } else { how }))
}

/// Adds the app to the pages if it has been built; returns whether it has.
pub(super) fn put_in(site: PathBuf) -> Result<bool, Failure> {
    let Some(folder) = made() else { return Ok(false) };
    let site = site.join(FOLDER);
    let cannot = |error| Failure::new(format!("{}: {error}", site.display()));
    if site.exists() {
        fs::remove_dir_all(&site).map_err(cannot)?;
    }
    copy(&folder, &site).map_err(cannot)?;
    Ok(true)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_has_the_app_or_how_to_make_it() {
        let page = format!("a\n\n{BEGIN}Make it.\n{END}\nb\n");
        assert_eq!(shown_if(&page, false).as_deref(), Ok("a\n\nMake it.\n\nb\n"));
        let page_with_app = shown_if(&page, true).unwrap_or_else(|error| panic!("{error}"));
        assert!(
            page_with_app.contains("<iframe") && !page_with_app.contains("Make it."),
            "{page_with_app}"
        );
        // An empty line ends an element, and also the text with a link.
        assert!(page_with_app.contains("</iframe>\n\n["), "{page_with_app}");
        assert!(shown_if(BEGIN, true).is_err());
        assert_eq!(shown_if("a\n", true).as_deref(), Ok("a\n"));
    }
}
