// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { readContainer } from '../../../assets/web/container.js';
import { fanned, Morph } from '../../../assets/web/morph.js';
import { onBody } from '../../../assets/web/organ.js';
import { OrbitCamera } from '../../../assets/web/orbit.js';
import { joined, Playback } from '../../../assets/web/playback.js';
import { kLamps } from '../../../assets/web/shaders.js';
import { clockTenths, dayText, joinedSentences } from '../../../assets/web/numbers.js';
import { lane, scaleText, sizeText } from '../../../assets/web/trace_lane.js';
import { filledIn, useTexts } from '../../../assets/web/texts.js';
import { jawOpening, poseMatrix, turnedAbout } from '../../../assets/web/tool_pose.js';
import { ViewingReporter } from '../../../assets/web/viewing_reporter.js';
import { NoConnection } from '../../../assets/web/api.js';

function container(meta, arrays) {
  const body = Buffer.concat(arrays.map((one) => Buffer.from(one.values.buffer)));
  let offset = 0;
  const head = arrays.map(({ name, type, values }) => {
    const entry = { name, type, offset, count: values.length };
    offset += values.byteLength;
    return entry;
  });
  let json = JSON.stringify({ meta, arrays: head });
  json += ' '.repeat((4 - ((8 + json.length) % 4)) % 4);
  const made = Buffer.alloc(8 + json.length + body.length);
  made.write('TRS1');
  made.writeUInt32LE(json.length, 4);
  made.write(json, 8);
  body.copy(made, 8 + json.length);
  return new Uint8Array(made).buffer;
}

test('a container is parsed by its header, and a malformed one rejected', () => {
  const bytes = container({ rate_hz: 60 }, [
    { name: 'angle_deg', type: 'f32', values: new Float32Array([1.5, 2.5]) },
    { name: 'closed', type: 'u8', values: new Uint8Array([0, 1, 1, 0]) },
  ]);
  const { meta, arrays } = readContainer(bytes);
  assert.equal(meta.rate_hz, 60);
  assert.deepEqual([...arrays.angle_deg], [1.5, 2.5]);
  assert.deepEqual([...arrays.closed], [0, 1, 1, 0]);
  assert.throws(() => readContainer(bytes.slice(0, 20)), RangeError);
  assert.throws(() => readContainer(new ArrayBuffer(12)), RangeError);
});

test('differences are summed, wrap like their type, and are multiplied by a scale', () => {
  const body = Buffer.from(new Int16Array([30000, 1, 10000, 1, 2, 3]).buffer);
  const made = (entry) => {
    const bytes = Buffer.from(container({}, [{ name: 'x', type: 'i16', values: new Int16Array([30000, 1, 10000, 1]) }]));
    const text = bytes.toString('latin1').replace('"count":4', `"count":4,${entry}`);
    const head = text.slice(8, text.length - 8).trimEnd();
    const json = head + ' '.repeat((4 - ((8 + head.length) % 4)) % 4);
    const whole = Buffer.alloc(8 + json.length + 8);
    whole.write('TRS1');
    whole.writeUInt32LE(json.length, 4);
    whole.write(json, 8);
    body.copy(whole, 8 + json.length, 0, 8);
    return new Uint8Array(whole).buffer;
  };
  assert.deepEqual([...readContainer(made('"delta":2')).arrays.x], [30000, 1, -25536, 2]);
  assert.deepEqual([...readContainer(made('"delta":2,"scale":0.5')).arrays.x], [15000, 0.5, -12768, 1]);
});

/// One triangle in the plane z = 0 whose third corner rises by 2 mm per unit of weight.
const kTriangle = {
  meta: { vertices: 3, components: 1, scale: [0.001] },
  arrays: {
    index: new Uint32Array([0, 1, 2]),
    mean: new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]),
    basis: new Int16Array([0, 0, 0, 0, 0, 0, 0, 0, 2000]),
    weights: new Float32Array([0, 1, 1]),
    time_ms: new Uint32Array([0, 500, 1000]),
    colour: new Uint8Array(9),
  },
};

test('the organ is the mean plus weighted components, linear between frames', () => {
  const morph = new Morph(kTriangle);
  const heights = [-1, 0, 0.125, 0.25, 0.5, 9].map((time_s) => morph.evaluate(time_s)[14]);
  assert.deepEqual(heights, [0, 0, 0.5, 1, 2, 2].map(Math.fround));
});

