# SPDX-License-Identifier: MIT
"""A NumPy whose arrays would be read wrongly is refused when augicp is imported."""
import numpy as np
import pytest

from augicp import _numpy


@pytest.mark.parametrize("numpy, pybind11", [("2.0.0", "2.10.3"), ("2.4.6", "2.11.1"), ("3.0.0rc1", "2.9.0")])
def test_numpy_2_needs_pybind11_2_12(numpy, pybind11):
    with pytest.raises(ImportError, match=f"pybind11 {pybind11}.*NumPy {numpy}.*numpy<2"):
        _numpy.require_readable(numpy, pybind11)


@pytest.mark.parametrize("numpy, pybind11", [("1.24.2", "2.10.3"), ("1.26.4", "3.0.1"), ("2.0.0", "2.12.0"), ("2.4.6", "3.0.1"), (None, "2.10.3")])
def test_others_fit(numpy, pybind11):
    _numpy.require_readable(numpy, pybind11)


def test_the_versions_here_are_known():
    assert _numpy.installed() == np.__version__
    assert all(part.isdigit() for part in _numpy.PYBIND11.split(".")[:2])
    _numpy.check()
