"""Figures: axes, limits, curves, colours, and errors for missing data."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import matplotlib.pyplot
import numpy as np
import pytest
import wholestring as ws
from matplotlib.colors import to_hex
from numpy.typing import NDArray
from vision import ciede2000, contrast, difference
from wholestring.plot import _house, _labels

matplotlib.use("agg")

# The types of matplotlib lack the methods of figures in use here.
plot: Any = ws.plot
pyplot: Any = matplotlib.pyplot

Rows = dict[str, list[Any]]


@pytest.fixture(autouse=True)
def figures_are_closed() -> Iterator[None]:
    yield
    pyplot.close("all")


@pytest.fixture(scope="module")
def soft() -> ws.Results:
    return ws.Case.example().soft()


@pytest.fixture(scope="module")
def moving() -> ws.Results:
    case = ws.Case.example().with_(
        operation__kind="drill",
        mesh__element_length="20 m",
        dynamics__duration="2 s",
        records__spectra=["hook_load", "surface_torque"],
    )
    return case.dynamic()


def of_operation(results: ws.Results, operation: str, column: str) -> NDArray[np.float64]:
    nodes = results.nodes
    return np.asarray(nodes[column][nodes["operation"] == operation], dtype=float)


def drawn(ax: Any, colour: str) -> Any:
    """Return the curve of this colour."""
    lines = [line for line in ax.get_lines() if to_hex(line.get_color()) == colour]
    return max(lines, key=lambda line: len(line.get_xdata()))


def texts(ax: Any) -> set[str]:
    return {text.get_text() for text in ax.texts}


def test_tracks_draw_what_the_table_holds(soft: ws.Results) -> None:
    tension, torque = plot.tracks(soft, "tension", "torque")
    assert tension.get_xlabel() == "Effective tension, kN"
    assert torque.get_xlabel() == "Torque, kN·m"
    assert tension.get_ylim() == (1200.0, 0.0)
    assert tension.yaxis_inverted()
    for operation in ("trip_out", "drill", "slide"):
        curve = drawn(tension, _house.operation_colour(operation))
        assert np.array_equal(curve.get_ydata(), of_operation(soft, operation, "md_m"))
        ours = of_operation(soft, operation, "tension_N") / 1e3
        assert np.array_equal(curve.get_xdata(), ours)
        low, high = tension.get_xlim()
        assert low < ours.min() and ours.max() < high
    assert texts(tension) == {"trip out", "trip in", "rotate off bottom", "drill", "slide"}


def test_units_are_the_readers_and_the_cases(soft: ws.Results) -> None:
    (field,) = plot.tracks(soft, "tension", units="field")
    assert field.get_xlabel() == "Effective tension, klbf"
    curve = drawn(field, _house.operation_colour("trip_out"))
    assert curve.get_xdata() == pytest.approx(
        of_operation(soft, "trip_out", "tension_N") / 4448.2216152605, rel=1e-12
    )
    assert field.get_ylim()[0] == pytest.approx(1200.0 / 0.3048)
    own = ws.Case.example().with_(units="metric").soft("trip_out")
    (metric,) = plot.tracks(own, "tension")
    assert metric.get_xlabel() == "Effective tension, t"
    with pytest.raises(ValueError, match="there are no units 'oil': there are si, metric, field"):
        plot.tracks(soft, "tension", units="oil")


def test_the_sides_of_the_hole_are_filled_where_one_curve_is_drawn(soft: ws.Results) -> None:
    (alone,) = plot.tracks(soft, "side-force", operations=["trip_out"])
    filled = {to_hex(area.get_facecolor()[0]) for area in alone.collections}
    assert filled == {_house.colour("high-side"), _house.colour("low-side")}
    assert {"low side", "high side"} <= texts(alone)
    (several,) = plot.tracks(soft, "side-force")
    assert not several.collections


def test_all_tracks_stand_beside_the_hole(moving: ws.Results) -> None:
    axes = plot.tracks(moving)
    labels = [ax.get_xlabel() for ax in axes]
    assert labels[0] == "Effective tension, kN"
    assert "Inclination, °" in labels
    assert len(labels) == 8
    figure: Any = axes[0].figure
    assert len(figure.axes) == len(axes) + 2
    assert figure.texts[0].get_text() == "Slant well"
    path = plot.well(moving)[1].get_lines()
    assert path


def test_a_joint_counts_as_far_as_it_reaches() -> None:
    md = np.arange(0.0, 100.0, 2.0)
    touch = np.zeros(len(md))
    touch[20] = 1.0
    rows = {"operation": ["drill"] * len(md), "md_m": md, "contact_fraction": touch}
    (ax,) = plot.tracks(rows, "contact")
    curve = drawn(ax, _house.line_colour(0))
    near = np.abs(md - md[20]) <= 6.0
    assert np.array_equal(curve.get_xdata(), np.where(near, 100.0, 0.0))


def test_single_values_far_off_do_not_flatten_a_track() -> None:
    md = np.linspace(0.0, 1000.0, 500)
    force = np.sin(md / 100.0)
    force[250] = 300.0
    rows = {"operation": ["drill"] * 500, "md_m": md, "side_force_N_per_m": force * 1e3}
    (ax,) = plot.tracks(rows, "side-force")
    assert ax.get_xlim()[1] < 2.0
    assert "300" in texts(ax)


def test_what_is_not_there_is_named(soft: ws.Results, moving: ws.Results) -> None:
    with pytest.raises(ValueError, match="needs the column `hook`: there are model, operation"):
        plot.tracks(soft, "hook")
    with pytest.raises(ValueError, match="there is no 'fish': there are trip_out"):
        plot.tracks(soft, "tension", operations=["fish"])
    with pytest.raises(ValueError, match="no model 'dynamic' solved it: soft did"):
        plot.tracks(soft, "tension", models=["dynamic"])
    with pytest.raises(ValueError, match="needs the table `time`: there are nodes"):
        plot.time(soft)
    with pytest.raises(ValueError, match="there is no 'slide': there are drill"):
        plot.time(moving, operation="slide")
    with pytest.raises(ValueError, match="needs the column `operation`"):
        plot.broomstick({"bit_depth_m": [1.0], "hook_load_N": [1.0]})
    with pytest.raises(TypeError, match="takes results, a table, a data frame or a mapping"):
        plot.broomstick(3.0)
    with pytest.raises(TypeError, match="takes a case or results"):
        plot.well({})
    with pytest.raises(ValueError, match="has 2 frames and was given 1 axes"):
        plot.tracks(soft, "tension", "torque", axes=[pyplot.figure().add_subplot()])
    with pytest.raises(ValueError, match="there is no signal 'bit': there are hook_load"):
        plot.spectrum(moving, "bit")
    with pytest.raises(ValueError, match="several rows have the same `friction`"):
        plot.sweep({"friction": [0.1, 0.1], "hook_load_N": [1.0, 2.0]}, x="friction")


def test_time_stands_below_time(moving: ws.Results) -> None:
    hook_load, torque, speed = plot.time(moving)
    assert hook_load.get_ylabel().replace("\n", " ") == "Hook load without block, kN"
    assert speed.get_xlabel() == "Time, s"
    curve = drawn(hook_load, _house.line_colour(0))
    assert np.array_equal(curve.get_xdata(), moving.time["time_s"])
    assert np.array_equal(curve.get_ydata(), moving.time["hook_load_N"] / 1e3)
    # A nearly constant curve is not enlarged.
    assert np.ptp(hook_load.get_ylim()) >= 20.0
    assert texts(torque) == {"surface", "friction", "bit"}
    (depths,) = plot.time(moving, "depths")
    assert depths.yaxis_inverted()
    (own,) = plot.time(moving, "bit_torque_N_m")
    assert own.get_ylabel() == "Bit torque, kN·m"


def test_the_window_of_the_statistics_is_set_apart(moving: ws.Results) -> None:
    settle_s = moving["drill"].data["numerics"]["settle_s"]
    assert settle_s > 0.0
    (ax,) = plot.time(moving, "hook-load")
    assert max(patch.get_window_extent().x1 for patch in ax.patches) == pytest.approx(
        ax.transData.transform((settle_s, 0.0))[0]
    )


def broom() -> Rows:
    rows: Rows = {column: [] for column in ("operation", "friction", "bit_depth_m", "hook_load_N")}
    for operation, sign in (("trip_out", 1.0), ("trip_in", -1.0), ("rotate_off_bottom", 0.0)):
        for level, friction in (("low", 0.1), ("expected", 0.2), ("high", 0.3)):
            for depth in (500.0, 1000.0, 1500.0):
                rows["operation"].append(operation)
                rows["friction"].append(level)
                rows["bit_depth_m"].append(depth)
                rows["hook_load_N"].append(200.0 * depth * (1.0 + sign * friction))
    return rows


def test_a_broomstick_has_operations_by_colour_and_friction_by_stroke() -> None:
    ax: Any = plot.broomstick(broom(), limit=5.0e5)
    assert ax.get_xlabel() == "Hook load without block, kN"
    assert ax.get_ylabel() == "Measured depth of the bit, m"
    assert ax.get_ylim() == (1500.0, 500.0)
    assert ax.get_xlim()[0] == 0.0
    assert ax.get_xlim()[1] > 500.0
    curves = [line for line in ax.get_lines() if len(line.get_xdata()) == 3]
    assert len(curves) == 9
    assert len({line.get_color() for line in curves}) == 3
    assert len({str(line._dash_pattern) for line in curves}) == 3
    largest_kN = max(broom()["hook_load_N"]) / 1e3
    high = next(line for line in curves if line.get_xdata()[-1] == largest_kN)
    assert high.get_color() == _house.operation_colour("trip_out")
    assert texts(ax) == {"trip out", "trip in", "rotate off bottom"}
    legend = ax.figure.legends[0]
    assert [text.get_text() for text in legend.get_texts()] == [
        "low friction",
        "expected friction",
        "high friction",
    ]


def test_data_frames_are_drawn_too() -> None:
    import pandas
    import polars

    for frame in (pandas.DataFrame(broom()), polars.DataFrame(broom())):
        ax = plot.broomstick(frame, units="field")
        assert ax.get_xlabel() == "Hook load without block, klbf"


def test_a_well_is_to_scale_and_deep_is_down(soft: ws.Results) -> None:
    plan, section = plot.well(ws.Case.example())
    assert plan.get_xlabel() == "East, m"
    assert plan.get_ylabel() == "North, m"
    assert section.get_ylabel() == "True vertical depth, m"
    for ax in (plan, section):
        assert ax.get_aspect() == 1.0
        box = ax.get_window_extent()
        across = abs(np.diff(ax.get_xlim())[0]) / box.width
        along = abs(np.diff(ax.get_ylim())[0]) / box.height
        assert across == pytest.approx(along, rel=1e-9)
    assert section.get_ylim()[0] > section.get_ylim()[1]
    # The end of the section of a slant well: vertical, arc, tangent.
    ends = [line.get_ydata()[-1] for line in section.get_lines() if len(line.get_xdata()) > 2]
    assert max(ends) < 1200.0
    assert "1\N{NARROW NO-BREAK SPACE}200" in texts(section)
    assert [ax.get_xlabel() for ax in plot.well(soft)] == ["East, m", "Along the section, m"]


def test_spectra_are_densities_in_the_readers_units(moving: ws.Results) -> None:
    hook_load, torque = plot.spectrum(moving, to_Hz=20.0)
    assert hook_load.get_ylabel() == "Hook load without block, kN²/Hz"
    assert torque.get_ylabel() == "Surface torque, (kN·m)²/Hz"
    assert hook_load.get_yscale() == "log"
    assert hook_load.get_xlim()[1] <= 20.0
    table = moving.table("spectra")
    rows = (table["signal"] == "hook_load") & (table["frequency_Hz"] > 0.0)
    rows &= table["frequency_Hz"] <= 20.0
    curve = drawn(hook_load, _house.line_colour(0))
    assert curve.get_ydata() == pytest.approx(table["density"][rows] / 1e6, rel=1e-12)


def test_runs_are_told_apart_by_colour_and_stroke(soft: ws.Results) -> None:
    case = ws.Case.example()
    runs = [case.with_(friction=friction).soft("drill") for friction in (0.1, 0.2, 0.3)]
    tension, torque, _ = plot.compare(*runs, names=["0.1", "0.2", "0.3"])
    named = texts(tension) | texts(torque)
    assert {"0.1", "0.2", "0.3"} <= named
    for place, run in enumerate(runs):
        curve = drawn(torque, _house.line_colour(place))
        assert np.array_equal(curve.get_xdata(), run.nodes["torque_N_m"] / 1e3)
    with pytest.raises(ValueError, match="two to seven runs, and was given 1"):
        plot.compare(soft)
    with pytest.raises(ValueError, match="of one operation: name one of trip_out"):
        plot.compare(soft, soft)
    with pytest.raises(ValueError, match="no operation in common"):
        plot.compare(case.soft("drill"), case.soft("slide"))
    with pytest.raises(ValueError, match="of 2 runs was given 1 names"):
        plot.compare(runs[0], runs[1], names=["one"])


def test_a_calibration_has_readings_and_bands() -> None:
    read = {
        "reading": ["pick_up", "pick_up", "slack_off", "torque"],
        "used": [1.0, 0.0, 1.0, 1.0],
        "bit_depth_m": [1000.0, 1500.0, 1500.0, 1500.0],
        "measured_N": [8e5, 9e5, 7e5, np.nan],
        "measured_N_m": [np.nan, np.nan, np.nan, 9e3],
    }
    bands: Rows = {"reading": ["pick_up"] * 2, "bit_depth_m": [900.0, 1600.0]}
    for name, middle in (("predicted", 0.0), ("mean_low", -1e4), ("mean_high", 1e4)):
        bands[f"{name}_N"] = [8e5 + middle, 9e5 + middle]
        bands[f"{name}_N_m"] = [np.nan, np.nan]
    for name, middle in (("reading_low", -5e4), ("reading_high", 5e4)):
        bands[f"{name}_N"] = [8e5 + middle, 9e5 + middle]
        bands[f"{name}_N_m"] = [np.nan, np.nan]
    weights, torques = plot.calibration(read, bands=bands)
    assert weights.get_xlabel() == "Weight with block, kN"
    assert torques.get_xlabel() == "Torque, kN·m"
    assert weights.yaxis_inverted()
    points = [line for line in weights.get_lines() if line.get_linestyle() == "None"]
    colours = {to_hex(line.get_color()) for line in points if len(line.get_xdata())}
    assert _house.colour("muted") in colours
    assert _house.operation_colour("trip_out") in colours
    curve = next(line for line in weights.get_lines() if line.get_linestyle() == "-")
    assert np.array_equal(curve.get_xdata(), [800.0, 900.0])
    assert len(weights.collections) == 2


def test_a_reach_shows_what_is_left() -> None:
    rows = {
        "operation": ["drill"] * 4,
        "limit": ["top_drive", "top_drive", "helix", "helix"],
        "friction": [np.nan] * 4,
        "bit_depth_m": [2000.0, 4000.0, 2000.0, 4000.0],
        "margin": [0.5, -0.5, 0.9, 0.8],
    }
    (ax,) = plot.reach(rows)
    assert ax.get_ylabel() == "Drill: margin, %"
    assert ax.get_xlim() == (2000.0, 4000.0)
    assert texts(ax) == {"top drive", "helix"}
    met = [line for line in ax.get_lines() if len(line.get_xdata()) == 1]
    assert [float(line.get_xdata()[0]) for line in met] == [pytest.approx(3000.0)]


def test_a_campbell_diagram_has_orders_and_critical_speeds() -> None:
    rows = {
        "branch": [0.0, 0.0, 1.0, 1.0],
        "family": ["lateral", "lateral", "torsional", "torsional"],
        "whirl": ["forward", "forward", "", ""],
        "rotary_speed_rad_per_s": [0.0, 20.0, 0.0, 20.0],
        "frequency_Hz": [1.8, 2.0, 0.5, 0.5],
    }
    critical = {
        "order": [1.0],
        "family": ["lateral"],
        "rotary_speed_rad_per_s": [12.0],
        "frequency_Hz": [1.91],
    }
    ax: Any = plot.campbell(rows, critical=critical)
    assert ax.get_xlabel() == "Rotary speed, rpm"
    assert ax.get_xlim() == (0.0, pytest.approx(20.0 * 60.0 / (2.0 * np.pi)))
    assert {"1x", "lateral", "torsional"} == texts(ax)
    points = (line for line in ax.get_lines() if line.get_marker() == "o")
    point = next(line for line in points if len(line.get_xdata()))
    assert float(point.get_ydata()[0]) == 1.91
    order = next(line for line in ax.get_lines() if line.get_color() == _house.colour("muted"))
    # Once per revolution: 60 rpm is 1 Hz.
    x, y = order.get_xdata()[-1], order.get_ydata()[-1]
    assert x / 60.0 == pytest.approx(y)


def test_modes_have_their_frequency() -> None:
    shapes = {
        "family": ["axial"] * 3,
        "number": [1.0] * 3,
        "md_m": [0.0, 500.0, 1000.0],
        "along_m": [0.0, 0.7, 1.0],
    }
    hertz = {"family": ["axial"], "number": [1.0], "frequency_Hz": [1.25]}
    (ax,) = plot.modes(shapes, family="axial", frequencies=hertz)
    assert ax.get_xlabel() == "Mode 1: 1.25 Hz"
    assert ax.get_ylim() == (1000.0, 0.0)
    with pytest.raises(ValueError, match="there is no 'lateral': there are axial"):
        plot.modes(shapes)
    with pytest.raises(ValueError, match="needs the column `along_m`"):
        plot.modes({name: shapes[name] for name in ("family", "number", "md_m")}, family="axial")


def test_a_sweep_draws_a_curve_a_value() -> None:
    rows = {
        "friction": ["0.1", "0.2", "0.1", "0.2"],
        "bit_depth": ["900m", "900m", "1200m", "1200m"],
        "hook_load_N": [2e5, 3e5, 4e5, 6e5],
    }
    ax = plot.sweep(rows, x="friction", by="bit_depth")
    assert ax.get_xlabel() == "Friction"
    assert texts(ax) == {"900m", "1200m"}
    down = plot.sweep(rows, x="bit_depth", by="friction")
    assert down.yaxis_inverted()
    assert down.get_ylabel() == "Bit depth, m"
    assert texts(down) == {"friction 0.1", "friction 0.2"}
    curve = drawn(down, _house.line_colour(1))
    assert np.array_equal(curve.get_xdata(), [300.0, 600.0])
    with pytest.raises(ValueError, match="`note` has no numbers: a, b"):
        plot.sweep({"note": ["a", "b"], "hook_load_N": [1.0, 2.0]}, x="note")
    with pytest.raises(ValueError, match="has several units"):
        plot.sweep({"at": ["1 m", "2 ft"], "hook_load_N": [1.0, 2.0]}, x="at")


def test_a_sweep_of_keys_names_its_units(slant: ws.Case, tmp_path: Path) -> None:
    """Numbers of a key are SI in the table, rotary speeds in rev/min as their key says, and in the
    units of the reader in a figure."""
    case = slant.with_(model="soft", operation__kind="drill")
    vary: dict[str, Any] = {"rpm": [60, 120], "wob": ["20 kN", "50 kN"]}
    swept = ws.sweep(case, vary, folder=tmp_path / "swept")
    assert swept.names[0] == "rpm=60 rpm,wob=20 kN"
    assert swept.table["rpm"] == pytest.approx([60.0, 60.0, 120.0, 120.0], rel=1e-12)
    assert (swept.table.unit("rpm"), swept.table.unit("wob")) == ("rpm", "N")
    ax = plot.sweep(swept, x="rpm", y="surface_torque_N_m", by="wob")
    assert ax.get_xlabel() == "Rotary speed, rpm"
    assert np.allclose(ax.lines[0].get_xdata(), [60.0, 120.0], rtol=1e-12)
    assert texts(ax) == {"20 kN", "50 kN"}
    field = plot.sweep(swept, x="wob", y="surface_torque_N_m", by="rpm", units="field")
    assert field.get_xlabel() == "Weight on bit, klbf"
    assert texts(field) == {"60 rpm", "120 rpm"}
    std = {"wob": [2e4, 5e4], "hook_load_N_std": [1e3, 2e3]}
    ax = plot.sweep(std, x="wob", y="hook_load_N_std")
    assert ax.get_ylabel() == "Hook load without block, standard deviation, kN"


def test_given_axes_are_drawn_in_and_given_back(soft: ws.Results) -> None:
    figure, (left, right) = pyplot.subplots(1, 2)
    back = plot.tracks(soft, "tension", "torque", axes=[left, right])
    assert back == [left, right]
    assert len(figure.axes) == 2
    assert left.yaxis_inverted()
    ax = pyplot.figure().add_subplot()
    assert plot.broomstick(broom(), ax=ax) is ax


def test_names_do_not_lie_on_one_another(soft: ws.Results) -> None:
    for axes in (plot.tracks(soft, "tension", "torque"), [plot.broomstick(broom())]):
        for ax in axes:
            boxes = [text.get_window_extent() for text in ax.texts]
            frame = ax.get_window_extent()
            for place, box in enumerate(boxes):
                assert frame.x0 - 1 <= box.x0 and box.x1 <= frame.x1 + 1
                assert not any(box.overlaps(other) for other in boxes[:place])


def test_labels_stay_within_the_figure(soft: ws.Results, moving: ws.Results) -> None:
    every = [*plot.tracks(soft)[:1], *plot.time(moving, "depths", "hook-load")[:1]]
    every += [*plot.well(soft)[:1], *plot.spectrum(moving)[:1]]
    for first in every:
        figure: Any = first.figure
        figure.canvas.draw()
        whole = figure.bbox
        for ax in figure.axes:
            for label in (ax.xaxis.label, ax.yaxis.label):
                box = label.get_window_extent()
                if not label.get_text():
                    continue
                assert box.x0 >= -0.5 and box.x1 <= whole.x1 + 0.5, label.get_text()
                assert box.y0 >= -0.5 and box.y1 <= whole.y1 + 0.5, label.get_text()


def test_the_difference_of_colours_is_that_of_its_authors() -> None:
    # Pairs 1 and 17 of table 1 of Sharma, Wu and Dalal, which prints four decimals.
    for a, b, expected in (
        ([50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485], 2.0425),
        ([50.0, 2.5, 0.0], [73.0, 25.0, -18.0], 27.1492),
    ):
        assert ciede2000(np.array(a), np.array(b)) == pytest.approx(expected, abs=5.1e-5)


def test_every_eye_tells_the_curves_of_a_figure_apart(soft: ws.Results) -> None:
    (ax,) = plot.tracks(soft, "tension")
    paper = _house.colour("paper")
    assert to_hex(ax.get_facecolor()) == paper
    curves = {to_hex(line.get_color()) for line in ax.get_lines()} - {_house.colour("frame")}
    assert len(curves) == 5
    # 20 of CIEDE2000 is the report's own bound; lines have a contrast of 3 and text of 4.5.
    for place, colour in enumerate(sorted(curves)):
        assert contrast(colour, paper) >= 3.0
        for other in sorted(curves)[:place]:
            assert difference(colour, other) >= 20.0
    for label in (ax.xaxis.label, ax.yaxis.label):
        assert contrast(to_hex(label.get_color()), paper) >= 4.5
    sides = [_house.colour("high-side"), _house.colour("low-side")]
    for side in sides:
        assert all(difference(side, colour) >= 20.0 for colour in curves)


def test_the_name_of_a_curve_is_beside_it() -> None:
    ax: Any = pyplot.figure().add_subplot()
    x = np.linspace(0.0, 1.0, 50)
    ax.plot(x, x)
    ax.plot(x, 1.0 - x)
    names = [_labels.Name("up", "#000000", x, x), _labels.Name("down", "#000000", x, 1.0 - x)]
    _labels.name_curves(ax, names)
    for text, sign in zip(ax.texts, (1.0, -1.0), strict=True):
        anchor = text.xy
        expected = anchor[0] if sign > 0.0 else 1.0 - anchor[0]
        assert anchor[1] == pytest.approx(expected, abs=0.02)


def test_without_matplotlib_it_says_what_to_install() -> None:
    script = (
        "import sys; sys.modules['matplotlib'] = None; import wholestring as ws\n"
        "try: ws.plot.well(ws.Case.example())\n"
        "except ImportError as error: print(error)"
    )
    ran = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert ran.stdout.strip() == "a figure needs matplotlib: pip install matplotlib"
