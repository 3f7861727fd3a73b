#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Installs a build into an empty folder and uses it as a stranger would: a run is recorded, a foreign mesh is read by the
helper program, the review desk opens and serves every file of its pages. `installed_test.py CMAKE BUILD SOURCES`."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request


def run(program, *words, environment):
    done = subprocess.run([program, *words], env=environment, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, f"{words}: {done.returncode}\n{done.stdout}{done.stderr}"
    return done.stdout


def answer(address):
    try:
        with urllib.request.urlopen(address, timeout=10) as got:
            return got.status, got.read()
    except (urllib.error.HTTPError, urllib.error.URLError) as refused:
        return getattr(refused, "code", 0), b""


def serve(program, record, environment, sources):
    with subprocess.Popen([program, "serve", "--database", record, "--listen", "127.0.0.1:0", "--quiet"], env=environment,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as desk:
        try:
            address = None
            while address is None:
                line = desk.stdout.readline()
                assert line, desk.stderr.read()
                found = re.search(r"http://\S+", line)
                address = found and found[0]
            until = time.monotonic() + 20
            while answer(address + "readyz")[0] != 200:
                assert time.monotonic() < until, "the desk does not become ready"
                time.sleep(0.1)
            pages = [file for file in (sources / "assets/web").glob("*") if file.suffix in (".html", ".js", ".css", ".svg")]
            for name in [page.name for page in pages] + ["quick_tissue.frag"]:
                status, body = answer(address + name)
                assert status == 200 and body, f"{name}: {status}"
        finally:
            desk.terminate()


def main():
    cmake, build, sources = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    with tempfile.TemporaryDirectory(prefix="torsio-installed-") as folder:
        place = pathlib.Path(folder)
        subprocess.run([cmake, "--install", build, "--prefix", place / "usr", "--component", "torsio"], check=True,
                       stdout=subprocess.DEVNULL)
        environment = {"PATH": os.environ["PATH"], "HOME": folder, "LC_ALL": "C.UTF-8", "TORSIO_CONFIG": ""}
        program = str(place / "usr/bin/torsio")
        assert os.listdir(place / "usr/bin") == ["torsio"], "helpers are no commands"
        record = str(place / "record.sqlite")
        run(program, "record", "--database", record, "--duration", "1", environment=environment)
        mesh = place / "triangle.obj"
        mesh.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", encoding="ascii")
        said = subprocess.run([program, "organ", "import", str(mesh)], env=environment, capture_output=True, text=True,
                              timeout=60, check=False)
        assert said.returncode == 6, said.stderr  # it was read, and is no organ
        serve(program, record, environment, sources)
    print("ok      what is installed works")


if __name__ == "__main__":
    main()
