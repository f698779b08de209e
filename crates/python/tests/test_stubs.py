"""The types that editors and checkers see: the stub of the compiled half is what it holds."""

import ast
import inspect
from pathlib import Path
from typing import Any

import wholestring as ws
from wholestring import _core

FOLDER = Path(ws.__file__).parent
STUB = ast.parse((FOLDER / "_core.pyi").read_text(encoding="utf-8"))

# What Python gives every class.
GIVEN = set(dir(type("Empty", (), {}))) | {"__new__", "__module__"}


def stub_names(body: list[ast.stmt]) -> dict[str, ast.stmt]:
    names: dict[str, ast.stmt] = {}
    for of in body:
        if isinstance(of, ast.FunctionDef | ast.ClassDef):
            names[of.name] = of
        elif isinstance(of, ast.AnnAssign) and isinstance(of.target, ast.Name):
            names[of.target.id] = of
    return names


def is_of_types_alone(of: ast.stmt) -> bool:
    """Tell whether it is a protocol or a dictionary's type, which do not exist when it runs."""
    if not isinstance(of, ast.ClassDef):
        return False
    bases = {ast.unparse(base).split("[")[0] for base in of.bases}
    return bool(bases & {"Protocol", "TypedDict"})


def there(of: Any) -> set[str]:
    return {name for name in map(str, of.__dict__) if name not in GIVEN and name != "__doc__"}


def test_the_stub_names_what_is_there_and_nothing_else() -> None:
    stub = stub_names(STUB.body)
    module = {name for name in dir(_core) if not name.startswith("__") or name == "__version__"}
    types = {name for name, of in stub.items() if is_of_types_alone(of)}
    assert set(stub) - types == module


def test_the_stub_of_each_class_is_what_it_holds() -> None:
    for name, of in stub_names(STUB.body).items():
        if not isinstance(of, ast.ClassDef) or is_of_types_alone(of):
            continue
        given = getattr(_core, name)
        said = set(stub_names(of.body)) - {"__init__", "__new__"}
        held = there(given) | (said & {"__len__"})
        assert said == held, name


def test_the_stub_has_the_parameters_that_are_there() -> None:
    classes = {
        name: of
        for name, of in stub_names(STUB.body).items()
        if isinstance(of, ast.ClassDef) and not is_of_types_alone(of)
    }
    bodies: list[tuple[Any, list[ast.stmt]]] = [(_core, STUB.body)]
    bodies += [(getattr(_core, name), of.body) for name, of in classes.items()]
    compared = 0
    for holder, body in bodies:
        for name, of in stub_names(body).items():
            if not isinstance(of, ast.FunctionDef) or name.startswith("__"):
                continue
            decorators = {ast.unparse(one) for one in of.decorator_list}
            if "property" in decorators:
                continue
            try:
                signature = inspect.signature(getattr(holder, name))
            except ValueError:
                continue
            ours = [one.arg for one in of.args.args + of.args.kwonlyargs if one.arg != "self"]
            theirs = [one for one in signature.parameters if one != "self"]
            assert ours == theirs, f"{name}: {ours} and {theirs}"
            compared += 1
    assert compared > 20


def test_the_package_says_that_it_is_typed() -> None:
    assert (FOLDER / "py.typed").is_file()
    assert (FOLDER / "_core.pyi").is_file()
