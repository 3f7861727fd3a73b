// SPDX-License-Identifier: GPL-3.0-or-later
// 3D view of organ and instrument. Draws only on changes; lowers the resolution if frames take too long.
import { h } from './dom.js';
import { drawnByProcessor, joinedTexture, makeMesh, makeProgram, makeTexture, openContext, shadersAreSlow } from './gl.js';
import { addNormals, Morph } from './morph.js';
import { OrbitCamera } from './orbit.js';
import { OrganSum } from './organ_sum.js';
import { ScriptSum } from './script_sum.js';
import { kJoinShader, kJoinVertexShader, kLamps, kSteelShader, kVertexShader, tissueShader } from './shaders.js';
import { jawOpening, poseMatrix, product, turnedAbout } from './tool_pose.js';

const kIdentity = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
const kSteel = [0.66, 0.68, 0.7];
const kWhite = [1, 1, 1];
/// Look of an organ without a painted skin.
const kPlainLook = { wetness: 0.38, scatter: 1, relief_mm: 0 };
/// Resolution relative to the screen; the first may exceed one pixel per CSS pixel.
const kShares = [1, 0.8, 0.6, 0.45];
const kMaxRatio = 2;
const kSlow_ms = 36;
const kVerySlow_ms = 90;
const kJudgedFrames = 8;
const kStill_ms = 300; // after this, redraw in full quality
const kLoneShare = 2; // resolution of single frames on software renderers, so that seeking stays responsive

export class Stage {
  camera = new OrbitCamera();
  canvas = h('canvas', { class: 'stage-canvas', tabindex: '0' });
  #gl = null;
  #time_s = 0;
  #awaits = false;
  #lastFrame_ms = 0;
  #slow_ms = [];
  #share = 0;

  /// False without WebGL 2.
  open() {
    this.#gl = openContext(this.canvas);
    if (!this.#gl) return false;
    this.canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      this.#meshes = null;
    });
    this.canvas.addEventListener('webglcontextrestored', () => this.#upload());
    new ResizeObserver(() => {
      this.#resize();
      this.redraw();
    }).observe(this.canvas);
    return true;
  }

