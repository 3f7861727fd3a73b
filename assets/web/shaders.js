// SPDX-License-Identifier: GPL-3.0-or-later
// Lighting of tissue and steel (GLSL ES 3.00). Tissue uses the window's shader for software renderers,
// assets/shaders/quick_tissue.frag; the inputs from scene_view.qml are repeated here.

export const kVertexShader = `#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in vec2 map;
layout(location = 4) in vec3 factor;
uniform mat4 model;
uniform mat4 viewProjection;
uniform vec3 eye;
out vec3 outward;
out vec3 toEye;
out vec4 tint;
out vec2 place;
// The window's scene graph also treats vertex colours as linear light.
vec3 linear(vec3 c) {
  return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}
void main() {
  vec4 world = model * vec4(position, 1.0);
  outward = normalize(mat3(model) * normal);
  toEye = eye - world.xyz;
  // Without a painted skin the map is white, and vertices carry the tissue's colour.
  tint = vec4(colour * colour * linear(clamp(factor, 0.0, 1.0)), 1.0);
  place = map;
  gl_Position = viewProjection * world;
}`;

/// Lights of the room, of the camera, and for strongly scattering tissue; same as in scene_view.qml.
export const kLamps = {
  lampDirection: [-0.27, 0.788, 0.553],
  lensDirection: [-0.54, 0.24, 0.80],
  lampColour: [0.86, 0.82, 0.78],
  scatterWay: [0.55, 0.20, 0.14],
  scatterRim: [0.35, 0.06, 0.04],
};

/// Adapts the window's shader to WebGL 2.
export function tissueShader(source) {
  return `#version 300 es
precision highp float;
#define VARYING in
#define MAIN main
#define FRAGCOLOR shown
out vec4 shown;
uniform sampler2D skinMap;
uniform vec3 lampDirection;
uniform vec3 lensDirection;
uniform vec3 lampColour;
uniform vec3 scatterWay;
uniform vec3 scatterRim;
uniform float wetness;
uniform float relief;
${source}`;
}

/// Writes the relief's height into the alpha channel of the colour, once per skin.
export const kJoinVertexShader = `#version 300 es
out vec2 place;
void main() {
  place = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
  gl_Position = vec4(2.0 * place - 1.0, 0.0, 1.0);
}`;
export const kJoinShader = `#version 300 es
precision highp float;
in vec2 place;
uniform sampler2D colourMap;
uniform sampler2D reliefMap;
out vec4 shown;
void main() {
  shown = vec4(texture(colourMap, place).rgb, texture(reliefMap, place).r);
}`;

export const kSteelShader = `#version 300 es
precision highp float;
in vec3 outward;
in vec3 toEye;
in vec4 tint;
uniform vec3 lampDirection;
uniform vec3 lensDirection;
out vec4 shown;
void main() {
  vec3 v = normalize(toEye);
  vec3 n = normalize(outward);
  if (dot(n, v) < 0.0) n = -n;
  vec3 mirrored = reflect(-v, n);
  float sky = smoothstep(-0.4, 0.9, mirrored.y);
  vec3 light = vec3(0.30) + 0.55 * max(dot(n, lampDirection), 0.0) + 0.2 * max(dot(n, lensDirection), 0.0);
  float mirror = pow(max(dot(n, normalize(lampDirection + v)), 0.0), 60.0);
  vec3 shine = mix(vec3(0.10, 0.11, 0.12), vec3(0.75, 0.78, 0.80), sky) * 0.45 + vec3(0.8) * mirror;
  vec3 sum = tint.rgb * light + shine * 0.8;
  shown = vec4(sqrt(sum / (1.0 + 0.18 * sum)), 1.0);
}`;
