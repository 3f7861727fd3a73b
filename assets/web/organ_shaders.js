// SPDX-License-Identifier: GPL-3.0-or-later
// Vertex shaders that evaluate the twist (GLSL ES 3.00); used by organ_sum.js.

/// Texels per row of data textures.
export const kRow = 1024;

/// Maximum components of an organ, also the server's limit.
export const kMaxComponents = 64;
/// Maximum layers at once: bruises, tears (32 together per recording) and a clip.
export const kMaxPaints = 33;

/// Position of a vertex: its mean plus each displacement times its weight.
export const kPlaceShader = `#version 300 es
layout(location = 0) in vec3 mean;
uniform highp isampler2DArray steps;
uniform int count;
uniform int layers[${kMaxComponents}];
uniform float weights[${kMaxComponents}];
out vec4 placed;
void main() {
  ivec2 at = ivec2(gl_VertexID % ${kRow}, gl_VertexID / ${kRow});
  vec3 sum = mean;
  for (int i = 0; i < count; ++i) sum += weights[i] * vec3(texelFetch(steps, ivec3(at, layers[i]), 0).xyz);
  placed = vec4(sum, 1.0);
}`;

/// Data of a drawn corner: its vertex's position; the sum of the normals of adjacent triangles, weighted by
/// twice their area; colour factors of blood, then damage, lowest layer first.
export const kCornerShader = `#version 300 es
layout(location = 0) in uvec3 corner; // vertex, its first triangle in the fans, number of triangles
layout(location = 1) in float fed;
uniform highp sampler2DArray places;
uniform highp usampler2D fans;
uniform highp sampler2DArray paints;
uniform vec3 blood;
uniform int paintCount;
uniform int paintLayers[${kMaxPaints}];
uniform vec3 paintFactors[${kMaxPaints}];
out vec3 position;
out vec3 normal;
out vec3 factor;
ivec2 texel(uint number) {
  return ivec2(int(number % ${kRow}u), int(number / ${kRow}u));
}
vec3 place(uint vertex) {
  return texelFetch(places, ivec3(texel(vertex), 0), 0).xyz;
}
void main() {
  position = place(corner.x);
  normal = vec3(0.0);
  uint known = ~0u;
  vec3 side;
  for (uint i = corner.y; i < corner.y + corner.z; ++i) {
    uvec2 others = texelFetch(fans, texel(i), 0).xy;
    if (others.x != known) side = place(others.x) - position;
    vec3 next = place(others.y) - position;
    normal += cross(side, next);
    side = next;
    known = others.y;
  }
  factor = mix(vec3(1.0), blood, fed);
  for (int i = 0; i < paintCount; ++i) {
    factor = mix(factor, paintFactors[i], texelFetch(paints, ivec3(texel(corner.x), paintLayers[i]), 0).r);
  }
}`;
