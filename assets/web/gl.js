// SPDX-License-Identifier: GPL-3.0-or-later
// The little of WebGL 2 that the stage needs: programs and meshes.

/// Attribute locations of kVertexShader.
const kPosition = 0;
const kNormal = 1;
const kColour = 2;
const kMap = 3;
const kFactor = 4;
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

/// {use(), and set(name, value): a number, three numbers, nine or sixteen}. Throws Error where it does not compile.
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
  const places = new Map();
  const at = (name) => {
    if (!places.has(name)) places.set(name, gl.getUniformLocation(program, name));
    return places.get(name);
  };
  return {
    use: () => gl.useProgram(program),
    unit: (name, number) => gl.uniform1i(at(name), number),
    set(name, value) {
      if (value.length === undefined) gl.uniform1f(at(name), value);
      else if (value.length === 3) gl.uniform3fv(at(name), value);
      else gl.uniformMatrix4fv(at(name), false, value);
    },
  };
}

/// `vertices`: x y z nx ny nz each; `colour`: three u8 each, or one colour for all; `map`: place on the skin's picture,
/// 0 .. 1, two each, or null; `tinted`: a factor on the colour each, three floats, that move() brings.
export function makeMesh(gl, { index, vertices, colour, map = null, tinted = false, moves = false }) {
  const array = gl.createVertexArray();
  gl.bindVertexArray(array);
  const bound = (size_B, use, place, type, normalised, size, stride = 0, offset = 0) => {
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, size_B, use);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, size, type, normalised, stride, offset);
    return buffer;
  };
  const buffer = bound(vertices, moves ? gl.DYNAMIC_DRAW : gl.STATIC_DRAW, kPosition, gl.FLOAT, false, 3, kStride_B);
  gl.enableVertexAttribArray(kNormal);
  gl.vertexAttribPointer(kNormal, 3, gl.FLOAT, false, kStride_B, 12);
  const oneColour = colour.length === 3;
  if (!oneColour) bound(colour, gl.STATIC_DRAW, kColour, gl.UNSIGNED_BYTE, true, 3);
  if (map) bound(map, gl.STATIC_DRAW, kMap, gl.FLOAT, false, 2);
  const factors = tinted ? bound(2 * vertices.byteLength / 4, gl.DYNAMIC_DRAW, kFactor, gl.FLOAT, false, 3) : null;
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, index, gl.STATIC_DRAW);
  gl.bindVertexArray(null);
  const put = (target, data) => {
    gl.bindBuffer(gl.ARRAY_BUFFER, target);
    gl.bufferSubData(gl.ARRAY_BUFFER, 0, data);
  };
  return {
    move(fresh, tint = null) {
      put(buffer, fresh);
      if (factors && tint) put(factors, tint);
    },
    draw(first = 0, count = index.length) {
      gl.bindVertexArray(array);
      if (oneColour) gl.vertexAttrib3f(kColour, ...colour);
      if (!factors) gl.vertexAttrib3f(kFactor, 1, 1, 1);
      gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 4 * first);
    },
  };
}

/// A texture of a picture (ImageBitmap), or of four bytes that stand for all of it.
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

/// One texture of this size, drawn by a program without attributes from some others: {name: texture}.
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
    program.unit(name, unit);
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
