// SPDX-License-Identifier: GPL-3.0-or-later
// Orbit camera like the window's OrbitCamera: y up, z towards the viewer, millimetres.

const kHighest_deg = 89;
const kZoomPerStep = 0.89;
const kMargin = 1.12; // half height of the view relative to a framed sphere
const kFieldOfView_deg = 32;
const kDegreesPerPixel = 0.35;
const kHalfAngleTangent = Math.tan((kFieldOfView_deg * Math.PI) / 360);

export class OrbitCamera {
  target = [0, 0, 0];
  azimuth_deg = 0;
  elevation_deg = 0;
  #radius = 100;
  #distance = 500;

  /// Frames a sphere in a view with this aspect ratio.
  frame({ centre, radius }, aspect) {
    this.target = [...centre];
    this.#radius = Math.max(radius, 1);
    const halfAngle = Math.atan(kHalfAngleTangent * Math.min(1, aspect));
    this.#distance = (kMargin * this.#radius) / Math.sin(halfAngle);
  }
  /// 'front', 'side' or 'top'.
  look(from) {
    this.azimuth_deg = from === 'side' ? 90 : 0;
    this.elevation_deg = from === 'top' ? kHighest_deg : 0;
  }
  /// Rotates by a drag in pixels.
  orbit(right_px, down_px) {
    this.azimuth_deg = (this.azimuth_deg - kDegreesPerPixel * right_px) % 360;
    const elevation = this.elevation_deg + kDegreesPerPixel * down_px;
    this.elevation_deg = Math.min(Math.max(elevation, -kHighest_deg), kHighest_deg);
  }
  /// Pans by a drag in a view of `height_px`.
  pan(right_px, down_px, height_px) {
    const mmPerPixel = (2 * this.#distance * kHalfAngleTangent) / Math.max(height_px, 1);
    const { right, up } = this.axes();
    this.target = this.target.map((value, i) => value - (right[i] * right_px - up[i] * down_px) * mmPerPixel);
  }
  /// `steps`: notches of a wheel; positive zooms in.
  zoom(steps) {
    const wanted = this.#distance * kZoomPerStep ** steps;
    this.#distance = Math.min(Math.max(wanted, 0.5 * this.#radius), 20 * this.#radius);
  }
  axes() {
    const azimuth = (this.azimuth_deg * Math.PI) / 180;
    const elevation = (this.elevation_deg * Math.PI) / 180;
    const [sa, ca, se, ce] = [Math.sin(azimuth), Math.cos(azimuth), Math.sin(elevation), Math.cos(elevation)];
    return { right: [ca, 0, -sa], up: [-sa * se, ce, -ca * se], back: [sa * ce, se, ca * ce] };
  }
  position() {
    const { back } = this.axes();
    return this.target.map((value, i) => value + back[i] * this.#distance);
  }
  /// Returns view and projection combined, column-major, for this aspect ratio.
  matrix(aspect) {
    const { right, up, back } = this.axes();
    const eye = this.position();
    const along = (axis) => -(axis[0] * eye[0] + axis[1] * eye[1] + axis[2] * eye[2]);
    const view = [right, up, back].map((axis) => [...axis, along(axis)]);
    const near = Math.max(0.05 * this.#distance, this.#distance - 4 * this.#radius);
    const far = this.#distance + 8 * this.#radius;
    const tall = 1 / kHalfAngleTangent;
    const deep = (far + near) / (near - far);
    const shift = (2 * far * near) / (near - far);
    const columns = [];
    for (let i = 0; i < 4; ++i) {
      columns.push((tall / aspect) * view[0][i], tall * view[1][i], deep * view[2][i], -view[2][i]);
    }
    columns[14] += shift;
    return new Float32Array(columns);
  }
}
