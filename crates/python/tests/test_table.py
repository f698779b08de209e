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
    # The view keeps what it looks at.
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
    """Words may be copied: pandas keeps texts its own way."""
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
