// SPDX-License-Identifier: GPL-3.0-or-later
VARYING vec3 outward;   // normal, world
VARYING vec3 toEye;
VARYING vec3 colour;    // of the map, linear light

void MAIN()
{
    outward = NORMAL;
    toEye = CAMERA_POSITION - VERTEX;
    colour = COLOR.rgb;
    POSITION = MODELVIEWPROJECTION_MATRIX * vec4(VERTEX, 1.0);
}
