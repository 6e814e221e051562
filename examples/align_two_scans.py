# SPDX-License-Identifier: MIT
# %% [markdown]
# # Align two scans
# Two scans of a room, taken from different places. Where was the second scanner, seen from the first?
#
#     PYTHONPATH=build/release/python /usr/bin/python3 examples/align_two_scans.py
#
# The file is a notebook too: editors that support "# %%" cells, and jupytext, open it as one.

# %%
from pathlib import Path

import numpy as np

import augicp

DATA = Path(__file__).parent.parent / "data/room_pair" if "__file__" in globals() else Path("data/room_pair")

# %% [markdown]
# `read` gives a Cloud; an (N, 3) array works too. `T_target_source` maps source coordinates into the target's frame.

# %%
source, target = augicp.read(DATA / "source.ply"), augicp.read(DATA / "target.ply")
result = augicp.align(source, target)
print(source, target, result, sep="\n")
print(np.round(result.T_target_source, 4))

# %% [markdown]
# A result is true only if both clouds support the pose. `evidence` has the comparison of the clouds. `covariance` has the
# uncertainty of the pose; its first three numbers belong to the translation. A result that is false may have neither.

# %%
if not result:
    raise SystemExit(f"not to be trusted: {result.status}, {[str(doubt) for doubt in result.doubts]}")
assert result.evidence is not None and result.covariance is not None
print(f"agreeing: {result.evidence.source_in_target.agreeing:.1%} and {result.evidence.target_in_source.agreeing:.1%}")
print("standard deviations, mm:", np.round(1000 * np.sqrt(np.diag(result.covariance)[:3]), 2))

# %% [markdown]
# The pair is generated, so the true motion is known.

# %%
truth = augicp.read_transform(DATA / "T_target_source.txt")
off = np.linalg.inv(truth) @ result.T_target_source
angle = np.degrees(np.arccos(np.clip((np.trace(off[:3, :3]) - 1) / 2, -1, 1)))
print(f"off by {1000 * np.linalg.norm(off[:3, 3]):.1f} mm and {angle:.2f} degrees")

# %% [markdown]
# A wall alone does not constrain three of the six motions. The status is `degenerate`, and `free_motions` names them.

# %%
wall = np.random.default_rng(0).random((5000, 3)) * [2, 2, 0.001]
flat = augicp.align(wall, wall + [0, 0, 0.05])
print(flat.status, [str(motion.kind) for motion in flat.free_motions])

# %%
moved = source.transformed(result.T_target_source)
augicp.write("moved.ply", moved)
print("moved.ply is aligned with the target")
