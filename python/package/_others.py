# SPDX-License-Identifier: MIT
"""Names that people bring from other libraries, and what stands for them here: an error then says what to write."""
import difflib

_IN_MODULE = {
    "icp": "align(source, target)", "register": "align(source, target)", "registration": "align(source, target)",
    "registration_icp": "align(source, target, initial=T, max_distance=d)",
    "registration_generalized_icp": 'align(source, target, initial=T, method="gicp")',
    "registration_colored_icp": "align(source, target, initial=T, intensity=True)",
    "gicp": 'align(source, target, method="gicp")', "global_registration": 'align(source, target, initial="global")',
    "read_point_cloud": "read(path)", "load": "read(path)", "write_point_cloud": "write(path, cloud)", "save": "write(path, cloud)",
    "PointCloud": "Cloud(points)", "KissICP": "LidarOdometry()", "estimate_normals": "estimate_surface(cloud)",
}
_IN_CLASS = {
    "Result": {
        "transformation": "T_target_source", "T": "T_target_source", "matrix": "T_target_source", "pose": "T_target_source",
        "fitness": "overlap", "inlier_rmse": "rmse", "error": "rmse", "num_inliers": "num_pairs", "H": "information",
        "converged": "status, or bool(result)", "has_converged": "status, or bool(result)",
        "correspondence_set": "num_pairs; a report draws the correspondences"},
    "Cloud": {
        "transform": "transformed(T), which returns a new cloud", "xyz": "points", "normals": "directions",
        "estimate_normals": "augicp.estimate_surface(cloud)", "voxel_down_sample": "augicp.estimate_surface(cloud, voxel_size=...)"},
}
_OPTIONS = {
    **dict.fromkeys(("init", "guess", "init_guess", "initial_guess", "trans_init", "init_transformation", "initial_transform"), "initial"),
    **dict.fromkeys(("downsample", "downsampling_resolution", "leaf_size", "resolution"), "voxel_size"),
    **dict.fromkeys(("registration_type", "estimation_method", "objective"), "method"),
}
# Parameters that stand before the options, where there are any like this one.
_PARAMETER_BESIDE = {"initial": "max_distance"}


def near_options(name, known):
    """The options that somebody probably meant."""
    ours = _OPTIONS.get(name)
    if ours in known or _PARAMETER_BESIDE.get(ours) in known:
        return [ours]
    return difflib.get_close_matches(name, known)


def of_module(name):
    """For the module's __getattr__: the error for a name that it lacks."""
    hint = f"; use augicp.{_IN_MODULE[name]}" if name in _IN_MODULE else ""
    return AttributeError(f"module 'augicp' has no attribute '{name}'{hint}")


def teach(*classes):
    """Lets each class say what it calls something."""
    for cls in classes:
        words = _IN_CLASS[cls.__name__]

        def missing(self, name, words=words):
            hint = f"; here it is {words[name]}" if name in words else ""
            raise AttributeError(f"'augicp.{type(self).__name__}' object has no attribute '{name}'{hint}")

        cls.__getattr__ = missing
