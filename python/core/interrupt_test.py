# SPDX-License-Identifier: MIT
"""Ctrl-C ends what would go on for ever, with the exception of Python's own handler, and everything works afterwards."""
import os
import signal
import threading

import numpy as np
import pytest

import augicp
from conftest import IMAGES

ENDLESS = {"max_iterations": 2**31 - 1, "min_step": 0.0}


@pytest.fixture
def interrupt():
    """Sends SIGINT once the call under test has started its thread. Handlers are Python's own meanwhile."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    threads = []

    def soon():
        ready = threading.Event()

        def wait_and_send():
            # By their names: threads of the call before may still be ending, so their number tells nothing.
            idle = set(os.listdir("/proc/self/task"))
            ready.set()
            while set(os.listdir("/proc/self/task")) <= idle:
                pass
            os.kill(os.getpid(), signal.SIGINT)

        threads.append(threading.Thread(target=wait_and_send, daemon=True))
        threads[-1].start()
        ready.wait()

    yield soon
    for thread in threads:
        thread.join()
    signal.signal(signal.SIGINT, before)


@pytest.fixture(scope="module")
def clouds():
    random = np.random.default_rng(2)
    corner = np.concatenate([np.insert(random.random((500, 2)), axis, 0.0, axis=1) for axis in range(3)])
    return augicp.Cloud(corner), augicp.Cloud(corner + 0.01)


@pytest.mark.parametrize("threads", [0, 1])
def test_align(interrupt, clouds, threads):
    interrupt()
    with pytest.raises(KeyboardInterrupt):
        augicp.align(*clouds, threads=threads, **ENDLESS)
    assert augicp.align(*clouds, threads=threads)


def test_what_a_handler_raises_comes_out(interrupt, clouds):
    def handler(number, frame):
        raise ArithmeticError("from the handler")

    signal.signal(signal.SIGINT, handler)
    interrupt()
    with pytest.raises(ArithmeticError, match="from the handler"):
        augicp.align(*clouds, **ENDLESS)


def test_a_handler_that_raises_nothing_ends_nothing(interrupt, clouds):
    calls = []
    signal.signal(signal.SIGINT, lambda number, frame: calls.append(number))
    interrupt()
    assert augicp.align(*clouds, max_iterations=300, min_step=0.0).iterations == 300
    # It may still be on its way where the loop was quicker than the signal.
    while not calls:
        pass
    assert calls == [signal.SIGINT]


def test_odometry_stays_as_it_was(interrupt):
    odometry = augicp.Odometry("tum-fr1", **ENDLESS)
    first, second = (augicp.read_depth(path, 5000) for path in IMAGES)
    assert odometry.add(first, 0.0) is not None
    interrupt()
    with pytest.raises(KeyboardInterrupt):
        odometry.add(second, 1 / 30)
    assert odometry.last_frame.stamp == 0.0
    assert len(odometry.trajectory) == 1
