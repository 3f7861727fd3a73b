#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A release is refused, and nothing is tagged, until version, changelog and commit agree. `release_test.py SOURCES`."""
import pathlib
import shutil
import subprocess
import sys
import tempfile


def main():
    sources = pathlib.Path(sys.argv[1])
    with tempfile.TemporaryDirectory(prefix="torsio-release-") as folder:
        place = pathlib.Path(folder)
        for name in ("tools/package/release", "app/setup.sh"):
            (place / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(sources / name, place / name)

        def git(*words):
            return subprocess.run(["git", "-c", "user.name=T", "-c", "user.email=t@example.org", *words], cwd=place, check=True,
                                  capture_output=True, text=True).stdout

        def refused(why, *words):
            done = subprocess.run([place / "tools/package/release", *words], capture_output=True, text=True, check=False)
            assert done.returncode != 0 and why in done.stderr, (words, done.stderr)
            assert git("tag") == ""

        def commit(version, news):
            (place / "CMakeLists.txt").write_text(f"project(Torsio VERSION {version} LANGUAGES CXX)\n")
            (place / "CHANGELOG.md").write_text(news)
            git("add", "-A")
            git("commit", "-q", "--allow-empty", "-m", "all: a state")

        git("init", "-q")
        commit("0.2.0", "# Changelog\n\n## 0.2.0 (unreleased)\n\n- news\n\n## 0.1.0 (2026-01-02)\n")
        refused("say which version")
        refused("say which version", "two")
        refused("another version", "0.3.0")
        refused("no section", "0.2.0")
        (place / "left").write_text("over")
        refused("not committed", "0.2.0")


main()
