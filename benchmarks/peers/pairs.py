# SPDX-License-Identifier: MIT
"""Peers on cells of pairs: errors, successes and times, as one CSV and as Markdown."""
import csv

import numpy as np

from jobs import guess_words, motion_words, run_program
from motions import error

LIMITS = ((0.05, 2.0), (0.03, 2.5), (0.02, 1.0))  # metres and degrees below which a pair counts as a success
RESULT_FIELDS = ("cell", "pair", "peer", "method", "verdict", "score", "threads", "iterations", "preprocess_ms", "align_ms",
                 "error_m", "error_deg", "guess", "found", "truth")


def judged(cell, job, row):
    """A result with its errors. Where the peer gave no pose the guess stands (no motion for the guess "previous"), but
    never as a success."""
    left = np.eye(4) if job.guess is None else job.guess
    error_m, error_deg = error(left if row["pose"] is None else row["pose"], job.truth)
    found = "" if row["pose"] is None else motion_words(row["pose"])
    return row | {"cell": cell.name, "error_m": error_m, "error_deg": error_deg, "guess": guess_words(job),
                  "found": found, "truth": motion_words(job.truth)}


def run_cell(cell, program):
    """Results with errors, in the order of the cell's jobs, methods within."""
    jobs = {job.pair: job for job in cell.jobs}
    return [judged(cell, jobs[row["pair"]], row) for row in run_program(program, cell.jobs)]


def write_results(path, rows):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, RESULT_FIELDS, extrasaction="ignore", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def grouped(rows, *fields):
    """{values of the fields: rows}, in the order of their first appearance."""
    groups = {}
    for row in rows:
        groups.setdefault(tuple(row[field] for field in fields), []).append(row)
    return groups


def successes(rows, limit_m, limit_deg):
    return sum(bool(row["found"]) and row["error_m"] < limit_m and row["error_deg"] < limit_deg for row in rows)


def column(rows, field):
    return np.array([float(row[field]) for row in rows])


TABLE_HEADER = [
    "| cell | peer | 5 cm, 2 deg | 3 cm, 2.5 deg | 2 cm, 1 deg | mean error | median error | ms | ms with preprocessing |",
    "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"]


def table(rows):
    """A line for each cell and method."""
    lines = list(TABLE_HEADER)
    for (cell, peer, method), group in grouped(rows, "cell", "peer", "method").items():
        both = lambda average: f"{1000 * average(column(group, 'error_m')):.1f} mm, {average(column(group, 'error_deg')):.2f} deg"
        align_ms = column(group, "align_ms")
        whole_ms = align_ms + column(group, "preprocess_ms")
        counts = [f"{successes(group, *limits)} of {len(group)}" for limits in LIMITS]
        lines.append(f"| {' | '.join([cell, f'{peer} {method}', *counts, both(np.mean), both(np.median)])} "
                     f"| {np.median(align_ms):.0f} | {np.median(whole_ms):.0f} |")
    return lines


def overview(rows):
    """Successes by each of the limits: a line for each method, a column for each cell."""
    cells = [cell for cell, in grouped(rows, "cell")]
    lines = ["| peer | " + " | ".join(cells) + " |", "| --- |" + " --- |" * len(cells)]
    for (peer, method), group in grouped(rows, "peer", "method").items():
        of_cell = grouped(group, "cell")
        counts = [" / ".join(str(successes(of_cell[cell,], *limits)) for limits in LIMITS) if (cell,) in of_cell else "-"
                  for cell in cells]
        lines.append(f"| {peer} {method} | " + " | ".join(counts) + " |")
    return lines


def kind(row):
    """What cells of different windows share, the last two words of their names: gap 10."""
    return " ".join(row["cell"].split()[-2:])


def errors_and_times(rows):
    """A line for each method: errors, a column for each kind of cells; median processor times of all pairs."""
    kinds = list(dict.fromkeys(map(kind, rows)))
    lines = ["| peer | " + " | ".join(kinds) + " | ms | ms with preprocessing |", "| --- |" + " --- |" * (len(kinds) + 2)]
    for (peer, method), group in grouped(rows, "peer", "method").items():
        cells = []
        for name in kinds:
            of_kind = [row for row in group if kind(row) == name]
            averages = [(1000 * average(column(of_kind, "error_m")), average(column(of_kind, "error_deg")))
                        for average in (np.mean, np.median)]
            cells.append(" / ".join(f"{mm:.1f} mm, {deg:.2f} deg" for mm, deg in averages) if of_kind else "-")
        align_ms, preprocess_ms = column(group, "align_ms"), column(group, "preprocess_ms")
        cells += [f"{np.median(align_ms):.0f}", f"{np.median(align_ms + preprocess_ms):.0f}"]
        lines.append(f"| {peer} {method} | {' | '.join(cells)} |")
    return lines


def measure(programs, cells, csv_path, progress):
    """Markdown lines; every result goes to the CSV."""
    rows = []
    for cell in cells:
        for program in programs:
            rows += run_cell(cell, program)
            progress(f"{cell.name}: {program.name}")
    write_results(csv_path, rows)
    count = len(cells[0].jobs)
    return [f"Within 5 cm and 2 deg / 3 cm and 2.5 deg / 2 cm and 1 deg, of {count}:", "", *overview(rows), "",
            "Errors, mean / median:", "", *errors_and_times(rows), "", *table(rows)]
