// SPDX-License-Identifier: GPL-3.0-or-later
// The place at rest travels with the vertex as its tangent, so that what is drawn from it sticks to the tissue.
VARYING vec3 rest;   // mm
VARYING float arc;   // mm along the organ
VARYING vec3 tint;   // of the tissue's own colour: by its blood, white without

void MAIN()
{
    rest = TANGENT;
    arc = UV1.x;
    tint = COLOR.rgb;
}
