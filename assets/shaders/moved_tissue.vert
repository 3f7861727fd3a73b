// SPDX-License-Identifier: GPL-3.0-or-later
// As tissue.vert, of an organ that the shader deforms (organ_place.glsl comes before it).
VARYING vec3 rest;   // mm
VARYING float arc;   // mm along the organ
VARYING vec3 tint;   // of the tissue's own colour: by its blood, white without

vec3 viewed(vec3 world)
{
    return vec3(world.x, world.z, -world.y);
}

void MAIN()
{
    int vertex = int(UV1.y + 0.5);
    vec3 place = placeOf(vertex);
    rest = TANGENT;
    arc = UV1.x;
    tint = tintOf(vertex, COLOR);
    NORMAL = normalize(viewed(normalOf(vertex, place)));
    VERTEX = 1000.0 * viewed(place);
}
