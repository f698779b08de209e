"""Warnings of the check of cases are issued once as Python warnings, at the user's line."""

import pickle
import warnings

import pytest
import wholestring as ws


def test_mud_as_light_as_air_is_warned_of(slant: ws.Case) -> None:
    """1.2 kg/m3 where 1.2 sg was meant: the hook load is that of a string in air."""
    with pytest.warns(ws.CaseWarning, match="density") as caught:
        light = slant.with_(mud__density=1.2)
    assert [warning.filename for warning in caught] == [__file__]
    messages = [warning.message for warning in light.warnings]
    assert messages == [str(caught[0].message).split("\n")[0]]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        # A warning is not repeated for cases made from the first.
        light.with_(friction=0.2)
        light.soft("trip_out")
        pickle.loads(pickle.dumps(light))
    with pytest.warns(ws.CaseWarning, match="density"):
        ws.Case(light.to_toml())


def test_healthy_cases_warn_of_nothing() -> None:
    from wholestring import _core

    with warnings.catch_warnings():
        warnings.simplefilter("error")
        # The moduli of the article are inconsistent, and its wells have a warning for that.
        for name in sorted(_core.EXAMPLES.keys() - {"well-b-1714", "well-b-2235"}):
            ws.Case.example(name)


def test_variations_are_warned_of_with_their_count(slant: ws.Case) -> None:
    with pytest.warns(UserWarning, match="2 of 3 cases: `density` is unusually small"):
        slant.soft_many({"mud.density": [1.2, 1.3, 1200.0]}, "trip_out")
