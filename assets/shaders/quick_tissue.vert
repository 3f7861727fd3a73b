// SPDX-License-Identifier: GPL-3.0-or-later
VARYING vec3 outward;   // normal, world
VARYING vec3 toEye;
VARYING vec4 tint;      // of the tissue's own colour, by its blood; how much of the pixel it covers
VARYING vec2 place;     // on the map of the skin

void MAIN()
{
    outward = NORMAL;
    toEye = CAMERA_POSITION - VERTEX;
    tint = COLOR;
    place = UV0;
    POSITION = MODELVIEWPROJECTION_MATRIX * vec4(VERTEX, 1.0);
}
