# SPDX-License-Identifier: MIT
"""Rigid registration of 3D point clouds with augmented measurements: positions, normals and tangents.

    >>> import augicp
    >>> result = augicp.align(source, target)  # (N, 3) arrays, or augicp.Cloud
    >>> if result:  # both clouds support the pose
    ...     print(result.T_target_source)

Lengths are in metres, angles in radians, times in seconds. ``T_target_source`` maps source coordinates into the target's
frame: ``x_in_target = T_target_source @ x_in_source``. The same input gives bit-identical results, for any number of
threads. Every function may be called from several Python threads at once and releases the GIL while it works. Ctrl-C ends
the long ones. Exceptions of augicp derive from ``augicp.Error``.
"""
from augicp import _numpy, _others

_numpy.check()
from augicp._augicp import *  # noqa: E402,F401,F403
from augicp._augicp import __all__, __version__  # noqa: E402,F401

_others.teach(Result, Cloud)  # noqa: F405


def __getattr__(name):
    raise _others.of_module(name)
