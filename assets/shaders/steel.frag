// SPDX-License-Identifier: GPL-3.0-or-later
// Brushed steel: fine scratches along the instrument tilt the normal across it, so that highlights run across.
VARYING vec3 place;
VARYING vec3 shaft;

float scratch(float across, float row)
{
    uint h = uint(int(floor(across))) * 0x9E3779B1u ^ uint(int(floor(row))) * 0x85EBCA77u;
    h ^= h >> 15; h *= 0x2C1B3C6Du; h ^= h >> 12; h *= 0x297A2D39u; h ^= h >> 15;
    return float(h >> 8) * (2.0 / 16777216.0) - 1.0;
}

void MAIN()
{
    float about = atan(place.y, place.x);
    float turn = 90.0 * about;
    // Each scratch is some millimetres long and begins at a place of its own.
    float row = place.z / 4.0 + 7.0 * scratch(turn, 0.0);
    float tilt = mix(scratch(turn, row), scratch(turn, row + 1.0), smoothstep(0.0, 1.0, fract(row)));
    float pixel = fwidth(place.z) + length(fwidth(place.xy));
    tilt *= 1.0 - smoothstep(0.05, 0.30, pixel);
    vec3 across = normalize(cross(shaft, NORMAL) + vec3(1e-6, 0.0, 0.0));
    NORMAL = normalize(NORMAL + 0.10 * tilt * across);
    BASE_COLOR = vec4(vec3(0.66, 0.68, 0.70) * (1.0 + 0.05 * tilt), 1.0);
    METALNESS = 0.96;
    ROUGHNESS = 0.27 + 0.05 * tilt;
    SPECULAR_AMOUNT = 0.5;
}