test('blood, then damage, colours each vertex by its share in the frame', () => {
  assert.equal(new Morph(kTriangle).tintsAt(0.5), null);
  const arrays = {
    ...kTriangle.arrays,
    blood: new Float32Array([1, 1, 1, 0.5, 0.25, 0.75, 0, 0, 0]),
    fed: new Uint8Array([0, 51, 255]),
    paint: new Uint8Array([255, 0, 0, 0, 0, 102]),
  };
  const paints = [{ factor: [0.5, 0, 1], from: 1, to: 2 }, { factor: [1, 1, 0], from: 2, to: 3 }];
  const twisted = new Morph({ meta: { ...kTriangle.meta, paints }, arrays });
  const near = (time_s, wanted) => [...twisted.tintsAt(time_s)].forEach((value, i) => assert.ok(Math.abs(value - wanted[i]) < 1e-6, `${time_s} ${i}: ${value}`));
  near(-1, [1, 1, 1, 1, 1, 1, 1, 1, 1]);
  near(0.5, [0.5, 0, 1, 0.9, 0.85, 0.95, 0.5, 0.25, 0.75]);
  near(9, [1, 1, 1, 0.8, 0.8, 0.8, 0.4, 0.4, 0]);
});

test("a recording's own displacements follow those of the organ's body", () => {
  const part = (scale, steps) => ({ meta: { components: scale.length, scale }, arrays: { basis: new Int16Array(steps) } });
  const body = part([0.001, 0.01], [1, 2, 3, 4, 5, 6]);
  body.arrays.mean = new Float32Array(3);
  const moved = part([0.1], [7, 8, 9]);
  const organ = onBody(body, { meta: { ...moved.meta, frames: 5 }, arrays: { ...moved.arrays, weights: new Float32Array(15) } });
  assert.deepEqual([...organ.arrays.basis], [1, 2, 3, 4, 5, 6, 7, 8, 9]);
  assert.deepEqual(organ.meta, { components: 3, scale: [0.001, 0.01, 0.1], frames: 5 });
  assert.equal(organ.arrays.mean.length, 3);
  assert.deepEqual(body.meta.scale, [0.001, 0.01], 'the next recording has the same body');
});

test('a fan has every triangle around its vertex in winding order', () => {
  const { first, others } = fanned([0, 1, 2, 2, 1, 3], 5);
  const fan = (v) => [...others.subarray(2 * first[v], 2 * first[v + 1])];
  assert.deepEqual(fan(1), [2, 0, 3, 2]);
  const round = fanned([0, 1, 2, 0, 3, 4, 0, 2, 3, 0, 4, 1], 5);
  assert.deepEqual([...round.others.subarray(0, 8)], [1, 2, 2, 3, 3, 4, 4, 1], 'each begins where the one before ended');
  assert.deepEqual([0, 1, 2, 3, 4].map(fan), [[1, 2], [2, 0, 3, 2], [0, 1, 1, 3], [2, 1], []]);
});

test('bruises and clips are drawn only in their frames', () => {
  const paints = [{ factor: [0, 0, 0], from: 1, to: 2 }, { factor: [1, 1, 0], from: 1, to: 3 }];
  const arrays = { ...kTriangle.arrays, fed: new Uint8Array(3), blood: new Float32Array([1, 1, 1, 0.5, 0.25, 0.75, 0, 0, 0]) };
  const morph = new Morph({ meta: { ...kTriangle.meta, paints }, arrays });
  assert.deepEqual([0, 0.5, 1].map((time_s) => morph.coloursAt(time_s).paints.map((one) => one.layer)), [[], [0, 1], [1]]);
  assert.deepEqual([...morph.coloursAt(0.5).blood], [0.5, 0.25, 0.75]);
  assert.deepEqual(new Morph(kTriangle).coloursAt(0.5), { blood: [1, 1, 1], paints: [] });
});

