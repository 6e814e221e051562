# SPDX-License-Identifier: MIT
"""The seeds that are text, for make_corpus.py."""

XYZ = {
    "quotes": b'"name","x","y","z"\n"a, b",1,"2.5",3\n"say ""c""",4,5,6\n',
    "decimal-commas": b"x;y;z;t\n1,5;2;3,25;0,1\n-1;1,5e1;0;7\n",
    "blanks": b"# a comment\n0 0 0\n1 2 3 9\n\n-1.5e-3 +4 5\n",
    "commas": b"x,y,z,nx,ny,nz,intensity\n1,2,3,0,0,1,7\n4,5,6,0,1,0,inf\nnan,5,6,0,1,0,2\n",
    "semicolons": b"z;y;x\r\n1.5;2;3\r\n4;5;6\r\n",
    "counted": b"3\n1 2 3\n4 5 6\n7 8 9\n",
    "counted-more": b"1\n1 2 3\n4 5 6\n",
    "cloudcompare": b"//X Y Z Structure Normal_X Normal_Y Normal_Z\n1 2 3 1 0 0 2\n4 5 6 2 1 0 0\n7 8 9 0 0 0 0\n",
    "carriage-returns": b"1 2 3\r4 5 6\r",
    "bom-far": b"\xef\xbb\xbf500000.125 4000000.5 100\n500001 4000001 101\n500002 4000002 102",
    "matlab": b"% X Y Z R G B\n1 2 3 9 9 9\n4 5 6 9 9 9\n",
    "separator-line": b"sep=;\r\nx;y;z\r\n1;2;3\r\n// the end\r\n4;5;6\r\n",
    "paraview": b'"Points:0","Points:1","Points:2","Normals:0"\n1,2,3,4\n5,6,7,8\n',
    "huge": b"1e18 0 0\n1 1 1\n1e-320 1e308 -inf\n",
}

IMAGE_LIST = {
    "tum": b"# depth maps\n# timestamp filename\n1305031453.374112 depth/1305031453.374112.png\n1305031453.5 depth/b.png\n",
    "blanks": b"\xef\xbb\xbf 1 a name with blanks.png \r\n-2.5\tb.png\r\n",
}

TRAJECTORY = {
    "tum": b"# timestamp tx ty tz qx qy qz qw\n1 0 0 0 0 0 0 1\n1.5 1 2 3 0 0.6 0 0.8 # good\n2 0 0 0 0.5 0.5 0.5 0.5\n",
    "commas": b"\xef\xbb\xbf0, 1, 2, 3, 1, 0, 0, 0\r\n0.1, 1, 2, 3, 0.7071, 0, 0, 0.7071",
    "unsorted": b"2 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n",
    "milliseconds": b"1305031453374 0 0 0 0 0 0 1\n",
}

POSES = {
    "tum": TRAJECTORY["tum"],
    "kitti": b"1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 1 0 1 0 2 0 0 1 3\n",
    "four-rows": b"1 0 0 5 0 1 0 6 0 0 1 7 0 0 0 1\n1 0 0 1 0 1 0 2 0 0 1 3 0 0 0 1\n",
    "nanoseconds": b"% a run\n1403636579763555584 1 2 3 0 0 0 1\n1403636579768555584 1 2 4 0 0 0 1\n",
    "two-columns": b"sec,nanosec,x,y,z,qx,qy,qz,qw\n12,250000000,1,2,3,0,0,0,1\n",
    "stamped-rows": b"0.1 1 0 0 0 0 1 0 0 0 0 1 0\n0.2 1 0 0 1 0 1 0 2 0 0 1 3\n",
    "euroc": b"#timestamp [ns], p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], q_RS_z [], v_RS_R_x [m s^-1]\n"
             b"1403636579763555584,4.6,-1.7,0.7,1,0,0,0,-0.02\n1403636579768555584,4.6,-1.7,0.7,0,1,0,0,-0.02\n",
    "spreadsheet": b"\xef\xbb\xbf\"qw\";\"qx\";\"qy\";\"qz\";\"time_ms\";\"x\";\"y\";\"z\"\r\n1;0;0;0;12;1;2;3\r\n1;0;0;0;13;1;2;3\r\n",
    "topic": b"%time,field.pose.position.x,field.pose.position.y,field.pose.position.z,field.pose.orientation.x,"
             b"field.pose.orientation.y,field.pose.orientation.z,field.pose.orientation.w\n1403636579763555584,0,0,0,0,0,0,1\n",
    "objects": b'{"timestamp": 1.5, "position": [1, 2, 3], "orientation_wxyz": [1, 0, 0, 0]}\n'
               b'{"timestamp": 2.5, "position": [1, 2, 3], "orientation_wxyz": [0, 1, 0, 0], "more": {"a": [[1], 2]}}\n',
    "nested": b'{"stamp_ns": 1, "pose": {"position": {"x": 0, "y": 0, "z": 0}, "orientation": {"x": 0, "y": 0, "z": 0, "w": 1}}}\n',
}

