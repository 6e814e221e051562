# SPDX-License-Identifier: MIT
"""The installed Python package as a stranger uses it: found below the prefix, complete, and at work.

    install_python.py PREFIX    with the package's directory on PYTHONPATH
"""
import sys
from pathlib import Path

import numpy as np

import augicp

package = Path(augicp.__file__).parent
assert package.is_relative_to(Path(sys.argv[1]).resolve()) or package.is_relative_to(sys.argv[1]), package
assert {"__init__.pyi", "py.typed"} <= {path.name for path in package.iterdir()}
random = np.random.default_rng(0)
corner = np.concatenate([np.insert(random.random((400, 2)), axis, 0.0, axis=1) for axis in range(3)])
result = augicp.align(corner, corner + 0.01)
assert result, result
assert np.allclose(result.T_target_source[:3, 3], 0.01, atol=1e-3), result.T_target_source
print(f"augicp {augicp.__version__} from {package}: {result}")
