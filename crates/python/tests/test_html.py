"""Tables and results as HTML for notebooks."""

from html.parser import HTMLParser

import pytest
import wholestring as ws
from vision import contrast

# Background and text of JupyterLab, light and dark, and of VS Code's dark theme.
NOTEBOOKS = [("#ffffff", "#212121"), ("#111111", "#e0e0e0"), ("#1e1e1e", "#cccccc")]


class Tags(HTMLParser):
    """Checks that every element is closed, and counts elements."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.count: dict[str, int] = {}
        self.text: list[str] = []
        self.feed(text)
        assert not self.open

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.count[tag] = self.count.get(tag, 0) + 1
        if tag != "br":
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if self.open and self.open[-1] != "style":
            self.text.append(data)


def test_a_table_shows_its_head(slant: ws.Case) -> None:
    nodes = slant.soft().nodes
    html = nodes._repr_html_()
    tags = Tags(html)
    assert tags.count["tr"] == 11
    assert tags.count["th"] == len(nodes.columns)
    assert f"{len(nodes)} rows, {len(nodes.columns)} columns, the first 10 shown" in tags.text
    assert nodes.meaning("tension_N") in html
    assert "nan" not in tags.text


def test_results_show_numbers_in_the_units_of_the_case(slant: ws.Case) -> None:
    tags = Tags(slant.soft()._repr_html_())
    assert tags.count["tr"] == 6
    for text in ("Slant well", "trip out", "Hook load without block", "kN", "kN·m"):
        assert text in tags.text, text
    field = slant.with_(units="field").soft("trip_out")
    tags = Tags(field._repr_html_())
    assert "klbf" in tags.text
    assert f"{field['trip_out'].hook_load_N / 4448.2216152605:.4g}" in tags.text


def test_what_went_wrong_is_shown(slant: ws.Case) -> None:
    with pytest.raises(ws.NoAnswerError) as caught:
        slant.with_(friction=1.2, wob="900 kN").stiff()
    results = caught.value.results
    assert results is not None
    tags = Tags(results._repr_html_())
    assert "Status" in tags.text
    assert "failed" in tags.text


def test_words_of_others_stay_words(slant: ws.Case) -> None:
    html = slant.with_(name="<script>alert(1)</script>").soft("drill")._repr_html_()
    assert "<script>" not in html
    assert "&lt;script&gt;" in html


def test_it_is_read_in_light_and_dark_notebooks(slant: ws.Case) -> None:
    html = slant.soft()._repr_html_()
    # No colours of its own: text and lines have those of the notebook.
    style = html.split("<style scoped>")[1].split("</style>")[0]
    assert "#" not in style
    assert "rgb(" not in style
    assert "currentColor" in style
    assert "opacity:.75" in style
    for ground, text in NOTEBOOKS:
        thinned = "#" + "".join(
            f"{round(0.75 * int(text[at : at + 2], 16) + 0.25 * int(ground[at : at + 2], 16)):02x}"
            for at in (1, 3, 5)
        )
        assert contrast(text, ground) >= 4.5
        assert contrast(thinned, ground) >= 4.5


def test_a_case_and_a_simulation_show_what_they_are(slant: ws.Case, short: ws.Case) -> None:
    tags = Tags(slant._repr_html_())
    operations = "trip out, trip in, rotate off bottom, drill, slide"
    for text in ("Slant well", "1200 m", "soft, dynamic", operations):
        assert text in tags.text, text
    assert "klbf" not in " ".join(tags.text)
    with pytest.warns(ws.CaseWarning):
        light = slant.with_(mud__density=1.2)
    assert "Warning" in Tags(light._repr_html_()).text
    sim = short.with_(units="field").simulation()
    assert "Simulation: drill" in Tags(sim._repr_html_()).text
    sim.advance(0.1)
    cells = Tags(sim._repr_html_()).text
    assert "0.1 s" in cells
    assert f"{sim.now['hook_load_N'] / 4448.2216152605:.4g} klbf" in cells
