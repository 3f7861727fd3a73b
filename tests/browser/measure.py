#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints performance figures of the player: `measure.py [--firefox] [--size 1280x800] [--whole] [--browser PROGRAM]
[--display]`. An organ of 20,320 triangles with a painted skin, on the mock server: frames per second while it rotates and
twists, processor time per frame, the resolution chosen by the page, and the time from a seek to its picture. Not a test:
the figures depend on the machine's load."""
import argparse
import os
import sys
import time

import mock_recording
import mock_server
from webdriver import Browser, Firefox

SECONDS = 12
SEEKS = 20

SCRIPT = """
const [width, height, seconds, seeks, whole] = arguments;
const next = window.requestAnimationFrame.bind(window);
let told = 0;
let script_ms = 0; // of the page's own, on the thread that also answers the physician
window.requestAnimationFrame = (draw) => next((now) => {
  const begun = performance.now();
  draw(whole ? (told += 16) : now); // all pixels: the page believes in a fast machine
  script_ms += performance.now() - begun;
});
(async () => {
  const [{ Stage }, { readContainer }, { onBody }, { rendererName }] =
    await Promise.all(['stage', 'container', 'organ', 'gl'].map((one) => import(`/${one}.js`)));
  const file = async (name) => readContainer(await (await fetch(`/measured/${name}`)).arrayBuffer());
  const [recording, organ] = [await file('recording'), onBody(await file('body'), await file('organ'))];
  const tissue = await (await fetch('/quick_tissue.frag')).text();
  const stage = new Stage();
  stage.canvas.style = `position:fixed;left:0;top:0;width:${width}px;height:${height}px;max-width:none;max-height:none`;
  document.body.replaceChildren(stage.canvas);
  if (!stage.open()) throw new Error('no WebGL 2');
  stage.setCase(recording, organ, tissue);
  const side = 1200;
  const paint = new OffscreenCanvas(side, side);
  const pixels = new ImageData(side, side);
  for (let i = 0; i < pixels.data.length; i += 4) {
    const wave = 20 * Math.sin(i / 97) + 20 * Math.sin(i / 4800);
    pixels.data.set([200 + wave, 120 + wave, 110 + wave, 255], i);
  }
  paint.getContext('2d').putImageData(pixels, 0, 0);
  const colour = await createImageBitmap(paint);
  const count = organ.meta.vertices;
  const place = new Float32Array(2 * count);
  for (let i = 0; i < count; ++i) place.set([(i % organ.meta.around) / organ.meta.around * side, Math.floor(i / organ.meta.around) / (count / organ.meta.around) * side], 2 * i);
  stage.setSkin({ width: side, height: side, look: { wetness: 0.38, scatter: 1, relief_mm: 0.3 }, place, colour,
    relief: colour, corner: Uint32Array.from({ length: count }, (_, i) => i), index: organ.arrays.index });
  const painted = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  await painted();
  window.measuring = true;
  const begun = performance.now();
  let frames = 0;
  const late = [];
  let last = begun;
  while (performance.now() - begun < 1000 * seconds) {
    stage.camera.orbit(2, 0);
    stage.setTime(2 + (performance.now() - begun) / 1000);
    await new Promise((done) => requestAnimationFrame(done));
    const now = performance.now();
    if (frames === 0) script_ms = 0;
    if (now - begun > 500 * seconds) { frames += 1; late.push(now - last); } // after it has chosen its size
    last = now;
  }
  window.measuring = false;
  const inner = `${stage.canvas.width}x${stage.canvas.height}`;
  const gl = stage.canvas.getContext('webgl2');
  const sought = async (pause_ms) => {
    const took = [];
    for (let i = 0; i < seeks; ++i) {
      if (pause_ms) await new Promise((done) => setTimeout(done, pause_ms));
      const from = performance.now();
      stage.setTime((i * 7.3) % 18);
      await new Promise((done) => requestAnimationFrame(done));
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      took.push(performance.now() - from);
    }
    return took;
  };
  const middle = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];
  const [dragged, lone] = [await sought(0), await sought(900)];
  window.measured = { frames, script_ms: script_ms / frames, fps: frames / (0.5 * seconds), middle_ms: middle(late), inner,
    seek_ms: middle(dragged), seek_most_ms: Math.max(...dragged), lone_ms: middle(lone), lone_most_ms: Math.max(...lone),
    renderer: rendererName(), triangles: organ.arrays.index.length / 3 };
})().catch((error) => { window.measured = { error: String(error) }; });
"""


def processor_s(root):
    """Processor time of a process and its descendants."""
    children, spent = {}, {}
    for name in os.listdir("/proc"):
        if name.isdigit():
            try:
                with open(f"/proc/{name}/stat") as file:
                    fields = file.read().rsplit(")", 1)[1].split()
            except OSError:
                continue
            children.setdefault(int(fields[1]), []).append(int(name))
            spent[int(name)] = (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
    total, waiting = 0.0, [root]
    while waiting:
        one = waiting.pop()
        total += spent.get(one, 0.0)
        waiting += children.get(one, [])
    return total


def measure(kind, width, height, whole, **options):
    mock_recording.ROUND, mock_recording.ALONG = 80, 128
    organ, body = mock_recording.organ()
    files = {"recording": mock_recording.recording(), "organ": organ, "body": body}
    server, _ = mock_server.start(measured=files)
    with kind(size=(width, height), **options) as browser:
        browser.open(f"http://127.0.0.1:{server.server_address[1]}/")
        browser.there("[name=login]")
        browser.run(SCRIPT, width, height, SECONDS, SEEKS, whole)
        browser.until("it runs", lambda: browser.run("return window.measuring || window.measured"))
        begun, spent = time.monotonic(), processor_s(os.getpid())
        browser.until("it was measured", lambda: time.sleep(1) or browser.run("return window.measuring === false || window.measured?.error"))
        spent, took = processor_s(os.getpid()) - spent, time.monotonic() - begun
        found = browser.until("the seeks too", lambda: browser.run("return window.measured"))
        if "error" in found:
            sys.exit(found["error"])
        print(f"{kind.__name__} ({found['renderer']}) {width}x{height}, {found['triangles']:.0f} triangles: {found['fps']:.0f} pictures a second "
              f"(the middle one {found['middle_ms']:.0f} ms), drawn at {found['inner']}, "
              f"{1000 * spent / max(found['fps'] * took, 1):.0f} ms of processor a picture, {found['script_ms']:.2f} ms of it the page's script; "
              f"seek to picture {found['lone_ms']:.0f} ms, at most {found['lone_most_ms']:.0f} ms; "
              f"one seek upon the other {found['seek_ms']:.0f} ms, at most {found['seek_most_ms']:.0f} ms")
    server.shutdown()


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--firefox", action="store_true")
    arguments.add_argument("--size", default="1280x800")
    arguments.add_argument("--whole", action="store_true", help="all pixels, however long a picture takes")
    arguments.add_argument("--browser", metavar="PROGRAM", help="this one in place of Debian's; Chromium's driver has to fit")
    arguments.add_argument("--display", action="store_true", help="on the screen that is there, with the machine's own renderer")
    given = arguments.parse_args()
    width, height = map(int, given.size.split("x"))
    measure(Firefox if given.firefox else Browser, width, height, given.whole, program=given.browser, display=given.display)


if __name__ == "__main__":
    main()
