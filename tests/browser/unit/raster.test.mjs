// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { OrbitCamera } from '../../../assets/web/orbit.js';
import { rasterPicture } from '../../../assets/web/raster.js';

const kSize = 40;

/// A square across the view with half side `half`, at depth `z` towards the viewer.
function square(half, z, colour, model) {
  const corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
  return { index: new Uint32Array([0, 1, 2, 0, 2, 3]), vertices: new Float32Array(corners.flatMap(([x, y]) => [x, y, z, 0, 0, 0])), colour, model };
}
function camera() {
  const made = new OrbitCamera();
  made.frame({ centre: [0, 0, 0], radius: 10 }, 1);
  return made;
}
const at = (bytes, x, y) => [...bytes.slice(4 * (y * kSize + x), 4 * (y * kSize + x) + 4)];

test('what is nearer hides what is farther, in whichever order they come', () => {
  const [near, far] = [square(3, 5, [255, 0, 0]), square(8, -5, [0, 0, 255])];
  for (const meshes of [[near, far], [far, near]]) {
    const bytes = rasterPicture(meshes, camera(), kSize, kSize);
    const [red, , blue, solid] = at(bytes, 20, 20);
    assert.ok(red > 100 && blue === 0 && solid === 255);
    const [, , beside] = at(bytes, 9, 20);
    assert.ok(beside > 50);
    assert.equal(at(bytes, 0, 0)[3], 0, 'nothing is drawn where nothing is');
  }
});

test('both sides are lit alike, and a model moves what it is given', () => {
  const turned = square(3, 0, [200, 200, 200]);
  turned.index = new Uint32Array([0, 2, 1, 0, 3, 2]);
  assert.deepEqual(at(rasterPicture([turned], camera(), kSize, kSize), 20, 20),
    at(rasterPicture([square(3, 0, [200, 200, 200])], camera(), kSize, kSize), 20, 20));
  const aside = square(2, 0, [200, 200, 200], new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 6, 0, 0, 1]));
  const bytes = rasterPicture([aside], camera(), kSize, kSize);
  assert.equal(at(bytes, 20, 20)[3], 0);
  assert.equal(at(bytes, 30, 20)[3], 255);
});

test('triangles beyond the picture and flat ones harm nothing', () => {
  const odd = square(500, 0, [9, 9, 9]);
  odd.vertices.fill(0, 0, 18);
  assert.equal(rasterPicture([odd], camera(), kSize, kSize).length, 4 * kSize * kSize);
  assert.equal(at(rasterPicture([square(500, 0, [90, 90, 90])], camera(), kSize, kSize), 0, 0)[3], 255);
});
