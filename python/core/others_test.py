# SPDX-License-Identifier: MIT
"""Names of other libraries end in an error that says what stands for them here, and that exists."""
import copy
import pickle
import re

import pytest

import augicp
from augicp import _others
from conftest import ROOM


@pytest.mark.parametrize("name", sorted(_others._IN_MODULE))
def test_names_of_modules_lead_to_functions(name):
    with pytest.raises(AttributeError, match="use augicp") as found:
        getattr(augicp, name)
    function = re.search(r"use augicp\.(\w+)", str(found.value))[1]
    assert function in augicp.__all__


def test_members_lead_to_members():
    result = augicp.align(ROOM / "source.ply", ROOM / "target.ply", search=False)
    for value in (result, augicp.read(ROOM / "source.ply")):
        for name, ours in _others._IN_CLASS[type(value).__name__].items():
            assert not hasattr(value, name)
            with pytest.raises(AttributeError, match="here it is " + re.escape(ours)):
                getattr(value, name)
            word = re.match(r"(augicp\.)?(\w+)", ours)
            assert hasattr(augicp if word[1] else value, word[2])
        assert not hasattr(value, "nonsense")
        assert repr(copy.copy(value)) == repr(pickle.loads(pickle.dumps(value)))


@pytest.mark.parametrize("given, meant", [("init", "initial"), ("trans_init", "initial"), ("leaf_size", "voxel_size"),
                                          ("estimation_method", "method"), ("max_correspondence_distance", "max_distance")])
def test_options_lead_to_options(given, meant):
    with pytest.raises(TypeError, match=f"did you mean {meant}"):
        augicp.align(ROOM / "source.ply", ROOM / "target.ply", **{given: 1})


def test_no_guess_is_offered_where_none_is_taken():
    with pytest.raises(TypeError) as found:
        augicp.LidarOdometry(init=1)
    assert "initial" not in str(found.value)
