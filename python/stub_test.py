# SPDX-License-Identifier: MIT
"""The package as editors see it: every name has a docstring, and the stubs agree with the module, with one set of defaults."""
import ast
import enum
import inspect
import re
from pathlib import Path

import pytest

import augicp
from conftest import ROOM, PROJECT, command_json

STUBS = {node.name: node for node in ast.parse((Path(augicp.__file__).parent / "__init__.pyi").read_text()).body
         if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
FUNCTIONS = {"align": "align", "find_pose": "align", "estimate_surface": "align", "Odometry": "odometry",
             "LidarOdometry": "lidar_odometry", "evaluate": "evaluate"}


def members(cls):
    return {name: vars(cls)[name] for name in vars(cls) if not name.startswith("_")}


def stub_members(node):
    return {child.name: child for child in node.body if isinstance(child, ast.FunctionDef)}


def names(function):
    """Of the parameters that inspect.signature() finds, and of those that are keywords alone."""
    found = [p for p in inspect.signature(function).parameters.values() if p.name != "self"]
    keywords = {p.name for p in found if p.kind is p.KEYWORD_ONLY}
    return [p.name for p in found if p.name not in keywords], keywords


def stub_names(node):
    return [arg.arg for arg in node.args.args if arg.arg != "self"], {arg.arg for arg in node.args.kwonlyargs}


def test_the_same_names():
    assert set(STUBS) == set(augicp.__all__)
    assert {name for name in dir(augicp) if not name.startswith("_")} == set(augicp.__all__)


@pytest.mark.parametrize("name", sorted(STUBS))
def test_docstrings_and_signatures(name):
    real, stub = getattr(augicp, name), STUBS[name]
    assert real.__doc__ and len(real.__doc__.strip()) > 10
    if isinstance(stub, ast.FunctionDef):
        assert names(real) == stub_names(stub)
        return
    if issubclass(real, enum.Enum):
        assert {child.targets[0].id: child.value.value for child in stub.body} == {m.name: m.value for m in real}
        assert all(str(member) == member.value for member in real)
        return
    assert {base.id for base in stub.bases} == {base.__name__ for base in real.__bases__} - {"pybind11_object"}
    stubs = stub_members(stub)
    assert set(members(real)) == {child for child in stubs if not child.startswith("__")}
    for child, member in members(real).items():
        assert member.__doc__, f"{name}.{child}"
        is_property = any(isinstance(d, ast.Name) and d.id == "property" for d in stubs[child].decorator_list)
        assert is_property == isinstance(member, property), child
        if not is_property:
            function = getattr(real, child)
            assert names(function) == stub_names(stubs[child]), child
    if "__init__" in stubs:
        assert names(real) == names(real.__init__) == stub_names(stubs["__init__"])


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_option_is_a_keyword_of_the_stub(name):
    stub = STUBS[name] if isinstance(STUBS[name], ast.FunctionDef) else stub_members(STUBS[name])["__init__"]
    others, keywords = stub_names(stub)
    defaults = augicp.default_options(FUNCTIONS[name])
    assert keywords <= set(defaults) <= keywords | set(others)
    found = inspect.signature(getattr(augicp, name)).parameters
    assert {option: found[option].default for option in defaults} == defaults
    doc = augicp.align.__doc__ if name in ("align", "find_pose", "estimate_surface") else getattr(augicp, name).__doc__ + augicp.align.__doc__
    assert all(option in doc for option in augicp.default_options(FUNCTIONS[name])), name


def test_stubs_repeat_no_default_of_the_library():
    for node in ast.walk(ast.Module(list(STUBS.values()), [])):
        if isinstance(node, ast.FunctionDef):
            for default in [*node.args.defaults, *node.args.kw_defaults]:
                assert default is None or default.value in (None, ...), node.name


def test_defaults_are_the_command_s():
    told = command_json("align", ROOM / "source.ply", ROOM / "target.ply", "--json", "-")["options"]
    defaults = augicp.default_options()
    told["max_angle"] = told.pop("max_angle_deg")
    told["global_"] = told.pop("global")  # a reserved word in Python
    assert told.keys() == defaults.keys()
    assert round(defaults.pop("max_angle") * 180 / 3.141592653589793, 9) == round(told.pop("max_angle"), 9)
    assert {name: defaults[name] for name in told if defaults[name] is not None} == \
        {name: value for name, value in told.items() if defaults[name] is not None}
    used = augicp.align(augicp.read(ROOM / "source.ply"), augicp.read(ROOM / "target.ply")).options
    assert {name: used[name] for name in told} == told


def test_unknown_defaults_are_refused():
    with pytest.raises(augicp.ArgumentError, match="align, odometry, lidar_odometry or evaluate"):
        augicp.default_options("x")


def test_the_version_is_the_project_s():
    assert augicp.__version__ == (PROJECT / "VERSION").read_text().strip()


@pytest.mark.skipif(not (PROJECT / "pyproject.toml").exists(), reason="the sources are not beside the tests")
def test_pyproject_is_sound():
    tomllib = pytest.importorskip("tomllib")
    project = tomllib.loads((PROJECT / "pyproject.toml").read_text())
    assert project["project"]["name"] == "augicp" and "version" in project["project"]["dynamic"]
    source = project["tool"]["scikit-build"]["metadata"]["version"]
    version = re.search(source["regex"], (PROJECT / source["input"]).read_text())["value"]
    assert version == augicp.__version__
    assert (PROJECT / project["project"]["readme"]).exists()
    own = [name for name in project["tool"]["scikit-build"]["cmake"]["define"] if name.startswith("AUGICP_")]
    assert own
    settings = "".join(file.read_text() for file in [PROJECT / "CMakeLists.txt", *(PROJECT / "cmake").glob("*.cmake")])
    for name in own:
        assert name in settings, name


def test_help_can_be_read():
    assert "T_target_source" in inspect.getdoc(augicp.align) and "Ctrl-C" in augicp.__doc__
