#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Checks that the sources keep to the layout: each module includes only the modules it depends on, public headers show no
third-party library but Eigen, the command's rooms include in one direction, no source file is forgotten in the build, and every
file says its licence.

    includes_test.py ROOT    prints each fault; exit code 1 if there is one

Before it looks at ROOT it checks itself on a small tree with one fault of each kind.
"""
import re
import sys
from pathlib import Path

from fault_tree import expect_faults, written

SOURCE_SUFFIXES = {".h", ".cpp", ".py", ".cmake", ".in"}
SOURCE_FOLDERS = ["src", "apps", "examples", "tests", "cmake", "scripts", "python", "experiments", "benchmarks", ".ci"]
KEYWORDS = ["HEADERS", "SOURCES", "TESTS", "DEPENDS", "PRIVATE"]
ROOMS = ["text", "page", "command"]  # of apps/augicp: each may include those before it
LONG_FILE = 300  # lines; longer ones need a reason and are listed


def read_modules(cmake_text):
    """{module: {keyword: [words]}} of the augicp_module(...) calls."""
    modules = {}
    for name, body in re.findall(r"augicp_module\(\s*(\w+)([^)]*)\)", re.sub(r"#.*", "", cmake_text)):
        module = modules[name] = {keyword: [] for keyword in KEYWORDS}
        keyword = None
        for word in body.split():
            if word in KEYWORDS:
                keyword = word
            elif keyword:
                module[keyword].append(word)
    return modules


def reachable(modules, name):
    """The module itself and all it depends on, directly or not."""
    found, todo = set(), [name]
    while todo:
        module = todo.pop()
        if module not in found:
            found.add(module)
            todo += modules[module]["DEPENDS"] if module in modules else []
    return found


def includes(text):
    """(opening character, path) of each #include."""
    return re.findall(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', text, flags=re.MULTILINE)


def words_of(cmake_text):
    return set(re.split(r"[\s()]+", re.sub(r"#.*", "", cmake_text)))


def module_faults(root, modules, name, words):
    folder = root / "src/augicp" / name
    allowed, module = reachable(modules, name), modules[name]
    for path in sorted(path for suffix in ("h", "cpp") for path in folder.rglob(f"*.{suffix}")):
        where, word = path.relative_to(root), path.relative_to(folder).as_posix()
        if word not in words:
            yield f"{where}: is not named in src/augicp/CMakeLists.txt"
        if word in module["TESTS"]:
            continue  # a test may use all of the library, and the testing module
        for quote, included in includes(path.read_text()):
            other = re.match(r"augicp/(\w+)/", included)
            if other and other[1] not in allowed:
                yield f"{where}: includes {included}, but {name} does not depend on {other[1]}"
            elif quote == '"' and not other and "/" not in included:
                yield f'{where}: include "{included}" by its full path, augicp/...'
            elif word in module["HEADERS"] and not other and re.search(r"[/.]", included):
                if not included.startswith("Eigen/"):
                    yield f"{where}: a public header includes {included}; only Eigen may be seen by users"


def room_faults(root):
    app = root / "apps/augicp"
    words = words_of((app / "CMakeLists.txt").read_text())
    for rank, room in enumerate(ROOMS):
        for path in sorted(path for suffix in ("h", "cpp") for path in (app / room).rglob(f"*.{suffix}")):
            where, word = path.relative_to(root), path.relative_to(app).as_posix()
            if word not in words:
                yield f"{where}: is not named in apps/augicp/CMakeLists.txt"
            for quote, included in includes(path.read_text()):
                other = re.match(r"apps/augicp/(\w+)/", included)
                if other and other[1] not in ROOMS[: rank + 1]:
                    yield f"{where}: includes {included}; {room} may include {' and '.join(ROOMS[: rank + 1])}"
                elif quote == '"' and "/" not in included:
                    yield f'{where}: include "{included}" by its full path, apps/augicp/...'


def source_files(root):
    for folder in SOURCE_FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            is_script = path.is_file() and not path.suffix and path.read_bytes()[:2] == b"#!"
            if path.is_file() and (path.suffix in SOURCE_SUFFIXES or path.name == "CMakeLists.txt" or is_script):
                if not {"node_modules", "__pycache__", "build"} & set(path.relative_to(root).parts):
                    yield path


def faults(root):
    cmake_text = (root / "src/augicp/CMakeLists.txt").read_text()
    modules, words = read_modules(cmake_text), words_of(cmake_text)
    if not modules:
        yield "src/augicp/CMakeLists.txt: no augicp_module(...) found"
    for name in modules:
        yield from module_faults(root, modules, name, words)
    yield from room_faults(root)
    for path in source_files(root):
        if not any("SPDX-License-Identifier: MIT" in line for line in path.read_text().splitlines()[:2]):
            yield f"{path.relative_to(root)}: no SPDX line at its top"


def long_files(root):
    for path in source_files(root):
        count = len(path.read_text().splitlines())
        if count > LONG_FILE:
            yield f"{path.relative_to(root)}: {count} lines"


def check_self():
    """Every kind of fault is found in a tree made for it, and nothing else."""
    spdx = "// SPDX-License-Identifier: MIT\n"
    tree = {
        "src/augicp/CMakeLists.txt": "# SPDX-License-Identifier: MIT\n"
        "augicp_module(core HEADERS a.h)\naugicp_module(cloud DEPENDS core HEADERS b.h SOURCES b.cpp TESTS b_test.cpp)\n"
        "augicp_module(match DEPENDS cloud  # and through it core\n  HEADERS c.h PRIVATE TBB::tbb)\n",
        "src/augicp/core/a.h": spdx + "#include <vector>\n#include <Eigen/Core>\n" + '#include "augicp/cloud/b.h"\n',
        "src/augicp/cloud/b.h": '#include "augicp/core/a.h"\n',
        "src/augicp/cloud/b.cpp": spdx + '#include <tbb/parallel_for.h>\n#include "b.h"\n',
        "src/augicp/cloud/b_test.cpp": spdx + '#include <gtest/gtest.h>\n#include "augicp/match/c.h"\n',
        "src/augicp/match/c.h": spdx + '#include "augicp/core/a.h"\n  # include <tbb/task_arena.h>\n',
        "src/augicp/match/forgotten.cpp": spdx + "\n" * LONG_FILE,
        "apps/augicp/CMakeLists.txt": "# SPDX-License-Identifier: MIT\nadd_library(x page/d.cpp page/d.h text/e.cpp  # text/f.h\n)\n",
        "apps/augicp/page/d.h": spdx + '#include "apps/augicp/text/e.h"\n#include "apps/augicp/page/d.h"\n',
        "apps/augicp/page/d.cpp": spdx + '#include "apps/augicp/command/g.h"\n',
        "apps/augicp/text/e.cpp": spdx + '#include "apps/augicp/page/d.h"\n#include "e.h"\n',
        "apps/augicp/text/f.h": spdx,
        "scripts/tool": "#!/bin/sh\n",
    }
    expected = {
        "src/augicp/core/a.h: includes augicp/cloud/b.h, but core does not depend on cloud",
        "src/augicp/cloud/b.h: no SPDX line at its top",
        'src/augicp/cloud/b.cpp: include "b.h" by its full path, augicp/...',
        "src/augicp/match/c.h: a public header includes tbb/task_arena.h; only Eigen may be seen by users",
        "src/augicp/match/forgotten.cpp: is not named in src/augicp/CMakeLists.txt",
        "apps/augicp/page/d.cpp: includes apps/augicp/command/g.h; page may include text and page",
        "apps/augicp/text/e.cpp: includes apps/augicp/page/d.h; text may include text",
        'apps/augicp/text/e.cpp: include "e.h" by its full path, apps/augicp/...',
        "apps/augicp/text/f.h: is not named in apps/augicp/CMakeLists.txt",
        "scripts/tool: no SPDX line at its top",
    }
    expect_faults(faults, tree, expected)
    with written(tree) as root:
        assert [line.split(":")[0] for line in long_files(root)] == ["src/augicp/match/forgotten.cpp"]


def main():
    check_self()
    root = Path(sys.argv[1])
    for line in long_files(root):
        print(f"long file: {line}")
    found = list(faults(root))
    print("\n".join(found) if found else "every file keeps to the layout")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
