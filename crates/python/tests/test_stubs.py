"""The types for editors and checkers: the stub agrees with the compiled module."""

import ast
import inspect
from pathlib import Path
from typing import Any

import wholestring as ws
from wholestring import _core

FOLDER = Path(ws.__file__).parent
STUB = ast.parse((FOLDER / "_core.pyi").read_text(encoding="utf-8"))

# Members that every class of Python has.
GIVEN = set(dir(type("Empty", (), {}))) | {"__new__", "__module__"}


def stub_names(body: list[ast.stmt]) -> dict[str, ast.stmt]:
    names: dict[str, ast.stmt] = {}
    for statement in body:
        if isinstance(statement, ast.FunctionDef | ast.ClassDef):
            names[statement.name] = statement
        elif isinstance(statement, ast.AnnAssign) and isinstance(statement.target, ast.Name):
            names[statement.target.id] = statement
    return names


def is_of_types_alone(statement: ast.stmt) -> bool:
    """Return whether a class is a protocol or a typed dictionary, which exist only in the stub."""
    if not isinstance(statement, ast.ClassDef):
        return False
    bases = {ast.unparse(base).split("[")[0] for base in statement.bases}
    return bool(bases & {"Protocol", "TypedDict"})


def there(holder: Any) -> set[str]:
    return {name for name in map(str, holder.__dict__) if name not in GIVEN and name != "__doc__"}


def test_the_stub_names_what_is_there_and_nothing_else() -> None:
    stub = stub_names(STUB.body)
    module = {name for name in dir(_core) if not name.startswith("__") or name == "__version__"}
    types = {name for name, statement in stub.items() if is_of_types_alone(statement)}
    assert set(stub) - types == module


def test_the_stub_of_each_class_is_what_it_holds() -> None:
    for name, statement in stub_names(STUB.body).items():
        if not isinstance(statement, ast.ClassDef) or is_of_types_alone(statement):
            continue
        holder = getattr(_core, name)
        declared = set(stub_names(statement.body)) - {"__init__", "__new__"}
        held = there(holder) | (declared & {"__len__"})
        assert declared == held, name


def test_the_stub_has_the_parameters_that_are_there() -> None:
    classes = {
        name: statement
        for name, statement in stub_names(STUB.body).items()
        if isinstance(statement, ast.ClassDef) and not is_of_types_alone(statement)
    }
    bodies: list[tuple[Any, list[ast.stmt]]] = [(_core, STUB.body)]
    bodies += [(getattr(_core, name), statement.body) for name, statement in classes.items()]
    compared = 0
    for holder, body in bodies:
        for name, function in stub_names(body).items():
            if not isinstance(function, ast.FunctionDef) or name.startswith("__"):
                continue
            decorators = {ast.unparse(one) for one in function.decorator_list}
            if "property" in decorators:
                continue
            try:
                signature = inspect.signature(getattr(holder, name))
            except ValueError:
                continue
            declared = function.args.args + function.args.kwonlyargs
            ours = [one.arg for one in declared if one.arg != "self"]
            theirs = [one for one in signature.parameters if one != "self"]
            assert ours == theirs, f"{name}: {ours} and {theirs}"
            compared += 1
    assert compared > 20


def test_the_package_says_that_it_is_typed() -> None:
    assert (FOLDER / "py.typed").is_file()
    assert (FOLDER / "_core.pyi").is_file()
