# SPDX-License-Identifier: MIT
"""Installs a wheel into a fresh virtual environment and tries it from there: the tests of the Python module, the command, a report.

    check.py WHEEL [--system-site-packages] [--tests WORD]

Runs with the Python that the wheel is for. --system-site-packages takes NumPy and pytest from the system. --tests limits the tests
of the module to those whose name has the word. Prints the wheel's size, and how long installing, importing and aligning take.
"""
import argparse
import json
import os
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
MAX_SIZE_MB = 8.0
# What the script of the reports opens with. A report without 3D views lacks it, as where no Node bundles the script.
SCRIPT_MARK = "This script contains:"
SCRIPT_SOURCES = PROJECT / "apps/augicp/page/web/node_modules/.installed"


def run(*words, **options):
    environment = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "PYTHONHOME")}
    return subprocess.run([str(word) for word in words], check=True, text=True, env=environment | options.pop("env", {}), **options)


def timed(*words, **options):
    begin = time.perf_counter()
    run(*words, **options)
    return time.perf_counter() - begin


def install(folder, wheel, system):
    """A virtual environment with the wheel; the folder of its programs, and the time from nothing until it is installed."""
    begin = time.perf_counter()
    run(sys.executable, "-m", "venv", *(["--system-site-packages"] if system else []), folder / "venv")
    programs = folder / "venv/bin"
    run(programs / "python", "-m", "pip", "install", "--quiet", *(["--no-index"] if system else []), wheel)
    return programs, time.perf_counter() - begin


def check_command(programs, work):
    version = run(programs / "augicp", "--version", capture_output=True).stdout
    expected = (PROJECT / "VERSION").read_text().strip()
    assert expected in version.split(), f"augicp --version printed {version!r}, expected {expected}"
    assert run(programs / "python", "-c", "import augicp; print(augicp.__version__)", capture_output=True, cwd=work).stdout.strip() == expected
    room = work / "data/room_pair"
    seconds = timed(programs / "augicp", "align", room / "source.ply", room / "target.ply", "--json", "result.json", "--report", "report.html",
                    cwd=work, stdout=subprocess.DEVNULL)
    assert json.loads((work / "result.json").read_text())["status"] == "converged"
    has_script = SCRIPT_MARK in (work / "report.html").read_text(encoding="utf-8")
    assert has_script or not SCRIPT_SOURCES.exists(), "the report has no 3D views"
    return seconds


def copy_tests(work):
    shutil.copy(PROJECT / "VERSION", work)
    for name in ("conftest.py", "*_test.py"):
        for file in (PROJECT / "python").rglob(name):
            copy = work / file.relative_to(PROJECT)
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(file, copy)


def check_module(programs, work, system, tests):
    """The project's own tests, copied: beside them is no source tree whose package could be imported instead."""
    if not system:
        run(programs / "python", "-m", "pip", "install", "--quiet", "pytest")
    where = run(programs / "python", "-c", "import augicp; print(augicp.__file__)", capture_output=True, cwd=work).stdout
    assert str(programs.parent) in where, f"augicp was imported from {where}"
    words = ["-k", tests] if tests else []
    run(programs / "python", "-m", "pytest", "-q", "-p", "no:cacheprovider", *words, work / "python", cwd=work,
        env={"AUGICP_COMMAND": str(programs / "augicp")})


def processor_time(*words, **options):
    """Processor time in seconds: a busy machine hardly changes it."""
    def used():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime
    begin = used()
    run(*words, **options)
    return used() - begin


def import_time(programs, work):
    """Processor time that importing adds to starting Python: the median of pairs of starts."""
    def started(code):
        return processor_time(programs / "python", "-c", code, cwd=work)
    return statistics.median(started("import augicp") - started("pass") for _ in range(9))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("wheel", type=Path)
    parser.add_argument("--system-site-packages", action="store_true", dest="system")
    parser.add_argument("--tests", metavar="WORD")
    arguments = parser.parse_args()
    size_mb = arguments.wheel.stat().st_size / 1e6
    assert size_mb <= MAX_SIZE_MB, f"{arguments.wheel.name} has {size_mb:.1f} MB, at most {MAX_SIZE_MB} are allowed"
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder) / "work"
        shutil.copytree(PROJECT / "data", work / "data")
        copy_tests(work)
        programs, install_s = install(Path(folder), arguments.wheel.resolve(), arguments.system)
        align_s = check_command(programs, work)
        check_module(programs, work, arguments.system, arguments.tests)
        import_s = import_time(programs, work)
    print(f"{arguments.wheel.name}: {size_mb:.2f} MB, installed in {install_s:.1f} s, first pair aligned in {align_s:.2f} s, "
          f"imported in {import_s:.3f} s of processor time")


if __name__ == "__main__":
    main()
