# SPDX-License-Identifier: MIT
"""Rigid registration of 3D point clouds with augmented measurements: positions, normals and tangents.

    >>> import augicp
    >>> result = augicp.align(source, target)  # (N, 3) arrays, or augicp.Cloud
    >>> if result:  # both clouds speak for the pose
    ...     print(result.T_target_source)

Lengths are in metres, angles in radians, times in seconds. ``T_target_source`` maps source coordinates into the target's
frame: ``x_in_target = T_target_source @ x_in_source``. The same input gives the same bits, for any number of threads.
Every function may be called from several Python threads at once; none holds the GIL while it works, and Ctrl-C ends each of
the long ones. What augicp raises by itself derives from ``augicp.Error``.
"""
from augicp._augicp import *  # noqa: F401,F403
from augicp._augicp import __all__, __version__  # noqa: F401
