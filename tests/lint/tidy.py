#!/usr/bin/env python3
"""Runs clang-tidy over every source of our own that a build folder compiles, but the tests: what
is wrong with a test shows when it runs, and this is what takes longest of all checks.

  tidy.py <build folder>

Most of clang-tidy's time goes into walking through the headers of a source. So each source is
read alone only for what depends on its being alone: that it compiles, with the headers that its
room has precompiled, and its using declarations, if it has any. For the other checks several
sources are read as one, and their headers once, nothing precompiled. Where something is found, or
sources do not compile together since both have a helper of one name, they are read in halves, and
at last one by one, so that what is reported is always of a source alone.

Each version of clang-tidy has other checks: with another one than ours nothing is read, and the
exit code is 77, "skipped".

A source that passes leaves a stamp beside its object file. Ninja makes that object anew when the
source or one of its headers changes, so a stamp younger than the object still holds.
"""

import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SETTINGS = ".clang-tidy"
MOST_TOGETHER = 16
VERSION = "14."
SKIPPED = 77
CHECKS_OF_ONE = "misc-unused-using-decls"
USING = re.compile(r"^\s*using (?!namespace )[\w:]+;", re.MULTILINE)
COMPILER = "clang++-14"  # clang-tidy's own, which comes with it


def names_of(text):
    """What the lines without indentation define, for the source's own use or for others: names
    and, of those that may be defined twice if it is the same, as what."""
    defined = {}
    for line in re.findall(r"^[a-z\[][^\n]*", text, re.MULTILINE | re.IGNORECASE):
        if alias := re.match(r"(?:using|namespace) (\w+) = .*;$", line):
            defined[alias[1]] = line
        elif other := re.match(r"(?:struct|class|enum class) (\w+)", line) or re.match(
            r"[^(={]*?[ *&>](\w+)(?: = |\(|\{|\[)", line
        ):
            defined[other[1]] = None
    return defined


def clash(a, b):
    return any(a[name] is None or a[name] != b[name] for name in a.keys() & b.keys())


class Source:
    """A source, and how it is compiled: alone, or as a part of the file in `entry`."""

    def __init__(self, entry, file):
        self.file = file
        self.folder = entry["directory"]
        # Without GCC's precompiled headers, which clang cannot read.
        precompiled = r' -Winvalid-pch -include (?:"([^"]*)"|(\S+))'
        headers = re.search(precompiled, entry["command"])
        self.headers = headers and (headers[1] or headers[2])
        command = re.sub(precompiled, "", entry["command"])
        self.flags, output = re.match(r"(.*) -o (\S+) -c ", command).groups()
        self.standard = re.search(r"-std=\S+", self.flags)[0]
        self.object = Path(self.folder, output)
        self.stamp = Path(f"{self.object}.{self.file.name}.tidy")
        text = self.file.read_text()
        self.names = names_of(text)
        self.is_using = USING.search(text) is not None
        self.settings = [f / SETTINGS for f in self.file.parents if (f / SETTINGS).exists()]

    def has_passed(self):
        if not self.stamp.exists():
            return False
        stamped = self.stamp.stat().st_mtime
        return all(f.stat().st_mtime < stamped for f in [self.object, *self.settings])


def compiled_files(entry, build):
    """The file of an entry, or the files that it includes where CMake has put several together."""
    file = Path(entry["file"])
    if not file.is_relative_to(build):
        return [file]
    return [Path(part) for part in re.findall(r'^#include "(.+\.cpp)"$', file.read_text(), re.M)]


def own_sources(build):
    """Each source once, however often it is compiled."""
    sources = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        for file in compiled_files(entry, build):
            if not file.is_relative_to(build) and not file.is_relative_to(ROOT / "tests"):
                sources.setdefault(file, Source(entry, file))
    return list(sources.values())


def groups(sources):
    """Sources to be read together: compiled in one way, without a name in common, and with the
    settings of the root alone, which are those that hold for a file in the build folder."""
    made = []
    for source in sources:
        own_settings = len(source.settings) > 1
        for group in made:
            if (
                not own_settings
                and len(group) < MOST_TOGETHER
                and group[0].flags == source.flags
                and not any(clash(member.names, source.names) for member in group)
            ):
                group.append(source)
                break
        else:
            made.append([source])
    return made


def tidy(file, source, *options):
    """clang-tidy on a file that is compiled as the source is; what it says, or nothing."""
    command = f"{source.flags} -c {json.dumps(str(file))}"
    entry = {"directory": source.folder, "file": str(file), "command": command}
    with tempfile.TemporaryDirectory() as database:
        Path(database, "compile_commands.json").write_text(json.dumps([entry]))
        done = subprocess.run(
            ["clang-tidy", "-p", database, "--quiet", *options, str(file)],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    # It tells on stderr how many warnings of other people's headers it has left out.
    return "" if done.returncode == 0 else done.stdout


def clang(source, *arguments):
    """What clang says when it compiles the source as it is compiled, with these arguments."""
    flags = source.flags.split(" ", 1)[1]
    done = subprocess.run(
        f"{COMPILER} {flags} -w {shlex.join(map(str, arguments))}", shell=True, cwd=source.folder,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    return "" if done.returncode == 0 else done.stdout


def precompile(sources, folder):
    """The headers that these sources have precompiled, as files for clang, by headers and
    standard."""
    users = {(source.headers, source.standard): source for source in sources if source.headers}
    made = {key: Path(folder, f"{number}.pch") for number, key in enumerate(users)}
    for key, file in made.items():
        if said := clang(users[key], "-x", "c++-header", "-fpch-instantiate-templates", key[0],
                         "-o", file):
            sys.exit(said)
    return made


def check_alone(source, precompiled):
    if source.is_using:
        return tidy(source.file, source, f"--checks=-*,{CHECKS_OF_ONE}")
    headers = precompiled.get((source.headers, source.standard))
    # Sources of a room have other macros of their own; none has a part in these headers.
    use = ["-include-pch", headers, "-Xclang", "-fno-validate-pch"] if headers else []
    return clang(source, *use, "-fsyntax-only", source.file)


def check_together(members, folder):
    """What is found in these sources, which have passed alone."""
    if len(members) == 1:
        found = tidy(members[0].file, members[0])
        if not found:
            members[0].stamp.touch()
        return found
    with tempfile.NamedTemporaryFile("w", suffix=".cpp", dir=folder) as together:
        together.writelines(f'#include "{source.file}"\n' for source in members)
        together.flush()
        found = tidy(together.name, members[0])
    if not found:
        for source in members:
            source.stamp.touch()
        return ""
    half = len(members) // 2
    return check_together(members[:half], folder) + check_together(members[half:], folder)


def other_version():
    """The version of clang-tidy if it is not ours; empty if it is."""
    said = subprocess.run(["clang-tidy", "--version"], stdout=subprocess.PIPE, text=True, check=True)
    version = re.search(r"version (\S+)", said.stdout)[1]
    return "" if version.startswith(VERSION) else version


def main(build):
    if version := other_version():
        print(f"skipped: the checks are those of clang-tidy {VERSION.rstrip('.')}, and this is {version}")
        return SKIPPED
    sources = [s for s in own_sources(build) if not s.has_passed()]
    with ThreadPoolExecutor(os.cpu_count()) as jobs, tempfile.TemporaryDirectory() as folder:
        precompiled = precompile(sources, folder)
        alone = list(jobs.map(lambda source: check_alone(source, precompiled), sources))
        fit = [source for source, found in zip(sources, alone) if not found]
        together = list(jobs.map(lambda members: check_together(members, build), groups(fit)))
    found = "".join(alone + together)
    print(found, end="")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()))
