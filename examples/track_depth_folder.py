# SPDX-License-Identifier: MIT
# %% [markdown]
# # Track a depth camera through a folder of images
# Thirty images of the TUM RGB-D benchmark's fr1/desk, a second of a hand-held camera, compared with the true trajectory.
#
#     PYTHONPATH=build/release/python /usr/bin/python3 examples/track_depth_folder.py
#
# The file is a notebook too: editors that support "# %%" cells, and jupytext, open it as one.

# %%
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import augicp

DATA = Path(__file__).parent.parent / "data" if "__file__" in globals() else Path("data")

# %% [markdown]
# Add the images one after the other. `add` returns the pose of the camera in the frame of the first image, or None if there
# is none; `last_frame` has the report.

# %%
sequence = augicp.read_depth_sequence(DATA / "tum_fr1_desk_30")
odometry = augicp.Odometry("tum-fr1")
for stamp, path in sequence.frames:
    T_world_camera = odometry.add(augicp.read_depth(path, sequence.depth_scale), stamp)
    if not odometry.last_frame:
        print(f"{path.name}: {odometry.last_frame}")
print(odometry.trajectory, "last pose:", np.round(odometry.trajectory.poses[-1], 3), sep="\n")

# %%
assert sequence.truth is not None
evaluation = augicp.evaluate(odometry.trajectory, sequence.truth)
assert evaluation.aligned is not None and evaluation.relative is not None
ate, rpe = evaluation.aligned.translation, evaluation.relative
print(f"ATE {1000 * ate.rmse:.1f} mm; RPE {1000 * rpe.translation.rmse:.1f} mm and "
      f"{np.degrees(rpe.rotation.rmse):.2f} degrees a frame")

# %% [markdown]
# The alignment of the evaluation moves the estimate onto the truth.

# %%
inside = (sequence.truth.stamps >= evaluation.first_stamp - 0.01) & (sequence.truth.stamps <= evaluation.last_stamp + 0.01)
truth = sequence.truth.poses[inside, :3, 3]
estimate = (evaluation.T_truth_estimate @ odometry.trajectory.poses)[:, :3, 3]

figure, (top, side) = plt.subplots(1, 2, figsize=(10, 4.5), constrained_layout=True)
for axes, (across, up) in ((top, (0, 1)), (side, (0, 2))):
    axes.plot(truth[:, across], truth[:, up], color="0.6", linewidth=4, label="truth")
    axes.plot(estimate[:, across], estimate[:, up], color="#0072B2", marker=".", label="augicp")
    axes.set_xlabel(f"{'xyz'[across]}, m")
    axes.set_ylabel(f"{'xyz'[up]}, m")
    axes.set_aspect("equal", adjustable="datalim")
    axes.grid(alpha=0.3)
top.set_title("from above")
side.set_title("from the side")
top.legend()
figure.suptitle(f"fr1/desk, {len(estimate)} frames: ATE {1000 * ate.rmse:.1f} mm")
figure.savefig("trajectory.png", dpi=120)
print("trajectory.png has the picture")
