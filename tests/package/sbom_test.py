#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bill of materials of a build names every library that its programs link and all that they load, with version and
package URL, and is the same each time. `sbom_test.py BUILD SOURCES`."""
import json
import os
import pathlib
import re
import subprocess
import sys


def main():
    build, sources = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    environment = {**os.environ, "SOURCE_DATE_EPOCH": "1750000000"}
    command = [sources / "tools/package/sbom", build]
    runs = [subprocess.run(command, env=environment, capture_output=True, text=True, check=False) for _ in range(2)]
    assert all(run.returncode == 0 for run in runs), runs[0].stderr
    texts = [run.stdout for run in runs]
    assert texts[0] == texts[1], "two runs differ"
    document = json.loads(texts[0])
    assert document["spdxVersion"] == "SPDX-2.3" and document["creationInfo"]["created"] == "2025-06-15T15:06:40Z"
    packages = {one["SPDXID"]: one for one in document["packages"]}
    assert len(packages) == len(document["packages"]), "an id stands twice"
    for relation in document["relationships"]:
        for end in (relation["spdxElementId"], relation["relatedSpdxElement"]):
            assert end in packages or end == "SPDXRef-DOCUMENT", f"{end} is no element"
    versions = {one["name"]: one["versionInfo"] for one in document["packages"]}
    direct = {packages[one["relatedSpdxElement"]]["name"] for one in document["relationships"]
              if one["spdxElementId"] == "SPDXRef-torsio"}

    linked = re.findall(r"^\s+(\S+) => /", subprocess.run(["ldd", build / "bin/torsio"], capture_output=True, text=True,
                                                           check=True).stdout, re.M)
    assert len(linked) > 50, linked
    for library in linked:
        if library.startswith(("libQt6", "libfcl", "libassimp", "libsodium", "libmicrohttpd", "libpq", "libsqlite3", "libcurl")):
            stem = re.match(r"lib([A-Za-z0-9]+?)(-gnutls)?[.]so", library)[1].lower()
            assert any(stem in name.replace("-", "").replace("t64", "") for name in direct), f"{library} is in no package of {direct}"
    for name in ("libqt6sql6-psql", "qml6-module-quick3d", "fonts-noto-cjk"):
        assert name in direct, f"{name} is loaded while the program runs"
    for name in ("libc6", "nlohmann-json3-dev", "libeigen3-dev"):
        assert name in versions, f"{name} is missing"
    real = subprocess.run(["dpkg-query", "-W", "-f=${Version}", "libqt6sql6-psql"], capture_output=True, text=True, check=True)
    assert versions["libqt6sql6-psql"] == real.stdout
    assert all(one["externalRefs"][0]["referenceLocator"].startswith("pkg:deb/debian/") for one in document["packages"]
               if one["name"] != "torsio")


main()
