# SPDX-License-Identifier: MIT
"""A registration says what it is doing, in the caller's thread; what the listener raises ends it."""
import threading

import numpy as np
import pytest

import augicp

RANDOM = np.random.default_rng(5)
CORNER = np.concatenate([np.insert(RANDOM.random((800, 2)), axis, 0.0, axis=1) for axis in range(3)])
CORNER *= [1.0, 0.8, 0.6]  # three equal sides would be ambiguous
NOWHERE = RANDOM.random((2400, 3))


def calls_of(function, *arguments, **options):
    calls = []
    result = function(*arguments, progress=lambda *call: calls.append(call), **options)
    return calls, result


@pytest.mark.parametrize("threads", [1, 2])
def test_each_stage_begins_and_ends(threads):
    calls, result = calls_of(augicp.align, CORNER + 0.01, CORNER, threads=threads)
    assert result
    assert {stage for stage, _, _ in calls} >= {"surfaces", "indexing", "aligning", "verdict", "rivals"}
    for begin, end in zip(calls[::2], calls[1::2]):
        assert begin[0] == end[0] and begin[1] + 1 == end[1] <= end[2] == begin[2]
    assert {type(part) for call in calls for part in call} == {str, int}


def test_searches_are_told_apart():
    stages = {stage for stage, _, _ in calls_of(augicp.align, NOWHERE, CORNER)[0]}
    assert {"search", "descriptors"} <= stages
    stages = {stage for stage, _, _ in calls_of(augicp.find_pose, CORNER + 0.01, CORNER)[0]}
    assert "descriptors" in stages and "search" not in stages


def test_listening_changes_nothing():
    result = calls_of(augicp.align, NOWHERE, CORNER)[1]
    assert np.array_equal(result.T_target_source, augicp.align(NOWHERE, CORNER).T_target_source)


def test_it_is_called_in_the_thread_of_the_call():
    threads = set()
    augicp.align(CORNER, CORNER, progress=lambda *call: threads.add(threading.get_ident()))
    assert threads == {threading.get_ident()}


def test_what_it_raises_ends_an_endless_call():
    def enough(stage, done, total):
        if stage == "aligning":
            raise LookupError(stage)

    with pytest.raises(LookupError, match="aligning"):
        augicp.align(CORNER, CORNER + 0.01, progress=enough, max_iterations=2**31 - 1, min_step=0.0)
    assert augicp.align(CORNER, CORNER + 0.01)


def test_what_cannot_be_called_is_refused():
    for wrong in (1, "tqdm", True):
        with pytest.raises(augicp.ArgumentTypeError, match="progress"):
            augicp.align(CORNER, CORNER, progress=wrong)


def test_the_idiom_of_tqdm():
    class Bar:
        """As much of tqdm.tqdm as the example in docs/python.md uses."""
        def __init__(self):
            self.n, self.total, self.shown = 0, None, []

        def reset(self, total):
            self.n, self.total = 0, total

        def set_description(self, text):
            self.shown.append(text)

        def update(self, n):
            self.n += n
            assert 0 <= self.n <= self.total

    bar = Bar()

    def show(stage, done, total):
        if done == 0:
            bar.set_description(stage)
            bar.reset(total)
        bar.update(done - bar.n)

    augicp.align(NOWHERE, CORNER, progress=show)
    assert "surfaces" in bar.shown and bar.n == bar.total


def test_too_much_memory_is_refused_with_advice():
    with pytest.raises(augicp.ArgumentError, match="use voxel_size [0-9.]+, or a larger max_memory_gb"):
        augicp.align(CORNER, CORNER, voxel_size=0.001, max_memory_gb=0.002)
