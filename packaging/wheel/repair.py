# SPDX-License-Identifier: MIT
"""Makes a built wheel complete: libraries that not every Linux has go into it, with their licence texts.

    repair.py WHEEL FOLDER

The platform tag is the oldest that auditwheel finds the wheel fit for. The licence texts are those of the packages that this
machine took the libraries from: Debian's, or vcpkg's where VCPKG_INSTALLED_DIR names its folder. One that is missing is an error.
"""
import importlib.metadata
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from auditwheel.wheeltools import InWheelCtx

# Libraries that are headers only leave no file in the wheel by which to find them: name, Debian's package, vcpkg's port.
HEADERS = (("Eigen", "libeigen3-dev", "eigen3"), ("nlohmann-json", "nlohmann-json3-dev", "nlohmann-json"), ("CLI11", "libcli11-dev", "cli11"))
BUNDLED = re.compile(r"(?P<name>lib[\w.+-]+?)-[0-9a-f]{8}(?P<version>\.so[\d.]*)")


def debian_package(file_name):
    """The package that has brought a file of this name, of several the first that is no -dev package."""
    found = subprocess.run(["dpkg-query", "--search", f"*/{file_name}"], capture_output=True, text=True, check=True).stdout
    packages = sorted({line.split(":")[0] for line in found.splitlines()}, key=lambda name: (name.endswith("-dev"), name))
    return packages[0]


def pybind11_licence():
    """Of the package beside which this runs, else of the system's, as when the wheel was built."""
    try:
        files = importlib.metadata.files("pybind11")
    except importlib.metadata.PackageNotFoundError:
        return debian_licence("pybind11-dev")
    return next(file for file in files if file.name == "LICENSE").read_text()


def debian_licence(package):
    return Path(f"/usr/share/doc/{package}/copyright").read_text(encoding="utf-8")


def licences(wheel_folder):
    """Texts by name: of each shared library in the wheel, and of what is compiled into it."""
    vcpkg = os.environ.get("VCPKG_INSTALLED_DIR")
    if vcpkg:
        texts = {file.parent.name: file.read_text(encoding="utf-8") for file in Path(vcpkg).glob("*/share/*/copyright")}
        missing = [port for _, _, port in HEADERS if port not in texts]
        if missing:
            sys.exit(f"{vcpkg} lacks the licences of {', '.join(missing)}")
    else:
        texts = {name: debian_licence(package) for name, package, _ in HEADERS}
        for file in wheel_folder.glob("*.libs/*"):
            library = BUNDLED.fullmatch(file.name)
            texts[library["name"]] = debian_licence(debian_package(library["name"] + library["version"]))
    return texts | {"pybind11": pybind11_licence()}


def add_licences(repaired, output):
    with InWheelCtx(repaired) as wheel:
        folder = Path(wheel.path)
        (dist_info,) = folder.glob("*.dist-info")
        bundled = dist_info / "licenses/bundled"
        bundled.mkdir(parents=True)
        texts = sorted(licences(folder).items())
        for name, text in texts:
            (bundled / f"{name}.txt").write_text(text, encoding="utf-8")
        metadata = dist_info / "METADATA"
        lines = "".join(f"License-File: bundled/{name}.txt\n" for name, _ in texts)
        own = "License-File: LICENSE\n"
        metadata.write_text(metadata.read_text(encoding="utf-8").replace(own, own + lines, 1), encoding="utf-8")
        wheel.out_wheel = output / repaired.name  # nothing is written where the lines above fail


def main():
    wheel, output = (Path(word).resolve() for word in sys.argv[1:])
    output.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, "-m", "auditwheel", "repair", "--wheel-dir", folder, wheel], check=True)
        (repaired,) = Path(folder).glob("*.whl")
        add_licences(repaired, output)
        print(output / repaired.name)


if __name__ == "__main__":
    main()
