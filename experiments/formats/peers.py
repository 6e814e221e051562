# SPDX-License-Identifier: MIT
"""Which files augicp, Open3D, PCL's tools and KISS-ICP read: a cloud in each format, and public files, read by each.

    PYTHONPATH=build/release/python python experiments/formats/peers.py PUBLIC_FILES [FILE...]

with open3d, kiss-icp, rosbags, mcap-ros2-support and laspy[lazrs] of PyPI, and Debian's pcl-tools.

PUBLIC_FILES: a folder with las/, e57/ and rosbag1/ of laspy, libE57Format and foxglove. Each cell is "yes" if all positions
come back to within a thousandth of the extent, or what happens instead. A program that is not there gives "not tried".
"""
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests"))
from bag_test import point_cloud2, stamp_ns  # noqa: E402

POINTS = (np.random.default_rng(27).uniform(-4, 4, (500, 3)) + [5, 0, 0]).astype(np.float32)
COLUMNS = np.column_stack([POINTS, np.linspace(0, 1, len(POINTS), dtype=np.float32)])
SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], np.float32)


def ply(encoding, kind="float"):
    head = f"ply\nformat {encoding} 1.0\nelement vertex {len(POINTS)}\n" + "".join(f"property {kind} {axis}\n" for axis in "xyz") + "end_header\n"
    if encoding == "ascii":
        return head.encode() + "".join("%.9g %.9g %.9g\n" % tuple(p) for p in POINTS).encode()
    return head.encode() + POINTS.astype((">" if "big" in encoding else "<") + ("f8" if kind == "double" else "f4")).tobytes()


def pcd(data, size=4):
    head = (f"VERSION 0.7\nFIELDS x y z\nSIZE {size} {size} {size}\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {len(POINTS)}\nHEIGHT 1\n"
            f"VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {len(POINTS)}\nDATA {data}\n")
    body = "".join("%.9g %.9g %.9g\n" % tuple(p) for p in POINTS).encode() if data == "ascii" else POINTS.astype(f"<f{size}").tobytes()
    return head.encode() + body


def text(separator, header=""):
    return (header + "".join(separator.join("%.9g" % value for value in row) + "\n" for row in POINTS)).encode()


def stl():
    triangles = [SQUARE[[0, 1, 2]], SQUARE[[0, 2, 3]]]
    return bytes(80) + struct.pack("<I", 2) + b"".join(struct.pack("<12fH", 0, 0, 1, *t.ravel(), 0) for t in triangles)


def obj():
    return "".join("v %g %g %g\n" % tuple(p) for p in SQUARE).encode() + b"f 1 2 3\nf 1 3 4\n"


def npy():
    with tempfile.NamedTemporaryFile(suffix=".npy") as file:
        np.save(file.name, POINTS)
        return Path(file.name).read_bytes()


def write_recordings(folder):
    """By rosbags: a bag of ROS 1, a folder of rosbag2 with SQLite's files, and one with MCAP. Paths as KISS-ICP takes them."""
    from rosbags import rosbag1, rosbag2
    from rosbags.typesys import Stores, get_typestore
    kind = "sensor_msgs/msg/PointCloud2"
    messages = [point_cloud2(is_cdr, 0, COLUMNS) for is_cdr in (False, True)]
    with rosbag1.Writer(folder / "rosbag1.bag") as writer:
        topic = writer.add_connection("/points", kind, typestore=get_typestore(Stores.ROS1_NOETIC))
        writer.write(topic, stamp_ns(0), messages[0])
    for name, storage in (("rosbag2", rosbag2.StoragePlugin.SQLITE3), ("rosbag2_mcap", rosbag2.StoragePlugin.MCAP)):
        with rosbag2.Writer(folder / name, version=9, storage_plugin=storage) as writer:
            topic = writer.add_connection("/points", kind, typestore=get_typestore(Stores.ROS2_HUMBLE))
            writer.write(topic, stamp_ns(0), messages[1])
    return [folder / "rosbag1.bag", folder / "rosbag2", folder / "rosbag2_mcap/rosbag2_mcap.mcap"]