test("the lamps match the window's", () => {
  const scene = readFileSync(new URL('../../../app/gui/scene/scene_view.qml', import.meta.url), 'utf8');
  const said = (pattern) => {
    const found = scene.match(pattern);
    assert.ok(found, `${pattern} is in scene_view.qml`);
    return found.slice(1, 4).map(Number);
  };
  const three = '\\((-?[\\d.]+), (-?[\\d.]+), (-?[\\d.]+)\\)';
  assert.deepEqual(kLamps.lampDirection, said(new RegExp(`vector3d lampDirection: Qt.vector3d${three}`)));
  assert.deepEqual(kLamps.lensDirection, said(new RegExp(`vector3d lensDirection: .*Qt.vector3d${three}`)));
  assert.deepEqual(kLamps.lampColour, said(new RegExp(`vector3d lampColour: Qt.vector3d${three}`)));
  assert.deepEqual(kLamps.scatterWay, said(new RegExp(`vector3d scatterWay: Qt.vector3d${three}.times.root.scatter`)));
  assert.deepEqual(kLamps.scatterRim, said(new RegExp(`vector3d scatterRim: Qt.vector3d${three}.times.root.scatter`)));
});

test('normals follow the present triangles', () => {
  const morph = new Morph(kTriangle);
  assert.deepEqual([...morph.evaluate(0).slice(3, 6)], [0, 0, 1]);
  const [x, y, z] = morph.evaluate(0.5).slice(3, 6); // (1,0,0) x (0,1,2)
  assert.deepEqual([x, y, z].map((one) => Math.round(1e6 * one) / 1e6), [0, -2, 1]);
});

test('the bounding sphere contains every vertex, including the last shape', () => {
  const { centre, radius } = new Morph(kTriangle).ball();
  assert.deepEqual(centre, [0.5, 0.5, 1]);
  assert.ok(Math.abs(radius - Math.sqrt(1.5)) < 1e-6);
});

test('the instrument rotates the shorter way, and its jaw moves with it', () => {
  const recording = {
    meta: { rate_hz: 10, frames: 2 },
    arrays: { tool: new Float32Array([0, 0, 0, 1, 0, 0, 0, 10, 0, 0, -1, 0, 0, 0]), closed: new Uint8Array([255, 0]) },
  };
  const middle = poseMatrix(recording, 0.05);
  assert.deepEqual([...middle].map((one) => Math.round(1e3 * one) / 1e3), [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1]);
  assert.deepEqual([0, 0.025, 9].map((time_s) => jawOpening(recording, time_s)), [0, 0.25, 1]);
  const turn = turnedAbout([1, 0, 0], [0, 0, 20], Math.PI / 2);
  const at = (x, y, z) => [0, 1, 2].map((row) => turn[row] * x + turn[4 + row] * y + turn[8 + row] * z + turn[12 + row]);
  assert.deepEqual(at(0, 0, 20).map(Math.round), [0, 0, 20]);
  assert.deepEqual(at(0, 0, 0).map(Math.round), [0, 20, 20]);
});

test('a framed sphere fills the view from each side', () => {
  const camera = new OrbitCamera();
  for (const from of ['front', 'side', 'top']) {
    camera.look(from);
    camera.frame({ centre: [10, 20, 30], radius: 50 }, 1.6);
    const m = camera.matrix(1.6);
    const { up } = camera.axes();
    const shown = (p) => {
      const w = m[3] * p[0] + m[7] * p[1] + m[11] * p[2] + m[15];
      return [0, 1, 2].map((row) => (m[row] * p[0] + m[4 + row] * p[1] + m[8 + row] * p[2] + m[12 + row]) / w);
    };
    const middle = shown([10, 20, 30]);
    assert.ok(Math.hypot(middle[0], middle[1]) < 1e-5 && Math.abs(middle[2]) < 1, from);
    const top = shown([10, 20, 30].map((value, i) => value + 50 * up[i]));
    assert.ok(top[1] > 0.8 && top[1] < 1, `${from}: ${top[1]}`);
  }
});

test('playing counts elapsed time without long pauses of the window, and stops at the end', () => {
  const playback = new Playback(1_000_000, [0.5, 1]);
  playback.toggle();
  assert.deepEqual(playback.advance(0.1), { from_us: 0, to_us: 100_000, speed: 1 });
  assert.equal(playback.advance(60).to_us, 350_000);
  playback.changeSpeed(-1);
  playback.changeSpeed(-1);
  assert.deepEqual(playback.advance(0.2), { from_us: 350_000, to_us: 450_000, speed: 0.5 });
  playback.changeSpeed(+1);
  for (let i = 0; i < 3; ++i) playback.advance(0.25);
  assert.equal(playback.position_us, 1_000_000);
  assert.equal(playback.playing, false);
  assert.equal(playback.advance(0.1), null);
  playback.toggle();
  assert.equal(playback.position_us, 0);
});

