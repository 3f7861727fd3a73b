// SPDX-License-Identifier: GPL-3.0-or-later
// The instrument, glove and gown, the port, the drape over an arm. Cloth: two lamps and a room of two colours.
// Plastic and rubber: the same and a gloss. Steel: what it mirrors, a bright ceiling and lamp over a dark
// floor, drawn out across its scratches, which run along the shaft.
VARYING vec3 outward;
VARYING vec3 toEye;
VARYING vec4 tint;
VARYING float kind;
VARYING vec3 place;

float scratch(float across, float row)
{
    uint h = uint(int(floor(across))) * 0x9E3779B1u ^ uint(int(floor(row))) * 0x85EBCA77u;
    h ^= h >> 15; h *= 0x2C1B3C6Du; h ^= h >> 12; h *= 0x297A2D39u; h ^= h >> 15;
    return float(h >> 8) * (2.0 / 16777216.0) - 1.0;
}

float tiltOfScratches()
{
    float turn = 90.0 * atan(place.y, place.x);
    // Each scratch is some millimetres long and begins at a place of its own.
    float row = place.z / 4.0 + 7.0 * scratch(turn, 0.0);
    float tilt = mix(scratch(turn, row), scratch(turn, row + 1.0), smoothstep(0.0, 1.0, fract(row)));
    float pixel = fwidth(place.z) + length(fwidth(place.xy));
    return tilt * (1.0 - smoothstep(0.05, 0.30, pixel));
}

vec3 room(vec3 way)
{
    float up = way.y;
    float ceiling = smoothstep(-0.15, 0.85, up);
    vec3 light = mix(vec3(0.05, 0.055, 0.06), vec3(0.78, 0.80, 0.82), ceiling * ceiling);
    float horizon = exp(-28.0 * up * up);
    light *= 1.0 - 0.55 * horizon;                                // walls in the shade of the lamp
    float lamp = max(dot(way, lampDirection), 0.0), lens = max(dot(way, lensDirection), 0.0);
    float lamp2 = lamp * lamp, lamp8 = lamp2 * lamp2 * lamp2 * lamp2;
    float lens2 = lens * lens, lens8 = lens2 * lens2 * lens2 * lens2;
    return light + vec3(1.30, 1.24, 1.18) * lamp8 * lamp8 + vec3(0.62, 0.60, 0.58) * lens8;
}

void MAIN()
{
    float made = surface + kind;
    vec3 shade = own * tint.rgb;
    vec3 base = shade * shade;
    vec3 viewer = normalize(toEye);
    vec3 normal = normalize(outward);
    float graze = 1.0 - clamp(dot(normal, viewer), 0.0, 1.0);
    float graze2 = graze * graze, fresnel = graze2 * graze2 * graze;
    vec3 sum;
    if (made > 0.5) {
        vec3 across = normalize(cross(shaftDirection, normal) + vec3(1e-6, 0.0, 0.0));
        if (scratches > 0.0) {
            normal = normalize(normal + scratches * tiltOfScratches() * across);
        }
        // Three mirrors, tilted across the scratches: what is seen in them runs together there.
        vec3 one = normalize(normal - 0.16 * across), two = normalize(normal + 0.16 * across);
        vec3 seen = 0.40 * room(reflect(-viewer, normal)) + 0.30 * room(reflect(-viewer, one)) +
                    0.30 * room(reflect(-viewer, two));
        sum = seen * mix(base * 1.35, vec3(1.0), fresnel) + 0.02;
    } else {
        float lamp = max(dot(normal, lampDirection), 0.0), lens = max(dot(normal, lensDirection), 0.0);
        float up = 0.5 + 0.5 * normal.y;
        if (made > 0.1) {                                             // the weave, where pixels show it
            float thread = 0.5 * scratch(2.5 * place.z, 1.0) + 0.5 * scratch(2.5 * (place.x + place.y), 3.0);
            base *= 1.0 + 0.10 * thread * (1.0 - smoothstep(0.15, 0.6, length(fwidth(place))));
        }
        sum = base * (mix(vec3(0.20, 0.20, 0.21), vec3(0.42, 0.44, 0.46), up) + vec3(0.74, 0.71, 0.68) * lamp +
                      vec3(0.34, 0.33, 0.32) * lens);
        float mirror = max(dot(normal, normalize(lampDirection + viewer)), 0.0);
        float m2 = mirror * mirror, m4 = m2 * m2, m16 = m4 * m4 * m4 * m4;
        float mirrored = max(dot(normal, normalize(lensDirection + viewer)), 0.0);
        float l2 = mirrored * mirrored, l4 = l2 * l2, l16 = l4 * l4 * l4 * l4;
        float gloss = made > 0.1 ? 0.0 : 1.0;                         // cloth has none
        sum += gloss * (0.16 * m16 * m16 + 0.05 * m16 + 0.07 * l16 * l16 + (0.02 + 0.30 * up) * 0.5 * fresnel);
    }
    vec3 shown = made < -0.5 ? shade : sqrt(min(sum, vec3(1.0)));
    FRAGCOLOR = vec4(shown, 1.0) * tint.a;
}
