// SPDX-License-Identifier: GPL-3.0-or-later
// Living tissue for a renderer without a graphics card: the operating lamp, the lamp beside the lens and the
// room in a handful of operations, no picture of the room. The fourth channel of the painted skin is the
// height of its fine relief.
VARYING vec3 outward;
VARYING vec3 toEye;
VARYING vec4 tint;
VARYING vec2 place;

void MAIN()
{
    vec4 skin = texture(skinMap, place);
    vec3 base = skin.rgb * skin.rgb * tint.rgb;
    vec3 viewer = normalize(toEye);
    vec3 smoothNormal = normalize(outward);
    vec3 px = dFdx(toEye), py = dFdy(toEye);
    vec3 rx = cross(py, smoothNormal), ry = cross(smoothNormal, px);
    float area = dot(px, rx);
    vec3 lean = sign(area) * relief * (dFdx(skin.a) * rx + dFdy(skin.a) * ry);
    vec3 normal = normalize(abs(area) * smoothNormal + lean + 1e-9 * smoothNormal);

    // Light goes in, wanders and comes out beside: the edge of the shade is soft, and red, which goes furthest.
    float lamp = dot(normal, lampDirection);
    vec3 lit = clamp((vec3(lamp) + scatterWay) / (1.0 + scatterWay), 0.0, 1.0);
    float lens = max(dot(normal, lensDirection), 0.0);
    float up = 0.5 + 0.5 * normal.y;
    vec3 room = mix(vec3(0.20, 0.165, 0.15), vec3(0.40, 0.42, 0.44), up);
    float rim = 1.0 - clamp(dot(smoothNormal, viewer), 0.0, 1.0);
    rim *= rim;
    vec3 sum = base * (room + lampColour * lit + lens * vec3(0.30, 0.28, 0.27) + rim * scatterRim);

    // The lamps in the film of moisture, sharp, and in the tissue below it, broad; the room along the edge.
    float lampMirror = max(dot(normal, normalize(lampDirection + viewer)), 0.0);
    float l2 = lampMirror * lampMirror, l4 = l2 * l2, l16 = l4 * l4 * l4 * l4, l64 = l16 * l16 * l16 * l16;
    float lensMirror = max(dot(normal, normalize(lensDirection + viewer)), 0.0);
    float m2 = lensMirror * lensMirror, m4 = m2 * m2, m16 = m4 * m4 * m4 * m4;
    float shine = wetness * (0.9 * l64 * l64 + 0.30 * l64 + 0.05 * m16 * m16) + 0.06 * l16 + 0.02 * m16;
    sum += shine * smoothstep(-0.2, 0.05, lamp) + (0.02 + 0.16 * wetness) * rim * rim * up;
    FRAGCOLOR = vec4(sqrt(sum), 1.0) * tint.a;
}
