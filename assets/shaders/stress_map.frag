// SPDX-License-Identifier: GPL-3.0-or-later
// A map is read by its colours: tissue that faces the viewer or the operating lamp has exactly that of the
// legend, the rest the same hue darker, and nothing is ever brighter.
VARYING vec3 outward;
VARYING vec3 toEye;
VARYING vec4 colour;

vec3 encoded(vec3 c)
{
    return mix(12.92 * c, 1.055 * pow(max(c, vec3(1e-6)), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

void MAIN()
{
    vec3 normal = normalize(outward);
    float facing = max(dot(normal, normalize(toEye)), 0.0);
    float lamp = max(dot(normal, lampDirection), 0.0);
    float light = min(1.0, 0.55 + 0.50 * facing * facing + 0.30 * lamp);
    FRAGCOLOR = vec4(encoded(colour.rgb) * light, 1.0) * colour.a;
}
