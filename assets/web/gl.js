// SPDX-License-Identifier: GPL-3.0-or-later
// Minimal WebGL 2 helpers for the stage: programs and meshes.

/// Attribute locations of kVertexShader.
const kPosition = 0;
const kNormal = 1;
const kColour = 2;
const kMap = 3;
const kFactor = 4;
const kStride_B = 24;
/// Position, normal, colour factor: three floats each.
export const kCorner_B = 36;

/// Returns a context, or null if unsupported. No antialiasing on software renderers.
export function openContext(canvas) {
  const options = { alpha: true, antialias: !drawnByProcessor(), powerPreference: 'low-power' };
  return canvas.getContext('webgl2', options);
}

let known = null;
/// Returns the browser's name of the renderer; empty without WebGL 2.
export function rendererName() {
  if (known !== null) return known;
  const probe = document.createElement('canvas').getContext('webgl2');
  const about = probe?.getExtension('WEBGL_debug_renderer_info');
  known = about ? String(probe.getParameter(about.UNMASKED_RENDERER_WEBGL)) : '';
  probe?.getExtension('WEBGL_lose_context')?.loseContext();
  return known;
}
export function drawnByProcessor() {
  return /swiftshader|llvmpipe|software|basic render/i.test(rendererName());
}
/// SwiftShader takes about 40 ms for what the script sums in 2 ms; llvmpipe is twice as fast as the script.
export function shadersAreSlow() {
  return /swiftshader/i.test(rendererName());
}

/// Returns {use(); set(name, value): a number, vector of three or matrix; setWhole(name, value): integers or
/// a texture unit; setEach(name, values): an array of numbers}. Throws Error if it does not compile.
export function makeProgram(gl, vertexSource, fragmentSource) {
  return linked(gl, vertexSource, fragmentSource, []);
}

const kNothingShader = `#version 300 es
void main() {}`;

/// A transform feedback program: write(buffer, count) runs its vertex shader for `count` vertices of the
/// bound array and writes `outputs` interleaved to the buffer.
export function makeFeedback(gl, vertexSource, outputs) {
  const program = linked(gl, vertexSource, kNothingShader, outputs);
  return {
    ...program,
    write(buffer, count) {
      gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
      gl.beginTransformFeedback(gl.POINTS);
      gl.drawArrays(gl.POINTS, 0, count);
      gl.endTransformFeedback();
      gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, null);
    },
  };
}

function linked(gl, vertexSource, fragmentSource, outputs) {
  const program = gl.createProgram();
  for (const [kind, source] of [[gl.VERTEX_SHADER, vertexSource], [gl.FRAGMENT_SHADER, fragmentSource]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  if (outputs.length) gl.transformFeedbackVaryings(program, outputs, gl.INTERLEAVED_ATTRIBS);
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  const places = new Map();
  const at = (name) => {
    if (!places.has(name)) places.set(name, gl.getUniformLocation(program, name));
    return places.get(name);
  };
  return {
    use: () => gl.useProgram(program),
    set(name, value) {
      if (value.length === undefined) gl.uniform1f(at(name), value);
      else if (value.length === 16) gl.uniformMatrix4fv(at(name), false, value);
      else gl.uniform3fv(at(name), value);
    },
    setWhole: (name, value) => gl.uniform1iv(at(name), value.length === undefined ? [value] : value),
    setEach: (name, values) => gl.uniform1fv(at(name), values),
  };
}

/// Binds new values, or an existing buffer, to an attribute of the bound array. Integers stay integers unless
/// `normalised`, which maps 255 to 1.
export function attribute(gl, place, values, size, { normalised = false, stride = 0, offset = 0 } = {}) {
  const kinds = new Map([[Uint8Array, gl.UNSIGNED_BYTE], [Uint32Array, gl.UNSIGNED_INT]]);
  const there = values instanceof WebGLBuffer;
  gl.bindBuffer(gl.ARRAY_BUFFER, there ? values : gl.createBuffer());
  if (!there) gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
  const kind = kinds.get(values.constructor) ?? gl.FLOAT;
  gl.enableVertexAttribArray(place);
  if (kind === gl.FLOAT || normalised) gl.vertexAttribPointer(place, size, kind, normalised, stride, offset);
  else gl.vertexAttribIPointer(place, size, kind, stride, offset);
}

/// `vertices`: x y z nx ny nz each, or a buffer of corners with colour factors (organ_sum.js); `colour`:
/// three u8 per vertex, or one colour for all; `map`: two skin coordinates per vertex, 0 .. 1, or null.
export function makeMesh(gl, { index, vertices, colour, map = null }) {
  const array = gl.createVertexArray();
  gl.bindVertexArray(array);
  const moving = vertices instanceof WebGLBuffer;
  const stride = moving ? kCorner_B : kStride_B;
  const shared = moving ? vertices : bufferOf(gl, vertices);
  attribute(gl, kPosition, shared, 3, { stride });
  attribute(gl, kNormal, shared, 3, { stride, offset: 12 });
  if (moving) attribute(gl, kFactor, shared, 3, { stride, offset: 24 });
  const oneColour = colour.length === 3;
  if (!oneColour) attribute(gl, kColour, colour, 3, { normalised: true });
  if (map) attribute(gl, kMap, map, 2);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, index, gl.STATIC_DRAW);
  gl.bindVertexArray(null);
  return {
    draw(first = 0, count = index.length) {
      gl.bindVertexArray(array);
      if (oneColour) gl.vertexAttrib3f(kColour, ...colour);
      if (!moving) gl.vertexAttrib3f(kFactor, 1, 1, 1);
      gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 4 * first);
    },
  };
}

function bufferOf(gl, values) {
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
  return buffer;
}

/// A data texture that shaders index: 1024 texels per row, `layers` in sequence. `make()` fills it while it
/// is bound.
export function tableTexture(gl, kind, make) {
  const texture = gl.createTexture();
  gl.bindTexture(kind, texture);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  make();
  for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(kind, filter, gl.NEAREST);
  return texture;
}

/// A texture of an ImageBitmap, or of a single RGBA colour.
export function makeTexture(gl, picture) {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
  if (picture instanceof Uint8Array) {
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, picture);
  } else {
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, picture);
  }
  for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
  return texture;
}

/// Renders a texture of this size from others, {name: texture}, by a program without attributes.
export function joinedTexture(gl, program, width, height, sources) {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1 + Math.floor(Math.log2(Math.max(width, height))), gl.RGBA8, width, height);
  const frame = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  gl.viewport(0, 0, width, height);
  gl.disable(gl.DEPTH_TEST);
  program.use();
  Object.entries(sources).forEach(([name, source], unit) => {
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, source);
    program.setWhole(name, unit);
  });
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.deleteFramebuffer(frame);
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.generateMipmap(gl.TEXTURE_2D);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
  for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
  return texture;
}
