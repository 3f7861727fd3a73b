// SPDX-License-Identifier: GPL-3.0-or-later
VARYING vec3 outward;   // normal, world
VARYING vec3 toEye;
VARYING vec4 colour;    // of the map, linear light; how much of the pixel it covers

void MAIN()
{
    outward = NORMAL;
    toEye = CAMERA_POSITION - VERTEX;
    colour = COLOR;
    POSITION = MODELVIEWPROJECTION_MATRIX * vec4(VERTEX, 1.0);
}
