# SPDX-License-Identifier: MIT
"""What `conan create` tries of the package: the program of tests/consumer compiles against it and runs."""
from pathlib import Path

from conan import ConanFile
from conan.tools.build import can_run
from conan.tools.cmake import CMake, cmake_layout

CONSUMER = Path(__file__).resolve().parents[3] / "tests/consumer"


class Consumer(ConanFile):
    settings = "os", "compiler", "build_type", "arch"
    generators = "CMakeDeps", "CMakeToolchain"
    test_type = "explicit"

    def requirements(self):
        self.requires(self.tested_reference_str)

    def layout(self):
        cmake_layout(self)

    def build(self):
        cmake = CMake(self)
        cmake.configure(build_script_folder=CONSUMER)
        cmake.build()

    def test(self):
        if can_run(self):
            self.run(f"\"{Path(self.build_folder, self.cpp.build.bindir, 'consumer').resolve()}\"", env="conanrun")
