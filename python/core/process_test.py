# SPDX-License-Identifier: MIT
"""Pools of processes, which many use: forked ones, after the parent has worked with all its threads, and fresh ones."""
import multiprocessing

import pytest

import augicp


def pose(clouds):
    return augicp.align(*clouds).T_target_source.tolist()


@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_children_give_the_same_bits(method, small):
    clouds = augicp.Cloud(small[0]), augicp.Cloud(small[1])
    expected = pose(clouds)
    with multiprocessing.get_context(method).Pool(2) as pool:
        assert pool.map_async(pose, [clouds] * 4).get(timeout=120) == [expected] * 4
