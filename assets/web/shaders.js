// SPDX-License-Identifier: GPL-3.0-or-later
// How tissue and steel answer to light (GLSL ES 3.00). Light from the upper left, a weaker one from the right, and
// a room that is lighter above. After assets/shaders/tissue.frag, as much of it as any machine can draw.

export const kVertexShader = `#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in vec3 rest;
layout(location = 4) in float fed;
uniform vec3 blood;
uniform mat4 model;
uniform mat4 viewProjection;
out vec3 place;
out vec3 facing;
out vec3 skin;
out vec3 still;
void main() {
  vec4 world = model * vec4(position, 1.0);
  place = world.xyz;
  facing = mat3(model) * normal;
  vec3 own = colour * mix(vec3(1.0), blood, fed);
  skin = own * own;
  still = rest;
  gl_Position = viewProjection * world;
}`;

const kLight = `#version 300 es
precision highp float;
in vec3 place;
in vec3 facing;
in vec3 skin;
in vec3 still;
uniform vec3 eye;
uniform mat3 headlight;
out vec4 shown;
vec3 keyLight() { return headlight * vec3(-0.45, 0.72, 0.53); }
vec3 fillLight() { return headlight * vec3(0.80, 0.10, 0.59); }
float gloss(vec3 n, vec3 l, vec3 v, float power) {
  return pow(max(dot(n, normalize(l + v)), 0.0), power);
}
vec3 graded(vec3 c) { return sqrt(c / (1.0 + 0.18 * c)); }
`;

export const kTissueShader = `${kLight}
uniform float fine;
float corner(vec3 p) {
  p = fract(p * 0.3183099 + vec3(0.11, 0.17, 0.13));
  p *= 17.0;
  return fract(p.x * p.y * p.z * (p.x + p.y + p.z));
}
float grain(vec3 p) {
  vec3 i = floor(p);
  vec3 f = fract(p);
  f = f * f * (3.0 - 2.0 * f);
  return mix(mix(mix(corner(i), corner(i + vec3(1, 0, 0)), f.x),
                 mix(corner(i + vec3(0, 1, 0)), corner(i + vec3(1, 1, 0)), f.x), f.y),
             mix(mix(corner(i + vec3(0, 0, 1)), corner(i + vec3(1, 0, 1)), f.x),
                 mix(corner(i + vec3(0, 1, 1)), corner(i + vec3(1, 1, 1)), f.x), f.y), f.z);
}
void main() {
  vec3 v = normalize(eye - place);
  vec3 n = normalize(facing);
  if (dot(n, v) < 0.0) n = -n;
  float mottle = 0.5;
  vec3 film = n;
  if (fine > 0.5) {
    float broad = grain(still / 7.3);
    mottle = 0.55 * broad + 0.45 * grain(still / 2.1);
    // Waves shorter than a few pixels are left out: they would glitter.
    float pixel = max(length(dFdx(still)), 1e-3);
    vec3 lean = vec3(dFdx(mottle), dFdy(mottle), 0.0) / pixel * (1.0 - smoothstep(0.25, 0.9, pixel));
    film = normalize(n - 0.9 * (headlight * lean));
  }
  vec3 base = skin * mix(0.82, 1.16, mottle);
  // Light goes in, wanders and comes out beside: the edge of the shade is soft, and red, which goes furthest.
  vec3 way = vec3(0.42, 0.20, 0.15);
  vec3 key = clamp((vec3(dot(n, keyLight())) + way) / (1.0 + way), 0.0, 1.0);
  vec3 weak = clamp((vec3(dot(n, fillLight())) + way) / (1.0 + way), 0.0, 1.0);
  vec3 room = mix(vec3(0.20, 0.16, 0.16), vec3(0.40, 0.42, 0.45), 0.5 + 0.5 * n.y);
  float rim = pow(1.0 - max(dot(n, v), 0.0), 3.0);
  vec3 light = 0.95 * key + 0.30 * weak + room * (1.0 - 0.35 * rim);
  vec3 wet = vec3(0.40 * gloss(film, keyLight(), v, 70.0) + 0.10 * gloss(film, keyLight(), v, 14.0)
                  + 0.10 * gloss(film, fillLight(), v, 40.0)) + 0.10 * rim * vec3(1.0, 0.86, 0.82);
  shown = vec4(graded(base * light + wet), 1.0);
}`;

export const kSteelShader = `${kLight}
void main() {
  vec3 v = normalize(eye - place);
  vec3 n = normalize(facing);
  if (dot(n, v) < 0.0) n = -n;
  vec3 mirrored = reflect(-v, n);
  float sky = smoothstep(-0.4, 0.9, mirrored.y);
  vec3 light = vec3(0.30) + 0.55 * max(dot(n, keyLight()), 0.0) + 0.2 * max(dot(n, fillLight()), 0.0);
  vec3 shine = mix(vec3(0.10, 0.11, 0.12), vec3(0.75, 0.78, 0.80), sky) * 0.45
             + vec3(0.8) * gloss(n, keyLight(), v, 60.0);
  shown = vec4(graded(skin * light + shine * 0.8), 1.0);
}`;
