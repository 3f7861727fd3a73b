// SPDX-License-Identifier: GPL-3.0-or-later
// Software rasteriser for browsers without WebGL: z-buffer, light from the upper left. Independent of the
// page.

const kFloatsAVertex = 6; // x y z, nx ny nz; as Morph has them
const kKeyLight = [-0.45, 0.72, 0.53];
const kShade = 0.42; // ambient share of the light

/// Projects vertices onto a picture of this size: x, y, depth each.
function placed(vertices, matrix, model, width, height) {
  const count = vertices.length / kFloatsAVertex;
  const places = new Float32Array(3 * count);
  const worlds = new Float32Array(3 * count);
  for (let i = 0; i < count; ++i) {
    const o = kFloatsAVertex * i;
    for (let k = 0; k < 3; ++k) {
      worlds[3 * i + k] = model
        ? model[k] * vertices[o] + model[4 + k] * vertices[o + 1] + model[8 + k] * vertices[o + 2] + model[12 + k]
        : vertices[o + k];
    }
    const [x, y, z] = [worlds[3 * i], worlds[3 * i + 1], worlds[3 * i + 2]];
    const w = matrix[3] * x + matrix[7] * y + matrix[11] * z + matrix[15];
    places[3 * i] = (0.5 + (0.5 * (matrix[0] * x + matrix[4] * y + matrix[8] * z + matrix[12])) / w) * width;
    places[3 * i + 1] = (0.5 - (0.5 * (matrix[1] * x + matrix[5] * y + matrix[9] * z + matrix[13])) / w) * height;
    places[3 * i + 2] = (matrix[2] * x + matrix[6] * y + matrix[10] * z + matrix[14]) / w;
  }
  return { places, worlds };
}

/// Returns the light on a two-sided triangle: 0 .. 1.
function lightOn(worlds, a, b, c, light) {
  const [ux, uy, uz] = [0, 1, 2].map((k) => worlds[b + k] - worlds[a + k]);
  const [vx, vy, vz] = [0, 1, 2].map((k) => worlds[c + k] - worlds[a + k]);
  const n = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const length = Math.hypot(...n) || 1;
  return { n, share: (n[0] * light[0] + n[1] * light[1] + n[2] * light[2]) / length };
}

/// Returns RGBA bytes, transparent where nothing is drawn. `meshes`: {index, vertices, colour, model};
/// colour: three bytes per vertex or three for all; model: column-major matrix, or missing. `camera`:
/// matrix() and axes() of OrbitCamera.
export function rasterPicture(meshes, camera, width, height) {
  const bytes = new Uint8ClampedArray(4 * width * height);
  const depths = new Float32Array(width * height).fill(Infinity);
  const { right, up, back } = camera.axes();
  const light = [0, 1, 2].map((k) => kKeyLight[0] * right[k] + kKeyLight[1] * up[k] + kKeyLight[2] * back[k]);
  const matrix = camera.matrix(width / height);
  for (const { index, vertices, colour, model } of meshes) {
    const { places, worlds } = placed(vertices, matrix, model, width, height);
    for (let i = 0; i < index.length; i += 3) {
      const [a, b, c] = [3 * index[i], 3 * index[i + 1], 3 * index[i + 2]];
      const { n, share } = lightOn(worlds, a, b, c, light);
      const towards = n[0] * back[0] + n[1] * back[1] + n[2] * back[2] < 0 ? -share : share;
      const shade = kShade + (1 - kShade) * Math.max(towards, 0);
      const paint = [0, 1, 2].map((k) => shade * (colour.length === 3 ? colour[k] : (colour[a + k] + colour[b + k] + colour[c + k]) / 3));
      fill({ bytes, depths, width, height }, places, a, b, c, paint);
    }
  }
  return bytes;
}

function fill({ bytes, depths, width, height }, p, a, b, c, paint) {
  const area = (p[b] - p[a]) * (p[c + 1] - p[a + 1]) - (p[c] - p[a]) * (p[b + 1] - p[a + 1]);
  if (!(Math.abs(area) > 1e-9)) return;
  const left = Math.max(Math.floor(Math.min(p[a], p[b], p[c])), 0);
  const last = Math.min(Math.ceil(Math.max(p[a], p[b], p[c])), width - 1);
  const top = Math.max(Math.floor(Math.min(p[a + 1], p[b + 1], p[c + 1])), 0);
  const bottom = Math.min(Math.ceil(Math.max(p[a + 1], p[b + 1], p[c + 1])), height - 1);
  for (let y = top; y <= bottom; ++y) {
    for (let x = left; x <= last; ++x) {
      const [px, py] = [x + 0.5, y + 0.5];
      const ofB = ((px - p[a]) * (p[c + 1] - p[a + 1]) - (p[c] - p[a]) * (py - p[a + 1])) / area;
      const ofC = ((p[b] - p[a]) * (py - p[a + 1]) - (px - p[a]) * (p[b + 1] - p[a + 1])) / area;
      if (ofB < 0 || ofC < 0 || ofB + ofC > 1) continue;
      const depth = p[a + 2] + ofB * (p[b + 2] - p[a + 2]) + ofC * (p[c + 2] - p[a + 2]);
      const at = y * width + x;
      if (depth >= depths[at]) continue;
      depths[at] = depth;
      bytes.set(paint, 4 * at);
      bytes[4 * at + 3] = 255;
    }
  }
}
