#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the vertex shaders of the pages, and their script where shaders are slow, make of every shipped organ and pattern,
read back out of the browser and held against where the window draws it: `organ_shapes_test.py ORGAN_SHAPES [--firefox] [SCENE ...]`. With --make FOLDER the
organs are made only, and with the folder in place of the program only read."""
import gzip
import pathlib
import shutil
import subprocess
import sys
import tempfile

import mock_server
from webdriver import Browser, Failed, Firefox

WITHIN_MM = 0.2
SHAPES_MM = 0.15  # at the fitted moments
MOST_B = 1_500_000 - 130_000  # for a first case, without pages and texts
NORMALS_DEG = 0.05  # compared with the script's sum over the same triangles
TINTS = 1e-5
LIST = "organs.txt"

SCRIPT = """
const [name] = arguments;
(async () => {
  const [{ OrganSum }, { ScriptSum }, { Morph }, { readContainer }, { onBody }] =
    await Promise.all(['organ_sum', 'script_sum', 'morph', 'container', 'organ'].map((one) => import(`/${one}.js`)));
  const file = async (kind) => readContainer(await (await fetch(`/measured/${name}.${kind}`)).arrayBuffer());
  const [organ, { arrays: window_ }] = [onBody(await file('body'), await file('organ')), await file('places')];
  const gl = new OffscreenCanvas(8, 8).getContext('webgl2');
  if (!gl) throw new Error('no WebGL 2');
  const morph = new Morph(organ);
  const sum = new OrganSum(gl, morph);
  const script = new ScriptSum(gl, morph);
  const count = organ.meta.vertices;
  const read = (buffer, floats) => {
    const values = new Float32Array(floats);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.getBufferSubData(gl.ARRAY_BUFFER, 0, values);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    return values;
  };
  const found = { far_mm: 0, script_mm: 0, script_off: 0, moved_mm: 0, normal_deg: 0, tint: 0, tinted: 0, components: organ.meta.components, frames: organ.arrays.time_ms.length, moments: window_.time_s.length };
  window_.time_s.forEach((time_s, moment) => {
    sum.move(time_s);
    script.move(time_s);
    const places = read(sum.places, 4 * count);
    const corners = read(sum.buffer, 9 * count);
    const scripted = read(script.buffer, 9 * count);
    const fault = gl.getError();
    if (fault) throw new Error(`WebGL ${fault}`);
    const wanted = window_.place_mm.subarray(3 * count * moment);
    const first = window_.place_mm;
    const own = morph.evaluate(time_s);
    const tints = morph.tintsAt(time_s);
    for (let v = 0; v < count; ++v) {
      const apart = (a, i, b, j) => Math.hypot(a[i] - b[j], a[i + 1] - b[j + 1], a[i + 2] - b[j + 2]);
      found.far_mm = Math.max(found.far_mm, apart(places, 4 * v, wanted, 3 * v), apart(corners, 9 * v, wanted, 3 * v));
      found.script_mm = Math.max(found.script_mm, apart(scripted, 9 * v, wanted, 3 * v));
      found.moved_mm = Math.max(found.moved_mm, apart(wanted, 3 * v, first, 3 * v));
      const n = [0, 1, 2].map((k) => corners[9 * v + 3 + k]);
      const m = [0, 1, 2].map((k) => own[6 * v + 3 + k]);
      const across = Math.hypot(n[1] * m[2] - n[2] * m[1], n[2] * m[0] - n[0] * m[2], n[0] * m[1] - n[1] * m[0]);
      const along = n[0] * m[0] + n[1] * m[1] + n[2] * m[2];
      found.normal_deg = Math.max(found.normal_deg, Math.atan2(across, along) * 180 / Math.PI);
      for (let k = 0; k < 3; ++k) {
        found.tint = Math.max(found.tint, Math.abs(corners[9 * v + 6 + k] - (tints ? tints[3 * v + k] : 1)));
        found.script_off = Math.max(found.script_off, Math.abs(scripted[9 * v + 6 + k] - (tints ? tints[3 * v + k] : 1)),
          Math.abs(scripted[9 * v + 3 + k] - own[6 * v + 3 + k]));
        found.tinted = Math.max(found.tinted, Math.abs(corners[9 * v + 6 + k] - 1));
      }
    }
  });
  window.found = found;
})().catch((error) => { window.found = { error: String(error) }; });
"""


def wrong(name, found, turned_rad, sent_b, shapes_mm):
    """What is not as it should be, in words."""
    if "error" in found:
        return found["error"]
    faults = []
    if not found["far_mm"] <= WITHIN_MM:
        faults.append(f"{found['far_mm']:.3f} mm from the window")
    if not found["script_mm"] <= WITHIN_MM or found["script_off"] > 0:
        faults.append(f"by script {found['script_mm']:.3f} mm from the window, normals and colours {found['script_off']:.2g} off")
    if not found["normal_deg"] <= NORMALS_DEG:
        faults.append(f"a normal {found['normal_deg']:.2f} degrees off")
    if not found["tint"] <= TINTS:
        faults.append(f"a colour {found['tint']:.2g} off")
    if name.endswith(".detorse") and found["tinted"] < 0.05:
        faults.append("blood that is dammed up has no colour")
    if shapes_mm > SHAPES_MM:
        faults.append(f"a shape of the recording is {shapes_mm} mm off")
    if sent_b > MOST_B:
        faults.append(f"{sent_b} bytes for a first case")
    if turned_rad < 0.3 or found["moved_mm"] < 5.0:
        faults.append("the recording does not twist")
    return ", ".join(faults)


def make(program, folder, scenes):
    """A line for each organ of the scenes, kept in the folder with what the program makes."""
    told = subprocess.run([program, folder, *scenes], stdout=subprocess.PIPE, text=True, check=True).stdout
    (pathlib.Path(folder) / LIST).write_text(told)


def made(folder):
    """(the lines, {name: bytes unpacked})."""
    files = {path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir()}
    told = files.pop(LIST).decode()
    return told, {name: data if name.endswith(".places") else gzip.decompress(data) for name, data in files.items()}


def main():
    source, *rest = sys.argv[1:]
    if "--make" in rest:
        folder = pathlib.Path(rest[rest.index("--make") + 1])
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        make(source, folder, [])
        return 0
    kind = Firefox if "--firefox" in rest else Browser
    scenes = [one for one in rest if not one.startswith("--")]
    if not shutil.which(kind.PROGRAM):
        print(f"no {kind.PROGRAM}")
        return 77
    if pathlib.Path(source).is_dir():
        told, files = made(source)
    else:
        with tempfile.TemporaryDirectory(prefix="torsio-organs-") as folder:
            make(source, folder, scenes)
            told, files = made(folder)
    server, _ = mock_server.start(measured=files)
    failed = 0
    with kind() as browser:
        browser.open(f"http://127.0.0.1:{server.server_address[1]}/")
        browser.there("[name=login]")
        for name, turned_rad, *sizes, far_mm, took_s in (line.split() for line in told.splitlines()):
            browser.run("window.found = null")
            browser.run(SCRIPT, name)
            found = browser.until(f"{name} is summed", lambda: browser.run("return window.found"))
            fault = wrong(name, found, float(turned_rad), sum(map(int, sizes)), float(far_mm))
            failed += bool(fault)
            print(f"{name}: {fault or 'as the window'}; {found}; bytes of body, organ, recording, skin: {sizes}; shapes within {far_mm} mm; made in {took_s} s", flush=True)
    server.shutdown()
    if not told:
        raise Failed("no organ")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
