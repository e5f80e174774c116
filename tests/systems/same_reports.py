#!/usr/bin/env python3
"""Grades a few kept submissions and compares what the reports say with what they said before.

    same_reports.py PROGRAM FOLDER          compares with reports.sha256
    same_reports.py PROGRAM FOLDER --write  the reports have changed on purpose: writes it anew

PROGRAM is the built grader. The reports go to FOLDER: where two systems give different ones,
compare these files. The same bytes must come from every compiler and every version of a library.
"""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parent.parent
DIGESTS = HERE / "reports.sha256"
RENEW = "cmake --build --preset test --target renew_reports"

# Right and empty work, and of each kind of finding one: numbers, a pointer table, a stack, an
# exception, and what misconceptions predict. None that ends by a limit: where it stood is chance.
KEPT = {
    "reference": "reference",
    "skeleton": "student_skeleton",
    "curve": "tests/submissions/wrong/bezier_curve/t_swapped",
    "patch": "tests/submissions/wrong/bezier_patch/net_transposed",
    "normal": "tests/submissions/wrong/vertex_normal/angle_weighted",
    "flip": "tests/submissions/wrong/edge_flip/next_wrong",
    "throws": "tests/submissions/wrong/edge_flip/throws",
    "split": "tests/submissions/wrong/edge_split/uses_deleted",
    "loop": "tests/submissions/wrong/loop_subdivision/mixed_in_one_mesh",
}


def canonical(report):
    """Without what is this machine's: its sandbox, and the words of its compiler."""
    del report["sandbox"]
    for file in report["files"]:
        del file["messages"]
    return json.dumps(report, indent=1, sort_keys=True, ensure_ascii=False) + "\n"


def graded(program, name):
    folder = PROJECT / KEPT[name]
    exercises = [folder.parent.name] if folder.parent.parent.name == "wrong" else []
    with tempfile.TemporaryDirectory() as scratch:
        file = pathlib.Path(scratch) / "report.json"
        said = subprocess.run(
            [program, "check", folder, *exercises, "--json", file],
            env={**os.environ, "XDG_STATE_HOME": scratch, "XDG_CACHE_HOME": scratch}, text=True,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        if said.returncode not in (0, 1):
            sys.exit(f"check {KEPT[name]} ended with {said.returncode}:\n{said.stdout}")
        return canonical(json.loads(file.read_text(encoding="utf-8")))


def main():
    program, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        reports = dict(zip(KEPT, pool.map(lambda name: graded(program, name), KEPT)))
    lines = []
    for name, text in sorted(reports.items()):
        (folder / f"{name}.json").write_text(text, encoding="utf-8")
        lines.append(f"{hashlib.sha256(text.encode()).hexdigest()}  {name}.json\n")
    if sys.argv[3:] == ["--write"]:
        DIGESTS.write_text("".join(lines), encoding="utf-8")
        return
    known = DIGESTS.read_text(encoding="utf-8").splitlines(keepends=True)
    changed = [line.split()[1] for line in lines if line not in known]
    if changed or len(known) != len(lines):
        sys.exit(f"Other reports than those of {DIGESTS}: {', '.join(changed)} in {folder}.\n"
                 f"If you changed what reports say: {RENEW}\n"
                 "If not, this system or its libraries give other numbers than those of others.")


main()
