"""Tables that other libraries read without a copy."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from . import _core, _html
from .errors import MissingPackageError

if TYPE_CHECKING:
    import pandas
    import polars
    from numpy.typing import NDArray


class Table:
    """A table of results with the content of its Parquet file: SI, units in the column names.

    polars, pandas 3, DuckDB and pyarrow read it by Arrow's PyCapsule interface and share its
    memory: ``polars.DataFrame(table)``. A number that does not apply is null there, and NaN in
    NumPy.

    Examples
    --------
    >>> import wholestring as ws
    >>> nodes = ws.Case.example().soft().table("nodes")
    >>> nodes.columns[:4]
    ('model', 'operation', 'md_m', 'tension_N')
    >>> nodes.unit("tension_N")
    'N'
    >>> float(nodes["md_m"].max())
    1200.0
    """

    __slots__ = ("_core", "_name")

    def __init__(self, core: _core.Table, name: str) -> None:
        self._core = core
        self._name = name

    @property
    def name(self) -> str:
        """Name of the file of the table, without the extension."""
        return self._name

    @property
    def columns(self) -> tuple[str, ...]:
        """Names of the columns."""
        return tuple(self._core.names)

    def __len__(self) -> int:
        """Return the number of rows."""
        return self._core.rows

    def __contains__(self, column: object) -> bool:
        """Return whether there is such a column."""
        return column in self._core.names

    @overload
    def __getitem__(self, column: str) -> NDArray[Any]: ...

    @overload
    def __getitem__(self, column: list[str] | tuple[str, ...]) -> Table: ...

    def __getitem__(self, column: str | list[str] | tuple[str, ...]) -> NDArray[Any] | Table:
        """Return a column: numbers are a read-only view of the table's memory, NaN where null.

        For a list of names, return a table of these columns, which shares their memory.
        """
        if not isinstance(column, str):
            return Table(self._core.select([str(name) for name in column]), self._name)
        numbers = self._core.numbers(column)
        if numbers is not None:
            return np.asarray(numbers)
        return np.array(self._core.words(column), dtype=object)

    def __iter__(self) -> Iterator[dict[str, Any]]:
        """Return an iterator over the rows, each a dictionary by column name."""
        names = self.columns
        columns = [self[name].tolist() for name in names]
        for row in zip(*columns, strict=True):
            yield dict(zip(names, row, strict=True))

    def _ipython_key_completions_(self) -> list[str]:
        return list(self.columns)

    def unit(self, column: str) -> str:
        """Return the SI unit of a column, empty where it has none.

        Parameters
        ----------
        column
            Name of the column.

        Examples
        --------
        >>> import wholestring as ws
        >>> nodes = ws.Case.example().soft("drill").nodes
        >>> nodes.unit("tension_N"), nodes.unit("operation")
        ('N', '')
        """
        return self._core.unit(column)

    def meaning(self, column: str) -> str:
        """Return the description of a column, a sentence.

        Parameters
        ----------
        column
            Name of the column.

        Examples
        --------
        >>> import wholestring as ws
        >>> ws.Case.example().soft("drill").nodes.meaning("tension_N")
        'Effective tension; negative in compression'
        """
        return self._core.meaning(column)

    def to_numpy(self) -> dict[str, NDArray[Any]]:
        """Return the columns by their names; numbers are read-only views.

        Examples
        --------
        >>> import wholestring as ws
        >>> columns = ws.Case.example().soft("drill").nodes.to_numpy()
        >>> columns["md_m"].flags.writeable
        False
        """
        return {column: self[column] for column in self.columns}

    def to_polars(self) -> polars.DataFrame:
        """Return a polars data frame that shares the numbers.

        Examples
        --------
        >>> import wholestring as ws
        >>> frame = ws.Case.example().soft("drill").nodes.to_polars()
        >>> frame["md_m"].max()
        1200.0
        """
        try:
            import polars
        except ImportError as error:
            message = "to_polars needs polars: pip install polars"
            raise MissingPackageError(message) from error
        return polars.DataFrame(self)

    def to_pandas(self) -> pandas.DataFrame:
        """Return a pandas data frame that shares the numbers where pandas can.

        Examples
        --------
        >>> import wholestring as ws
        >>> frame = ws.Case.example().soft("drill").nodes.to_pandas()
        >>> float(frame["md_m"].max())
        1200.0
        """
        try:
            import pandas
        except ImportError as error:
            message = "to_pandas needs pandas: pip install pandas"
            raise MissingPackageError(message) from error
        return pandas.DataFrame(self.to_numpy(), copy=False)

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        """Return the stream of Arrow."""
        return self._core.__arrow_c_stream__(requested_schema)

    def __arrow_c_schema__(self) -> object:
        """Return the schema of Arrow."""
        return self._core.__arrow_c_schema__()

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle with its columns."""
        return _restored, (self._name, self._core.parts())

    def __repr__(self) -> str:
        """Return a summary with the size."""
        return f"<Table {self._name}: {len(self)} rows, {len(self.columns)} columns>"

    def _repr_html_(self) -> str:
        size = f"{len(self)} rows, {len(self.columns)} columns"
        return html(self, self.columns, caption=self.name, size=size, count=10)


def _restored(name: str, parts: Sequence[_core.Part]) -> Table:
    return Table(_core.Table.restore(parts), name)


def html(table: Table, names: Sequence[str], *, caption: str, size: str, count: int) -> str:
    """Return the first rows of some columns as HTML."""
    columns: list[_html.Column] = []
    for name in names:
        head = table[name][:count]
        numbers = head.dtype.kind == "f"
        cells = [_html.number(value) if numbers else str(value) for value in head.tolist()]
        hint = table.meaning(name)
        columns.append(_html.Column(title=name, cells=cells, numbers=numbers, hint=hint))
    more = f", the first {count} shown" if len(table) > count else ""
    return _html.table(columns, caption=caption, note=size + more)
