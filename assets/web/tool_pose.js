// SPDX-License-Identifier: GPL-3.0-or-later
// Pose and jaw opening of the instrument at any time of the recording. Independent of WebGL.

const kFloatsAPose = 7; // x y z mm, quaternion w x y z

/// Returns the frames around a time and the fraction between them.
function momentOf({ rate_hz, frames }, time_s) {
  const at = Math.min(Math.max(time_s * rate_hz, 0), frames - 1);
  const before = Math.floor(at);
  return { before, after: Math.min(before + 1, frames - 1), share: at - before };
}

/// Returns the column-major model matrix from instrument frame to view frame.
export function poseMatrix({ meta, arrays }, time_s) {
  const { tool } = arrays;
  const { before, after, share } = momentOf(meta, time_s);
  const a = tool.subarray(kFloatsAPose * before, kFloatsAPose * (before + 1));
  const b = tool.subarray(kFloatsAPose * after, kFloatsAPose * (after + 1));
  // Take the shorter way between the orientations.
  const way = a[3] * b[3] + a[4] * b[4] + a[5] * b[5] + a[6] * b[6] < 0 ? -1 : 1;
  const between = (i, sign) => a[i] * (1 - share) + sign * b[i] * share;
  const q = [3, 4, 5, 6].map((i) => between(i, way));
  const length = Math.hypot(...q) || 1;
  return rigid(q.map((value) => value / length), [0, 1, 2].map((i) => between(i, 1)));
}

/// Returns 0 closed, 1 open; the recording stores how far it is closed in 255 steps.
export function jawOpening({ meta, arrays }, time_s) {
  const { before, after, share } = momentOf(meta, time_s);
  return 1 - (arrays.closed[before] * (1 - share) + arrays.closed[after] * share) / 255;
}

/// Returns the rotation of a jaw by `angle_rad` about the axis through the pivot.
export function turnedAbout(axis, pivot, angle_rad) {
  const half = 0.5 * angle_rad;
  const q = [Math.cos(half), ...axis.map((value) => value * Math.sin(half))];
  const turn = rigid(q, [0, 0, 0]);
  for (let row = 0; row < 3; ++row) {
    turn[12 + row] = pivot[row] - (turn[row] * pivot[0] + turn[4 + row] * pivot[1] + turn[8 + row] * pivot[2]);
  }
  return turn;
}

/// Returns a * b, 4 x 4, column-major.
export function product(a, b) {
  const made = new Float32Array(16);
  for (let column = 0; column < 4; ++column) {
    for (let row = 0; row < 4; ++row) {
      for (let i = 0; i < 4; ++i) made[4 * column + row] += a[4 * i + row] * b[4 * column + i];
    }
  }
  return made;
}

function rigid([w, x, y, z], [px, py, pz]) {
  return new Float32Array([
    1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y), 0,
    2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x), 0,
    2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y), 0,
    px, py, pz, 1,
  ]);
}
