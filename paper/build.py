"""Writes the paper as a PDF: python paper/build.py TYPST PDF, from the root of the repository.

A citation that is missing in the bibliography is a warning of pandoc, and an error here. The authors
are `authors` for the journal, and `author` for pandoc.
"""

import pathlib
import sys

import pypandoc
import typst

FILTER = """function Meta(meta)
  for _, author in ipairs(meta.authors) do
    for _, place in ipairs(meta.affiliations) do
      if pandoc.utils.stringify(place.index) == pandoc.utils.stringify(author.affiliation) then
        author.affiliation = place.name
      end
    end
  end
  meta.author = meta.authors
  return meta
end"""

source, pdf = sys.argv[1:]
filter_file = pathlib.Path(source).with_name("authors.lua")
filter_file.write_text(FILTER)
pypandoc.convert_file(
    "paper/paper.md",
    "typst",
    outputfile=source,
    extra_args=[
        "--standalone",
        "--citeproc",
        "--bibliography=paper/paper.bib",
        "--fail-if-warnings",
        f"--lua-filter={filter_file}",
    ],
)
typst.compile(source, output=pdf)