def own_files():
    """Name of the file: its bytes."""
    return {"ascii.ply": ply("ascii"), "little.ply": ply("binary_little_endian"), "big.ply": ply("binary_big_endian"),
            "double.ply": ply("binary_little_endian", "double"), "ascii.pcd": pcd("ascii"), "binary.pcd": pcd("binary"),
            "double.pcd": pcd("binary", 8), "blanks.xyz": text(" "), "header.csv": text(",", "x,y,z\n"),
            "semicolons.csv": text(";", "x;y;z\n"), "blanks.pts": str(len(POINTS)).encode() + b"\n" + text(" "),
            "kitti.bin": COLUMNS.astype("<f4").tobytes(), "array.npy": npy(), "mesh.stl": stl(), "mesh.obj": obj()}


PUBLIC = ("las/simple1_4.las", "las/extrabytes.las", "las/autzen_trim.laz", "e57/ColouredCubeDouble.e57")


def expected_of(path):
    """Positions, or nothing where only the number of points is known to be above 0."""
    if path.suffix in (".las", ".laz"):
        import laspy
        return np.asarray(laspy.read(path).xyz)
    return None if path.suffix in (".e57", ".stl", ".obj") else POINTS


def verdict(found, path):
    expected, found = expected_of(path), np.asarray(found, float).reshape(-1, 3)
    if len(found) == 0:
        return "no: no points"
    if expected is None:
        return "yes"
    if len(found) != len(expected):
        return f"no: {len(found)} of {len(expected)} points"
    extent = np.ptp(expected, axis=0).max()
    return "yes" if np.abs(found - expected).max() < 1e-3 * extent else "no: other positions"


def by_augicp(path):
    import augicp
    name = f"{path}#0" if path.suffix in (".bag", ".mcap") or path.is_dir() else path
    return augicp.read(name).points


def by_open3d(path):
    import open3d
    open3d.utility.set_verbosity_level(open3d.utility.VerbosityLevel.Error)
    if path.suffix in (".stl", ".obj"):
        return open3d.io.read_triangle_mesh(str(path)).vertices
    return open3d.io.read_point_cloud(str(path)).points


def by_pcl(path):
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder, "out.pcd")
        command = ["pcl_xyz2pcd", path, out] if path.suffix == ".xyz" else ["pcl_converter", "-f", "ascii", path, out]
        finished = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=60)
        if not out.exists():
            words = (finished.stderr + finished.stdout).strip().splitlines() or ["no output"]
            raise RuntimeError(words[-1])
        import augicp
        return augicp.read(out).points


def by_kiss_icp(path):
    from kiss_icp.datasets import dataset_factory
    if path.suffix == ".mcap":
        dataset = dataset_factory("mcap", data_dir=path, topic="/points")
    elif path.suffix == ".bag" or path.is_dir():
        dataset = dataset_factory("rosbag", data_dir=path, topic="/points")
    else:
        dataset = dataset_factory("generic", data_dir=path.parent)
    frame = dataset[0]
    return frame[0] if isinstance(frame, tuple) else frame


PROGRAMS = {"augicp": by_augicp, "Open3D": by_open3d, "PCL": by_pcl, "KISS-ICP": by_kiss_icp}


def outcome(name, path):
    try:
        return verdict(PROGRAMS[name](path), path)
    except (ImportError, FileNotFoundError) as error:
        return f"not tried: {error}"
    except (Exception, SystemExit) as error:  # of whatever kind: peers have their own
        return f"no: {' '.join(str(error).split())[:90]}"


def main():
    public, chosen = Path(sys.argv[1]), sys.argv[2:]
    with tempfile.TemporaryDirectory() as folder:
        paths = []
        for name, content in own_files().items():
            path = Path(folder, name.replace(".", "_"), name)  # alone, as KISS-ICP wants it
            path.parent.mkdir()
            path.write_bytes(content)
            paths.append(path)
        for name in PUBLIC:
            path = Path(folder, Path(name).name.replace(".", "_"), Path(name).name)
            path.parent.mkdir()
            path.write_bytes((public / name).read_bytes())
            paths.append(path)
        paths += write_recordings(Path(folder))
        print("| file |", " | ".join(PROGRAMS), "|")
        for path in paths:
            if not chosen or path.name in chosen:
                print(f"| {path.name} |", " | ".join(outcome(name, path) for name in PROGRAMS), "|", flush=True)


if __name__ == "__main__":
    main()
