# SPDX-License-Identifier: MIT
"""Runs `augicp align` and reads its JSON."""
import json
import subprocess

import numpy as np

DOUBTFUL = 5


class Align:
    def __init__(self, executable):
        self.executable = str(executable)

    def __call__(self, source, target, *options, initial=None):
        """The result as a dictionary; T_target_source and those of the history as arrays."""
        words = [self.executable, "align", str(source), str(target), "--json", "-", "--threads", "1", *map(str, options)]
        if initial is not None:
            words += ["--initial", json.dumps({"T_target_source": initial.tolist()})]
        finished = subprocess.run(words, capture_output=True, text=True, check=False)
        if finished.returncode not in (0, 4, DOUBTFUL):
            raise RuntimeError(f"{' '.join(words)}: {finished.stderr.strip()}")
        result = json.loads(finished.stdout)
        result["T_target_source"] = np.array(result["T_target_source"])
        result["path"] = [np.array(step["T_target_source"]) for step in result.get("history", [])]
        return result
