# SPDX-License-Identifier: MIT
"""Conan 2 recipe of the tree that it lies in: `conan create packaging/conan`."""
from pathlib import Path

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy

ROOT = Path(__file__).resolve().parents[2]
PARTS = ("CMakeLists.txt", "VERSION", "LICENSE", "apps/*", "cmake/*", "src/*")


class Augicp(ConanFile):
    name = "augicp"
    description = "Rigid registration of 3D point clouds with augmented measurements"
    license = "MIT"
    package_type = "library"
    settings = "os", "compiler", "build_type", "arch"
    options = {"shared": [True, False], "fPIC": [True, False]}
    default_options = {"shared": False, "fPIC": True}
    requires = ("bzip2/[>=1.0.8 <2]", "eigen/[>=3.4 <4]", "fmt/[>=9]", "libspng/[>=0.7]", "lz4/[>=1.9 <2]", "lzf/[>=3.6]", "nlohmann_json/[>=3.11]",
                "onetbb/[>=2021.8]", "sqlite3/[>=3.40 <4]", "zlib/[>=1.2.11 <2]", "zstd/[>=1.5 <2]")

    def set_version(self):
        self.version = (ROOT / "VERSION").read_text(encoding="utf-8").strip()

    def export_sources(self):
        for part in PARTS:
            copy(self, part, ROOT, self.export_sources_folder, excludes="*/node_modules/*")

    def layout(self):
        cmake_layout(self)

    def generate(self):
        dependencies = CMakeDeps(self)
        # The names by which CMakeLists.txt asks for them.
        dependencies.set_property("lzf", "cmake_file_name", "liblzf")
        dependencies.set_property("lzf", "cmake_target_name", "liblzf::liblzf")
        dependencies.generate()
        toolchain = CMakeToolchain(self)
        for part in ("TESTS", "EXAMPLES", "PYTHON", "APPS"):
            toolchain.cache_variables[f"AUGICP_BUILD_{part}"] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build(target="augicp")

    def package(self):
        CMake(self).install(component="development")
        copy(self, "LICENSE", self.source_folder, Path(self.package_folder) / "licenses")

    def package_info(self):
        # The library's own CMake package, which knows what else must be linked.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = [str(Path("lib/cmake/augicp"))]