  #meshes = null;
  #toolParts = [];
  /// `recording`, `organ`: containers; `tissue`: source of the window's shader.
  setCase(recording, organ, tissue) {
    this.recording = recording;
    this.organ = new Morph(organ);
    this.source = tissue;
    this.skin = null;
    this.#upload();
    this.fit();
  }
  /// `skin`: from skinOf(); replaces the plain colours.
  setSkin(skin) {
    this.skin = skin;
    this.#upload();
  }
  #upload() {
    const gl = this.#gl;
    if (!this.organ || gl.isContextLost()) return;
    this.tissue = makeProgram(gl, kVertexShader, tissueShader(this.source));
    this.steel = makeProgram(gl, kVertexShader, kSteelShader);
    const { organ } = this;
    const { tool_index: index, tool_mean: mean } = organ.arrays;
    const vertices = new Float32Array(2 * mean.length);
    for (let i = 0; i < mean.length; ++i) vertices[6 * Math.floor(i / 3) + (i % 3)] = mean[i];
    addNormals(index, vertices);
    this.#toolParts = partsOf(index, organ.meta.tool.parts);
    this.#meshes = { organ: this.#organMesh(), tool: makeMesh(gl, { index, vertices, colour: kSteel }) };
    this.#map = this.#skinTexture();
    this.#moved = true;
    gl.enable(gl.DEPTH_TEST);
    this.redraw();
  }
  #map = null;
  #organMesh() {
    const { organ, skin } = this;
    this.sum = new (shadersAreSlow() ? ScriptSum : OrganSum)(this.#gl, organ, skin?.corner);
    const vertices = this.sum.buffer;
    if (!skin) return makeMesh(this.#gl, { vertices, index: organ.index, colour: organ.colour });
    const { place, width, height, index } = skin;
    const map = place.map((value, i) => value / (i % 2 === 0 ? width : height));
    return makeMesh(this.#gl, { vertices, index, map, colour: kWhite });
  }
  #skinTexture() {
    const gl = this.#gl;
    if (!this.skin) return makeTexture(gl, new Uint8Array([255, 255, 255, 128]));
    const { width, height, colour, relief } = this.skin;
    const sources = { colourMap: makeTexture(gl, colour), reliefMap: makeTexture(gl, relief) };
    const joined = joinedTexture(gl, makeProgram(gl, kJoinVertexShader, kJoinShader), width, height, sources);
    Object.values(sources).forEach((one) => gl.deleteTexture(one));
    return joined;
  }

  setTime(time_s) {
    if (time_s === this.#time_s) return;
    this.#time_s = time_s;
    this.#moved = true;
    this.redraw();
  }
  #moved = true;

  fit() {
    if (!this.organ) return;
    this.camera.frame(this.organ.ball(), this.#aspect());
    this.redraw();
  }
  look(from) {
    this.camera.look(from);
    this.fit();
  }
  #aspect() {
    return Math.max(this.canvas.clientWidth, 1) / Math.max(this.canvas.clientHeight, 1);
  }

  /// Draws with the next animation frame.
  redraw() {
    if (this.#awaits || !this.#meshes) return;
    this.#awaits = true;
    requestAnimationFrame((now_ms) => {
      this.#awaits = false;
      if (!this.#meshes || this.canvas.clientWidth === 0) return;
      const lone = drawnByProcessor() && now_ms - this.#lastFrame_ms > kStill_ms;
      const share = this.#sharpens ? 0 : Math.max(this.#share, lone ? kLoneShare : 0);
      this.#still = this.#sharpens;
      if (share !== this.#drawnShare) {
        this.#drawnShare = share;
        this.#resize();
      }
      this.#sharpens = false;
      this.#draw();
      if (!this.#still) this.#judge(now_ms);
    });
  }
  #drawnShare = 0;
  #still = false;
  #sharpens = false;
  #later = null;
  /// Redraws a still picture at full resolution.
  #sharpen() {
    clearTimeout(this.#later);
    if (this.#drawnShare === 0) return;
    this.#later = setTimeout(() => {
      if (this.#awaits) return;
      this.#sharpens = true;
      this.redraw();
    }, kStill_ms);
  }
  #resize() {
    const ratio = Math.min(window.devicePixelRatio || 1, kMaxRatio) * kShares[this.#drawnShare];
    const width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    const height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    if (this.canvas.width === width && this.canvas.height === height) return;
    this.canvas.width = width;
    this.canvas.height = height;
  }
  /// Frames in quick succession show how fast this machine is.
  #judge(now_ms) {
    const took_ms = now_ms - this.#lastFrame_ms;
    this.#lastFrame_ms = now_ms;
    if (took_ms > 500) return; // it was paused
    this.#slow_ms.push(took_ms);
    if (this.#slow_ms.length < kJudgedFrames) return;
    const middle_ms = this.#slow_ms.sort((a, b) => a - b)[kJudgedFrames / 2];
    this.#slow_ms = [];
    if (middle_ms > kSlow_ms && this.#share + 1 < kShares.length) {
      const steps = middle_ms > kVerySlow_ms ? 2 : 1;
      this.#share = Math.min(this.#share + steps, kShares.length - 1);
      this.redraw();
    }
  }

  #draw() {
    const gl = this.#gl;
    if (this.#moved) this.sum.move(this.#time_s);
    this.#moved = false;
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const { wetness, scatter, relief_mm } = this.skin?.look ?? kPlainLook;
    this.#begin(this.tissue);
    gl.bindTexture(gl.TEXTURE_2D, this.#map);
    this.tissue.set('lampColour', kLamps.lampColour);
    for (const name of ['scatterWay', 'scatterRim']) this.tissue.set(name, kLamps[name].map((part) => part * scatter));
    this.tissue.set('wetness', wetness);
    this.tissue.set('relief', relief_mm);
    this.tissue.set('model', kIdentity);
    this.#meshes.organ.draw();
    this.#begin(this.steel);
    this.#drawTool(this.#meshes.tool);
    this.#sharpen();
  }
  /// The operating lamp is fixed in the room; the lamp at the lens moves with the camera.
  #begin(program) {
    const { right, up, back } = this.camera.axes();
    const lens = kLamps.lensDirection;
    program.use();
    program.set('viewProjection', this.camera.matrix(this.#aspect()));
    program.set('eye', this.camera.position());
    program.set('lampDirection', kLamps.lampDirection);
    program.set('lensDirection', [0, 1, 2].map((k) => lens[0] * right[k] + lens[1] * up[k] + lens[2] * back[k]));
  }
  /// meta.tool.parts: {name, first, count} of vertices; 'upper_jaw' opens by +opening_deg about axis and
  /// pivot, 'lower_jaw' by -opening_deg.
  #drawTool(mesh) {
    const pose = poseMatrix(this.recording, this.#time_s);
    const { pivot_mm, axis = [1, 0, 0], opening_deg } = this.organ.meta.tool;
    const opening_rad = (jawOpening(this.recording, this.#time_s) * opening_deg * Math.PI) / 180;
    const sides = { upper_jaw: 1, lower_jaw: -1 };
    for (const { name, first, count } of this.#toolParts) {
      const side = sides[name] ?? 0;
      this.steel.set('model', side === 0 ? pose : product(pose, turnedAbout(axis, pivot_mm, side * opening_rad)));
      mesh.draw(first, count);
    }
  }
}

/// Returns the index range of each part from its vertices; its triangles are contiguous.
function partsOf(index, parts) {
  return parts.map(({ name, first, count }) => {
    const inside = (at) => index[at] >= first && index[at] < first + count;
    let begin = 0;
    while (begin < index.length && !inside(begin)) begin += 3;
    let end = begin;
    while (end < index.length && inside(end)) end += 3;
    return { name, first: begin, count: end - begin };
  });
}
