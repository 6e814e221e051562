# SPDX-License-Identifier: MIT
"""Whether the recipes under packaging/ can be read by what reads them, and say the version of VERSION.

    packaging_test.py PROJECT

Tools that are not installed (nix, ruby, conan) are named in the output, and only what they would read is left out.
"""
import ast
import json
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree
from pathlib import Path

PROJECT = Path(sys.argv[1])
PACKAGING = PROJECT / "packaging"
VERSION = (PROJECT / "VERSION").read_text(encoding="utf-8").strip()


# What each recipe calls the libraries that the project's CMakeLists.txt finds.
LIBRARY_NAMES = {"Eigen3": "eigen", "TBB": "tbb", "fmt": "fmt", "nlohmann_json": "nlohmann[-_]json", "liblzf": "lzf", "spng": "spng", "SQLite3": "sqlite",
                 "lz4": "lz4", "zstd": "zstd", "BZip2": "bz(ip)?2", "ZLIB": "zlib"}
# package.xml is not among them: ROS has no names for liblzf and libspng.
RECIPES = ("packaging/conan/conanfile.py", "packaging/conda/recipe.yaml", "packaging/debian/control", "packaging/homebrew/augicp.rb",
           "packaging/nix/default.nix", "packaging/vcpkg/augicp/vcpkg.json", "packaging/wheel/install-libraries", "scripts/install-dependencies")


def libraries():
    """The packages that CMakeLists.txt finds, but for those of the tests."""
    text = (PROJECT / "CMakeLists.txt").read_text(encoding="utf-8").split("if(AUGICP_BUILD_TESTS)")[0]
    found = re.findall(r"find_package\((\w+)", text)
    for names in re.findall(r"foreach\(compression ([\w ]+)\)", text):
        found += names.split()
    return found


def dependencies_text(recipe):
    """Without comments, and of Conan's recipe the requirements alone: it names libraries elsewhere too."""
    text = re.sub(r"^\s*#.*$", "", (PROJECT / recipe).read_text(encoding="utf-8"), flags=re.MULTILINE)
    return re.search(r"requires = \((.*?)\)\n", text, re.DOTALL)[1] if recipe.endswith("conanfile.py") else text


def lacking():
    for name in libraries():
        for recipe in RECIPES:
            if not re.search(rf"(?<![a-z])(lib|one)?{LIBRARY_NAMES[name]}", dependencies_text(recipe)):
                yield f"{recipe} lacks {name}, which CMakeLists.txt finds"


def versions():
    """Where each recipe that cannot read VERSION has the version."""
    port = json.loads((PACKAGING / "vcpkg/augicp/vcpkg.json").read_text(encoding="utf-8"))
    yield "vcpkg.json", port["version"]
    recipe = (PACKAGING / "conda/recipe.yaml").read_text(encoding="utf-8")
    yield "recipe.yaml", re.search(r'^  version: "(.*)"$', recipe, re.MULTILINE)[1]
    manifest = xml.etree.ElementTree.parse(PROJECT / "package.xml").getroot()
    yield "package.xml", manifest.findtext("version")
    yield "debian/changelog", re.match(r"augicp \(([\d.]+)-\d+\)", (PACKAGING / "debian/changelog").read_text(encoding="utf-8"))[1]


def unknown_options():
    """Options of the project that a recipe sets, and that no CMake file of it has."""
    known = "".join(file.read_text(encoding="utf-8") for file in [PROJECT / "CMakeLists.txt", *(PROJECT / "cmake").glob("*.cmake")])
    for recipe in (*RECIPES, "packaging/debian/rules", "packaging/vcpkg/augicp/portfile.cmake", "colcon.pkg", "pyproject.toml"):
        text = (PROJECT / recipe).read_text(encoding="utf-8")
        for name in sorted(set(re.findall(r"-D(AUGICP_[A-Z_]+)|\b(AUGICP_[A-Z_]+) = ", text))):
            name = "".join(name)
            if not re.search(rf"(option|set)\({name}\b", known):
                yield f"{recipe} sets {name}, which no CMake file has"


def library_package():
    """Debian names the package of a shared library by its soname: libaugicp.so.MAJOR.MINOR, below 1.0."""
    return "libaugicp" + ".".join(VERSION.split(".")[:2])


def commands():
    yield ["zsh", "-n", PACKAGING / "completion/augicp.zsh"]
    yield ["fish", "--no-execute", PACKAGING / "completion/augicp.fish"]
    for script in ("completion/augicp.bash", "empty_debian.sh", "wheel/install-libraries", "wheel/try_in_empty_debian"):
        yield ["bash", "-n", PACKAGING / script]
    for script in ("wheel", "package", "portability"):
        yield ["bash", "-n", PROJECT / "scripts" / script]
    for test in (PACKAGING / "debian/tests").iterdir():
        if test.name != "control":
            yield ["sh", "-n", test]
    yield ["ruby", "-c", PACKAGING / "homebrew/augicp.rb"]
    yield ["nix-instantiate", "--parse", PACKAGING / "nix/default.nix"]
    yield ["conan", "inspect", PACKAGING / "conan"]


def main():
    wrong = [f"{place} has version {version}, VERSION has {VERSION}" for place, version in versions() if version != VERSION] + list(lacking()) + list(unknown_options())
    json.loads((PROJECT / "colcon.pkg").read_text(encoding="utf-8"))
    if f"Package: {library_package()}\n" not in (PACKAGING / "debian/control").read_text(encoding="utf-8"):
        wrong.append(f"debian/control has no package {library_package()}")
    for file in PACKAGING.rglob("*.py"):
        ast.parse(file.read_text(encoding="utf-8"), str(file))
    for command in commands():
        if not shutil.which(command[0]):
            print(f"not read, {command[0]} is not installed: {command[-1].relative_to(PROJECT)}")
            continue
        finished = subprocess.run(command, capture_output=True, text=True, check=False)
        if finished.returncode != 0:
            wrong.append(f"{command[-1].relative_to(PROJECT)}: {finished.stderr.strip()}")
    print(*(wrong or ["the recipes can be read, have one version, and name every library"]), sep="\n")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
