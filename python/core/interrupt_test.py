# SPDX-License-Identifier: MIT
"""Ctrl-C ends what would go on for ever, with the exception of Python's own handler, and everything works afterwards."""
import os
import signal
import subprocess
import sys
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
    corner *= [1.0, 0.8, 0.6]  # three equal sides would be ambiguous
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


def test_nobody_waits_for_a_long_stage(tmp_path):
    """The exception comes while the work still runs. Later calls work, and Python ends with that work left behind."""
    (tmp_path / "long.xyz").write_text("0.25 0.5 0.75\n1.5 2.5 3.5\n" * 1_000_000)
    code = """
import os, signal, sys, threading
import augicp
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell that starts this in the background leaves it ignored
tasks = lambda: set(os.listdir("/proc/self/task"))
def send():
    others = tasks()
    ready.set()
    while tasks() <= others:
        pass
    os.kill(os.getpid(), signal.SIGINT)
ready = threading.Event()
sender = threading.Thread(target=send)
sender.start()
ready.wait()
before = tasks() - {str(sender.native_id)}
try:
    augicp.read(sys.argv[1])
except KeyboardInterrupt:
    print(len(tasks() - before - {str(sender.native_id)}))
assert len(augicp.read(sys.argv[1])) == 2_000_000
"""
    finished = subprocess.run([sys.executable, "-c", code, tmp_path / "long.xyz"], capture_output=True, text=True, check=False)
    assert (finished.returncode, finished.stdout) == (0, "1\n"), finished.stderr


def test_odometry_stays_as_it_was(interrupt):
    odometry = augicp.Odometry("tum-fr1", **ENDLESS)
    first, second = (augicp.read_depth(path, 5000) for path in IMAGES)
    assert odometry.add(first, 0.0) is not None
    interrupt()
    with pytest.raises(KeyboardInterrupt):
        odometry.add(second, 1 / 30)
    assert odometry.last_frame.stamp == 0.0
    assert len(odometry.trajectory) == 1
