//! The paper as a PDF, built by pandoc and Typst, which pip installs as binaries.

use std::{fs, process::Command};

use crate::{
    command::{Failure, run},
    finding::Finding,
    folders::{root, target},
    python::{environment, python},
    web::unable,
};

const OLDEST: &str = "3.10";
const TOOLS: [&str; 2] = ["pypandoc_binary>=1.15,<2", "typst>=0.13,<1"];

/// A citation that is missing in the bibliography is a warning of pandoc, and an error here. The
/// authors are `authors` for the journal, and `author` for pandoc.
const BUILD: &str = "\
import pathlib, pypandoc, sys, typst
made, pdf = sys.argv[1:]
named = pathlib.Path(made).with_name('authors.lua')
named.write_text('''function Meta(of)
  for _, author in ipairs(of.authors) do
    for _, place in ipairs(of.affiliations) do
      if pandoc.utils.stringify(place.index) == pandoc.utils.stringify(author.affiliation) then
        author.affiliation = place.name
      end
    end
  end
  of.author = of.authors
  return of
end''')
pypandoc.convert_file('paper/paper.md', 'typst', outputfile=made, extra_args=[
    '--standalone', '--citeproc', '--bibliography=paper/paper.bib', '--fail-if-warnings',
    f'--lua-filter={named}'])
typst.compile(made, output=pdf)";

/// Writes `target/paper/paper.pdf`.
pub(crate) fn build() -> Result<Finding, Failure> {
    let Some(python) = python(OLDEST) else {
        return unable(format!("there is no Python {OLDEST} or newer here"));
    };
    let folder = target().join("paper");
    let tools = environment(python, &folder.join("tools"), "import pypandoc, typst", &TOOLS);
    let Some(python) = tools else {
        let tools = TOOLS.join("` and `");
        return unable(format!("`{tools}` cannot be installed in a virtual environment here"));
    };
    fs::create_dir_all(&folder)
        .map_err(|error| Failure::new(format!("{}: {error}", folder.display())))?;
    let mut build = Command::new(python);
    build.current_dir(root()).args(["-c", BUILD]);
    build.arg(folder.join("paper.typ")).arg(folder.join("paper.pdf"));
    run(&mut build, "the paper must build")?;
    Ok(Finding::Done)
}
