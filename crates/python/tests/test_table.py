"""Tables: shared, with units and meanings."""

from typing import Any

import numpy as np
import pandas
import pytest
import wholestring as ws


def test_numpy_views_the_memory(slant: ws.Case) -> None:
    nodes = slant.soft().nodes
    tension = nodes["tension_N"]
    again = nodes["tension_N"]
    assert tension.__array_interface__["data"] == again.__array_interface__["data"]
    assert not tension.flags.writeable
    assert tension.dtype == np.float64
    del nodes
    # The view keeps its memory alive.
    assert np.isfinite(tension).all()


def test_polars_shares_the_numbers(slant: ws.Case) -> None:
    nodes = slant.soft().nodes
    frame = nodes.to_polars()
    ours = nodes["md_m"]
    theirs = frame["md_m"].to_numpy(allow_copy=False)
    assert theirs.__array_interface__["data"][0] == ours.__array_interface__["data"][0]
    assert frame.height == len(nodes)


def test_what_does_not_apply_is_null_and_nan(slant: ws.Case) -> None:
    nodes = slant.soft().nodes
    frame = nodes.to_polars()
    nulls = [name for name in nodes.columns if frame[name].null_count() > 0]
    assert nulls
    for name in nulls:
        assert np.isnan(nodes[name]).sum() == frame[name].null_count()


def test_pandas_has_the_same(slant: ws.Case) -> None:
    nodes = slant.soft().nodes
    frame = nodes.to_pandas()
    assert isinstance(frame, pandas.DataFrame)
    assert list(frame.columns) == list(nodes.columns)
    assert (frame["operation"] == nodes["operation"]).all()


def test_pandas_shares_the_numbers(slant: ws.Case) -> None:
    """Texts may be copied, because pandas stores them in its own form."""
    nodes = slant.soft().nodes
    frame = nodes.to_pandas()
    numbers = [name for name in nodes.columns if nodes[name].dtype == np.float64]
    assert len(numbers) > 10
    for name in numbers:
        assert np.shares_memory(frame[name].to_numpy(copy=False), nodes[name]), name


def test_duckdb_takes_it(slant: ws.Case) -> None:
    duckdb: Any = pytest.importorskip("duckdb")
    nodes = slant.soft().nodes
    connection = duckdb.connect()
    connection.register("nodes", nodes)
    query = "select operation, max(tension_N), count(*) from nodes group by operation"
    found = {name: (most, count) for name, most, count in connection.sql(query).fetchall()}
    assert set(found) == set(slant.operations)
    for name, (most, count) in found.items():
        ours = nodes["tension_N"][nodes["operation"] == name]
        assert (most, count) == (ours.max(), len(ours))
    nulls = connection.sql("select count(*) from nodes where md_m is null").fetchall()
    assert nulls == [(0,)]


def test_pyarrow_shares_the_numbers(slant: ws.Case) -> None:
    pyarrow: Any = pytest.importorskip("pyarrow")
    nodes = slant.soft().nodes
    taken = pyarrow.table(nodes)
    (chunk,) = taken.column("md_m").chunks
    assert np.shares_memory(chunk.to_numpy(zero_copy_only=True), nodes["md_m"])


def test_units_and_meanings(slant: ws.Case) -> None:
    nodes = slant.soft().nodes
    assert nodes.unit("tension_N") == "N"
    assert "tension" in nodes.meaning("tension_N").lower()
    for name in nodes.columns:
        assert nodes.meaning(name)
    assert "md_m" in nodes
    assert "md_ft" not in nodes
    with pytest.raises(KeyError, match=r"there is no column `md_ft`: it has model"):
        nodes["md_ft"]
    assert nodes._repr_html_().count("<tr>") == 11


def test_a_frame_of_pandas_is_made_of_it(slant: ws.Case) -> None:
    nodes = slant.soft().nodes
    frame = pandas.DataFrame(nodes)
    assert tuple(frame.columns) == nodes.columns
    for name in ("md_m", "tension_N"):
        assert np.array_equal(frame[name], nodes[name])
    assert list(frame["operation"]) == list(nodes["operation"])
    first = next(iter(nodes))
    assert first["md_m"] == nodes["md_m"][0]
    assert len(list(nodes)) == len(nodes)


def test_some_columns_are_a_table(slant: ws.Case) -> None:
    nodes = slant.soft("drill").nodes
    two = nodes[["md_m", "tension_N"]]
    assert two.columns == ("md_m", "tension_N")
    assert two.unit("tension_N") == "N"
    assert np.shares_memory(two["tension_N"], nodes["tension_N"])
    with pytest.raises(ws.NotFoundError, match="there is no column `fish`"):
        nodes[["md_m", "fish"]]
    with pytest.raises(KeyError):
        nodes["fish"]
    assert nodes._ipython_key_completions_() == list(nodes.columns)


def test_scalars_are_a_row_for_each_operation(slant: ws.Case, short: ws.Case) -> None:
    results = slant.soft()
    frame = results.to_pandas()
    assert list(frame["operation"]) == [result.operation for result in results]
    assert list(frame["hook_load_N"]) == [result.hook_load_N for result in results]
    assert results.scalars.unit("hook_load_N") == "N"
    assert results._ipython_key_completions_() == [result.operation for result in results]
    moving = short.dynamic()
    scalars = moving.scalars
    statistics = moving["drill"].statistics
    assert scalars["hook_load_N_std"][0] == statistics["hook_load_N"]["std"]
    indicators = moving["drill"].data["indicators"]["stick_slip"]
    assert scalars["stick_slip_severity"][0] == indicators["severity"]
    assert scalars.unit("bit_speed_max_rad_per_s") == "rad/s"
    assert moving.to_polars()["operation"].to_list() == ["drill"]