test('intervals are merged', () => {
  assert.deepEqual(joined([[5, 9], [0, 2], [2, 4], [6, 12], [3, 3]]), [[0, 4], [5, 12]]);
});

test('playback is reported every two seconds, and again without an answer', async () => {
  let now = 0;
  const sent = [];
  let away = true;
  const reporter = new ViewingReporter({
    post: async ({ played }) => {
      sent.push(played);
      if (away) throw new NoConnection();
      return {};
    },
    onAnswer: () => {},
    now: () => now,
  });
  reporter.played({ from_us: 0, to_us: 10, speed: 1 });
  reporter.played({ from_us: 10, to_us: 20, speed: 1 });
  assert.equal(sent.length, 0);
  now = 2000;
  reporter.played({ from_us: 50, to_us: 60, speed: 1 });
  await reporter.underway;
  const stretches = [{ from_us: 0, to_us: 20, speed: 1 }, { from_us: 50, to_us: 60, speed: 1 }];
  assert.deepEqual(sent, [stretches]);
  assert.deepEqual(reporter.unreported, stretches);
  away = false;
  await reporter.report();
  assert.deepEqual(sent[1], stretches);
  assert.deepEqual(reporter.unreported, []);
  await reporter.report();
  assert.equal(sent.length, 2);
});

test('values and plural of a sentence are filled in one pass', () => {
  assert.equal(filledIn('%1 {case fits|cases fit} into %2', ['1', 'ten']), '1 case fits into ten');
  assert.equal(filledIn('%1 {case fits|cases fit}', ['3']), '3 cases fit');
  assert.equal(filledIn('%1: %2', ['%2', 'x']), '%2: x');
  assert.equal(filledIn('%3 {a', ['1']), '%3 {a');
});

test('a trace includes zero and its limit; small torques of an untwisting are shown in thousandths', () => {
  const torque = { name: 'Torque', unit: 'N m', decimals: 3, low: new Float32Array([0, -0.04, -0.02]) };
  const turned = lane({ ...torque, limit: 0.05 });
  assert.equal(turned.limit, -0.05);
  assert.ok(turned.bottom < -0.05 && turned.top === 0);
  assert.equal(scaleText(turned), '\u22120.053\u20260 N m');
  const undone = lane({ ...torque, fine: true });
  assert.equal(scaleText(undone), '\u221240\u20260 mN m');
  assert.equal(sizeText(undone, -0.0201), '\u221220 mN m');
  const angle = lane({ name: 'Angle', unit: '\u00b0', low: new Float32Array([0, 90]), band: { target: [180, 180], tolerance: 10 } });
  assert.ok(angle.top > 190);
  const force = lane({ name: 'Force', unit: 'N', decimals: 2, low: new Float32Array([0, 3.3]) });
  assert.equal(sizeText(force, 3.3), '3.30 N');
});

test('a moment is rounded to tenths: the last sample of 0:20 is one tick before it', () => {
  assert.equal(clockTenths(0), '0:00.0');
  assert.equal(clockTenths(11_849_000), '0:11.8');
  assert.equal(clockTenths(19_999_000), '0:20.0');
  assert.equal(clockTenths(125_400_000), '2:05.4');
});

test('sentences are joined with a blank, in Chinese without', () => {
  assert.equal(joinedSentences(['Done.', '', 'Go on.']), 'Done. Go on.');
  assert.equal(joinedSentences(['\u5df2\u5b8c\u6210\u3002', '\u8bf7\u7ee7\u7eed\u3002']), '\u5df2\u5b8c\u6210\u3002\u8bf7\u7ee7\u7eed\u3002');
});

test("a date is formatted as in the window, in English with the month's name", () => {
  const noon_us = 1_767_600_000_000_000; // 5 January 2026, 08:00 UTC
  assert.equal(dayText(noon_us), '5 Jan 2026');
  useTexts({ texts: {}, language: 'zh_CN' });
  assert.equal(dayText(noon_us), '2026/1/5');
  useTexts({ texts: {}, language: 'en' });
});
