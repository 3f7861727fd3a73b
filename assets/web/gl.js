// SPDX-License-Identifier: GPL-3.0-or-later
// The little of WebGL 2 that the stage needs: programs and meshes.

/// Attribute locations of kVertexShader.
const kPosition = 0;
const kNormal = 1;
const kColour = 2;
const kRest = 3;
const kFed = 4;
const kStride_B = 24;

/// A context, or null where the browser has none. Without edges smoothed where the processor draws.
export function openContext(canvas) {
  const options = { alpha: true, antialias: !drawnByProcessor(), powerPreference: 'low-power' };
  return canvas.getContext('webgl2', options);
}

function drawnByProcessor() {
  const probe = document.createElement('canvas').getContext('webgl2');
  if (!probe) return true;
  const about = probe.getExtension('WEBGL_debug_renderer_info');
  const name = about ? probe.getParameter(about.UNMASKED_RENDERER_WEBGL) : '';
  probe.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

/// {use(), set: {name: function}} for the uniforms of the program. Throws Error where it does not compile.
export function makeProgram(gl, vertexSource, fragmentSource) {
  const program = gl.createProgram();
  for (const [kind, source] of [[gl.VERTEX_SHADER, vertexSource], [gl.FRAGMENT_SHADER, fragmentSource]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  const at = (name) => gl.getUniformLocation(program, name);
  const places = Object.fromEntries(['model', 'viewProjection', 'eye', 'headlight', 'fine', 'blood'].map((n) => [n, at(n)]));
  return {
    use: () => gl.useProgram(program),
    model: (matrix) => gl.uniformMatrix4fv(places.model, false, matrix),
    viewProjection: (matrix) => gl.uniformMatrix4fv(places.viewProjection, false, matrix),
    eye: (point) => gl.uniform3fv(places.eye, point),
    headlight: (matrix) => gl.uniformMatrix3fv(places.headlight, false, matrix),
    fine: (on) => gl.uniform1f(places.fine, on ? 1 : 0),
    blood: (factor) => gl.uniform3fv(places.blood, factor),
  };
}

/// `vertices`: x y z nx ny nz each; `colour`: three u8 each, or one colour for all; `rest`: x y z each, or null;
/// `fed`: one u8 each, how far the uniform `blood` colours it, or null.
export function makeMesh(gl, { index, vertices, colour, rest = null, fed = null, moves = false }) {
  const array = gl.createVertexArray();
  gl.bindVertexArray(array);
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.bufferData(gl.ARRAY_BUFFER, vertices, moves ? gl.DYNAMIC_DRAW : gl.STATIC_DRAW);
  gl.enableVertexAttribArray(kPosition);
  gl.vertexAttribPointer(kPosition, 3, gl.FLOAT, false, kStride_B, 0);
  gl.enableVertexAttribArray(kNormal);
  gl.vertexAttribPointer(kNormal, 3, gl.FLOAT, false, kStride_B, 12);
  const still = (place, data, type, normalised, size = 3) => {
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, size, type, normalised, 0, 0);
  };
  const oneColour = colour.length === 3;
  if (!oneColour) still(kColour, colour, gl.UNSIGNED_BYTE, true);
  if (rest) still(kRest, rest, gl.FLOAT, false);
  if (fed) still(kFed, fed, gl.UNSIGNED_BYTE, true, 1);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, index, gl.STATIC_DRAW);
  gl.bindVertexArray(null);
  return {
    move(fresh) {
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferSubData(gl.ARRAY_BUFFER, 0, fresh);
    },
    draw(first = 0, count = index.length) {
      gl.bindVertexArray(array);
      if (oneColour) gl.vertexAttrib3f(kColour, ...colour);
      if (!fed) gl.vertexAttrib1f(kFed, 0);
      gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 4 * first);
    },
  };
}