TRANSFORM = {
    "matrix": b"# T\n1 0 0 0.5\n0 1 0 0\n0 0 1 -2\n0 0 0 1\n",
    "rows": b"0 -1 0 1, 1 0 0 2, 0 0 1 3\n",
    "rows-commas": b"0,-1,0,1\n1,0,0,2\n0,0,1,3\n",
    "quaternion": b"0.1 0.2 0.3 0 0 0.6 0.8\n",
    "json": b'{"T_target_source": [[1, 0, 0, 0.5], [0, 1, 0, 0], [0, 0, 1, -2], [0, 0, 0, 1]], "status": "converged"}',
    "brackets": b"[[1. 0. 0. 2.]\n [0. 1. 0. 3.]\n [0. 0. 1. 4.]\n [0. 0. 0. 1.]]\n",
    "json-flat": b'\xef\xbb\xbf {"T_target_source": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]}',
    "reflection": b"1 0 0 0 0 1 0 0 0 0 -1 0 0 0 0 1\n",
}

CAMERA = {
    "numbers": b"525 525 319.5 239.5\n",
    "lens": b"517.3 516.5 318.6 255.3 0.2624 -0.9531 -0.0054 0.0026 1.1633\n",
    "matrix": b"525 0 319.5\n0 525 239.5\n0 0 1\n",
    "open3d": b'{"width": 640, "height": 480, "intrinsic_matrix": [517.3, 0, 0, 0, 516.5, 0, 318.6, 255.3, 1],\n'
              b' "distortion": [0.2624, -0.9531, -0.0054, 0.0026, 1.1633], "readout_s": 0.033}\n',
    "name": b"tum-fr1",
    "wide": b'{"width": 1e99, "intrinsic_matrix": [585,0,0, 0,585,0, 320,240,1]}',
    "whole-numbers": b"525 525 320 240",
    "columns": b'{"intrinsic_matrix": [[500, 0, 0], [0, 500, 0], [320, 240, 1]]}',
    "view": b'{"extrinsic": [1], "intrinsic": {"width": 640, "height": 480, "intrinsic_matrix": [500, 0, 0, 0, 500, 0, 320, 240, 1]}}',
    "kalibr": b"cam0:\n  camera_model: pinhole\n  distortion_coeffs: [0.1, 0, 0, 0]\n  distortion_model: radtan\n"
              b"  intrinsics: [500.0, 501.0, 320, 240]\n  resolution: [640, 480]\n",
    "orb-slam": b"%YAML:1.0\nCamera.type: \"PinHole\"\nCamera.fx: 500.0 # pixels\nCamera.fy: 501\nCamera.cx: 320\nCamera.cy: 240\nCamera.k1: 0.1\n",
    "items": b"height: 480\nwidth: 640\nd:\n- 0.1\n- 0\n- 0\n- 0\n- 0\nk:\n- 500.0\n- 0\n- 320\n- 0\n- 501\n- 240\n- 0\n- 0\n- 1\n",
    "labels": b"fx = 500\nfy = 501\ncx=320\ncy=240\n",
}

CAMERA.update({
    "scannet": b"585 0 320 0\n0 586.5 240.25 0\n0 0 1 0\n0 0 0 1\n",
    "rows": b'{"intrinsic_matrix": [[500, 0, 320], [0, 500, 240], [0, 0, 1]]}',
    "realsense": b'{"width": 640, "height": 480, "fx": 585, "fy": 586, "ppx": 320, "ppy": 240, "model": "Brown Conrady", "coeffs": [0, 0, 0, 0, 0]}',
    "ros": b"image_width: 640\nimage_height: 480\ncamera_matrix:\n  rows: 3\n  cols: 3\n  data: [585, 0, 320, 0, 586, 240,\n    0, 0, 1]\n"
           b"distortion_model: plumb_bob\ndistortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [0.1, -0.2, 0, 0, 0]\n",
    "ros-message": b"height: 480\nwidth: 640\nd: []\nk: [585, 0, 320, 0, 586, 240, 0, 0, 1]\n",
})

COMMAND_LINE = {
    "align": b"align\na.ply\nb.ply\n--method\ngicp\n--initial\n0 0 0 0 0 0 1\n--max-angle-deg\n45\n--quiet\n\n"
             b"[align]\nradius = 0.1\nthreads = 2\nmethod = \"plane\"\ntrace = true\n",
    "odometry": b"odometry\nfolder\n--camera\ntum-fr1\n--output\ntrajectory.txt\n\n# a comment\n[odometry]\ncamera = '500 500 320 240'\n",
    "experiment": b"experiment\nsynthetic\n--help\n\n[experiment.synthetic]\nseed = 3\n",
    "unknown": b"info\nscan.ply\n--no-such-option\n\n[info]\nno_such = 1\nmax-points = [1, 2]\n",
    "version": b"--version\n\nalign.source = x\n",
    "surface": b"surface\nscan.ply\n--json=-\n--radius=1e308\n--max-points=-1\n\n[surface]\nfile = \"a\\\"b\"\n[[surface]]\n",
}
