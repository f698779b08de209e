"""Profiles along the string against measured depth."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from .. import _core
from ..errors import InputError
from ..table import Table
from . import _hole
from ._columns import Columns
from ._curves import Curve, curves, stroke_keys
from ._house import SMALL, Drawn, Look, colour, curve_width, pictures, stroke, words
from ._keys import Key, band_key, write
from ._labels import Name, name_curves
from ._near import largest, rows_of_largest, smallest
from ._outliers import mark, reached
from ._paper import PAGE_MM, depth_down, finite, frames, given, heading, label_x, limits
from ._shown import Display, Numbers, Units, about, case_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes

IN_A_LINE = 4
HOLE_MM = 7.0
BETWEEN = "between the joints"


@dataclass(frozen=True)
class Track:
    """Content of a frame, and the rules of its axis."""

    column: str
    title: str
    dimension: str
    source: str = "profile"
    band: tuple[str, str] | None = None
    min_span: float = 0.0
    zero: bool = False
    sides: bool = False
    touches: bool = False
    swings: bool = False
    range: tuple[float, float] | None = None


@dataclass
class Run:
    """Data of one run to draw."""

    nodes: Columns
    wear: Columns | None
    well: Columns | None
    settings: Mapping[str, Any] | None
    name: str


def tracks(
    results: object,
    *names: str,
    operations: Sequence[str] | None = None,
    models: Sequence[str] | None = None,
    units: Units | None = None,
    axes: Sequence[Axes] | Axes | None = None,
) -> list[Axes]:
    """Draw profiles along the string in parallel frames, depth down.

    Operations differ by colour, models by stroke; the curves are labelled in the first frame. A
    band extends from the 5th to the 95th percentile over time. If there is a single curve, the area
    is filled with the colour of the side of the hole that the string lies on. At small scale, the
    contact of a joint applies to the pipe on either side of it.

    Parameters
    ----------
    results
        Results, or a table like their ``nodes``.
    *names
        Tracks to draw: ``"tension"``, ``"torque"``, ``"side-force"``, ``"contact"``,
        ``"bending-moment"``, ``"wear"``, ``"inclination"``, ``"dogleg-severity"``, or any column of
        the table; by default, all of the named tracks that have values.
    operations, models
        Operations and models to draw; all by default.
    units
        ``"si"``, ``"metric"`` or ``"field"``; those of the case by default.
    axes
        Axes to draw in, one per name; those of a new figure by default.

    Returns
    -------
    list of matplotlib.axes.Axes
        One per track.

    Raises
    ------
    ValueError
        If there is no such column, operation or model.

    Examples
    --------
    >>> import wholestring as ws
    >>> tension, torque = ws.plot.tracks(ws.Case.example().soft(), "tension", "torque")
    >>> tension.get_xlabel(), torque.get_xlabel()
    ('Effective tension, kN', 'Torque, kN·m')
    """
    return draw([results], [""], names, operations=operations, models=models, units=units, to=axes)


def draw(
    results: Sequence[object],
    run_names: Sequence[str],
    names: Sequence[str],
    *,
    operations: Sequence[str] | None,
    models: Sequence[str] | None,
    units: Units | None,
    to: Sequence[Axes] | Axes | None,
) -> list[Axes]:
    """Draw the tracks of one run or several."""
    subject = "a picture of tracks"
    display = Display(units, results[0])
    runs = [_run(result, name, subject) for result, name in zip(results, run_names, strict=True)]
    profiles = curves(
        [run.nodes for run in runs],
        run_names,
        operations=operations,
        models=models,
        subject=subject,
    )
    shows = _chosen(names, runs, profiles)
    own = to is None
    hole = _hole_of(runs) if own else []
    strips: list[Drawn] = []
    if to is None:
        made, strips = _frames(len(shows), bool(hole))
    else:
        made = given(to, len(shows), subject)
    depths: list[Numbers] = []
    labels: list[list[Name]] = []
    for ax, track in zip(made, shows, strict=True):
        labels.append(_track(ax, track, runs, profiles, display, depths))
    label = display.label("Measured depth", "length")
    for ax in strips:
        depth_down(ax, depths, label)
        settings = cast("Mapping[str, Any]", runs[0].settings)
        _hole.draw(ax, hole, float(settings["operation"]["bit_depth_m"]), display)
        ax.tick_params(labelleft=True)
    for place, ax in enumerate(made):
        is_first = not strips and (not own or place % _in_a_line(len(made)) == 0)
        depth_down(ax, depths, label if is_first else "")
        if own and not is_first:
            ax.tick_params(labelleft=False)
    if own:
        heading([*strips, *made], _title(runs))
    keys = stroke_keys(profiles)
    if any(ax.collections and track.band for ax, track in zip(made, shows, strict=True)):
        keys.append(band_key(profiles[0].look if len(profiles) == 1 else Look(colour("muted"))))
    if any(line.get_gid() == BETWEEN for ax in made for line in ax.get_lines()):
        ink = profiles[0].look.colour if len(profiles) == 1 else colour("muted")
        keys.append(Key(BETWEEN, Look(ink, stroke(2))))
    write([*strips, *made], keys, own=own)
    # The labels are written once, in the first frame in which the curves are well apart.
    apart = [_apart(names) if len(names) == max(map(len, labels)) else 0.0 for names in labels]
    best = next(place for place, gap in enumerate(apart) if gap >= 0.25 * max(apart))
    name_curves(made[best], labels[best])
    return cast("list[Axes]", made)


def _in_a_line(count: int) -> int:
    return -(-count // -(-count // IN_A_LINE))


def _frames(count: int, with_hole: bool) -> tuple[list[Drawn], list[Drawn]]:
    """Return the frames of the tracks, and those of the hole next to each row of tracks."""
    columns = _in_a_line(count)
    lines = -(-count // columns)
    extra = 1 if with_hole else 0
    width = PAGE_MM if columns > 2 else 65.0 * columns + 20.0
    made = frames(
        count + lines * extra,
        columns=columns + extra,
        width_mm=width,
        height_mm=105.0 if lines == 1 else 88.0,
        widths=[HOLE_MM] * extra + [(width - 30.0) / columns] * columns,
        between_mm=(4.0, 22.0),
        top_mm=21.0,
        bottom_mm=6.0,
        share_y=True,
    )
    strips = made[:: columns + 1] if with_hole else []
    return [ax for ax in made if ax not in strips], strips


def _track(
    ax: Drawn,
    track: Track,
    runs: Sequence[Run],
    profiles: Sequence[Curve],
    display: Display,
    depths: list[Numbers],
) -> list[Name]:
    values: list[Numbers] = []
    named: list[Name] = []
    beyond: list[tuple[Numbers, Numbers, str]] = []

    def keep(md_m: Numbers, si: Numbers) -> tuple[Numbers, Numbers]:
        depth, value = display.values(md_m, "length"), display.values(si, track.dimension)
        depths.append(depth)
        values.append(value)
        return depth, value

    if track.source == "well":
        for place, run in enumerate(_distinct_wells(runs)):
            columns = cast("Columns", run.well)
            depth, value = keep(columns.numbers("md_m"), columns.numbers(track.column))
            look = Look(colour("text")) if place == 0 else Look(colour(f"line-{place}"))
            _plot(ax, value, depth, look)
    else:
        for curve in profiles:
            name = _curve(ax, track, runs[curve.run], curve, keep, alone=len(profiles) == 1)
            if name is not None:
                beyond.append((name.x, name.y, name.colour))
                named.extend([name] if name.text else [])
    title = about(track.column)[0] if not track.title else track.title
    label_x(ax, display.label(title, track.dimension), on_top=True)
    if track.range is not None:
        ax.set_xlim(*(float(end) for end in display.values(np.array(track.range), track.dimension)))
    else:
        least = track.min_span / display.factor(track.dimension)
        clips = track.source == "profile"
        inner = reached(values, zero=track.zero) if clips else None
        spans = [np.array(inner)] if inner is not None else values
        ax.set_xlim(*limits(spans, zero=track.zero, min_span=least))
        if clips:
            mark(ax, beyond)
    low, high = ax.get_xlim()
    if low < 0.0 < high:
        ax.axvline(0.0, color=colour("frame"), linewidth=0.6, zorder=0.9)
    if track.sides:
        _name_sides(ax)
    return named


def _curve(
    ax: Drawn,
    track: Track,
    run: Run,
    curve: Curve,
    keep: Callable[[Numbers, Numbers], tuple[Numbers, Numbers]],
    *,
    alone: bool,
) -> Name | None:
    source = run.wear if track.source == "wear" else run.nodes
    if source is None:
        return None
    columns = curve.rows(source)
    if not columns.known(track.column):
        return None
    md_m, si = columns.numbers("md_m"), columns.numbers(track.column)
    low, high = _ends(columns, track)
    between: Numbers | None = None
    rules = pictures()["rules"]
    reach = float(rules["joint_reach_m"])
    if track.touches:
        si = largest(md_m, si, reach)
    if track.swings and md_m[-1] - md_m[0] > float(rules["far_m"]):
        least, rows = smallest(md_m, si, reach), rows_of_largest(md_m, si, reach)
        si = si[rows]
        if low is not None and high is not None:
            low, high = low[rows], high[rows]
        if np.nanmax(np.abs(least - si)) > float(rules["min_difference"]) * np.nanmax(np.abs(si)):
            between = least
    if low is not None and high is not None:
        depth, left = keep(md_m, low)
        _, right = keep(md_m, high)
        alpha = float(pictures()["band"])
        ax.fill_betweenx(depth, left, right, color=curve.look.colour, alpha=alpha, linewidth=0)
    depth, value = keep(md_m, si)
    if track.sides and alone:
        for name, where in (("high-side", value > 0.0), ("low-side", value < 0.0)):
            side = np.where(where, value, 0.0)
            ax.fill_betweenx(depth, 0.0, side, color=colour(name), linewidth=0)
    if between is not None:
        across = keep(md_m, between)[1]
        _plot(ax, across, depth, Look(curve.look.colour, stroke(2)), BETWEEN)
    _plot(ax, value, depth, curve.look)
    return Name(curve.name, curve.look.colour, value, depth, at=0.35)


def _ends(columns: Columns, track: Track) -> tuple[Numbers | None, Numbers | None]:
    if track.band is None or not columns.known(track.band[0]):
        return None, None
    return columns.numbers(track.band[0]), columns.numbers(track.band[1])


def _plot(ax: Drawn, across: Numbers, depth: Numbers, look: Look, gid: str | None = None) -> None:
    width = curve_width()
    ax.plot(across, depth, color=look.colour, linestyle=look.stroke, linewidth=width, gid=gid)


def _name_sides(ax: Drawn) -> None:
    low, high = ax.get_xlim()
    for left, text, is_within in ((True, "low side", low < 0.0), (False, "high side", high > 0.0)):
        if is_within:
            ax.text(
                0.0 if left else 1.0,
                -0.012,
                text,
                transform=ax.transAxes,
                ha="left" if left else "right",
                va="top",
                **words(SMALL, "muted"),
            )


def _apart(names: Sequence[Name]) -> float:
    """Return the distance between the two nearest curves, relative to the largest value."""
    known = [values for values in (finite([name.x]) for name in names) if values.size]
    if len(known) < 2:
        return 0.0
    middles = np.sort([float(np.median(values)) for values in known])
    most = max(float(np.abs(values).max()) for values in known)
    return float(np.diff(middles).min()) / most if most > 0.0 else 0.0


def _run(thing: object, name: str, subject: str) -> Run:
    nodes = Columns(thing, "nodes", subject)
    nodes.need("md_m")
    summary = getattr(thing, "summary", None)
    if not isinstance(summary, Mapping):
        return Run(nodes, None, None, None, name)
    settings = cast("Mapping[str, Any]", cast("Mapping[str, Any]", summary)["settings"])
    there = cast("Sequence[str]", getattr(thing, "tables", ()))
    wear = Columns(thing, "wear", subject) if "wear" in there else None
    path = Table(_core.well_path(json.dumps(settings)), "well")
    well = Columns(path, "well", subject) if len(path) else None
    return Run(nodes, wear, well, settings, name or case_name(thing))


def _declared() -> dict[str, Track]:
    made: dict[str, Track] = {}
    for row in pictures()["tracks"]:
        made[row["name"]] = Track(
            column=row["column"],
            title=row["title"],
            dimension=row["dimension"],
            source=row["from"],
            band=tuple(row["band"]) if row.get("band") else None,
            min_span=row["min_span"],
            zero=row["zero"],
            sides=row["sides"],
            touches=row["touches"],
            swings=row["swings"],
            range=tuple(row["range"]) if row.get("range") else None,
        )
    return made


def _chosen(names: Sequence[str], runs: Sequence[Run], profiles: Sequence[Curve]) -> list[Track]:
    declared = _declared()
    if not names:
        known = [track for track in declared.values() if _has(track, runs, profiles)]
        if not known:
            profiled = (entry for entry in declared.values() if entry.source == "profile")
            runs[0].nodes.need(*(entry.column for entry in profiled))
        return known
    chosen: list[Track] = []
    for name in names:
        by_column = next((entry for entry in declared.values() if entry.column == name), None)
        track = declared.get(name) or by_column
        if track is None:
            title, dimension = about(name)
            track = Track(column=name, title=title, dimension=dimension)
        if not _has(track, runs, profiles):
            if track.source == "profile":
                runs[0].nodes.need(track.column)
            raise InputError(f"a picture of tracks: `{name}` has no values here")
        chosen.append(track)
    return chosen


def _has(track: Track, runs: Sequence[Run], profiles: Sequence[Curve]) -> bool:
    if track.source == "well":
        return any(run.well is not None for run in runs)
    for curve in profiles:
        source = runs[curve.run].wear if track.source == "wear" else runs[curve.run].nodes
        if source is not None and curve.rows(source).known(track.column):
            return True
    return False


def _distinct_wells(runs: Sequence[Run]) -> list[Run]:
    """Return one run per well, so that the path of a shared well is drawn once."""
    seen: dict[str, Run] = {}
    for run in runs:
        if run.well is not None and run.settings is not None:
            seen.setdefault(json.dumps(run.settings["well"], sort_keys=True), run)
    return list(seen.values())


def _hole_of(runs: Sequence[Run]) -> list[_hole.Section]:
    """Return the hole to draw next to the tracks; empty if the runs differ in it."""
    every = [_hole.sections(run.settings) for run in runs if run.settings is not None]
    if len(every) != len(runs) or any(hole != every[0] for hole in every):
        return []
    return every[0]


def _title(runs: Sequence[Run]) -> str:
    return runs[0].name if len(runs) == 1 else ""
