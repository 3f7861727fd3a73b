// SPDX-License-Identifier: GPL-3.0-or-later
VARYING vec2 place;   // on the painted square; it goes on beyond it

void MAIN()
{
    place = (UV0 - 0.5) * beyond + 0.5;
    POSITION = MODELVIEWPROJECTION_MATRIX * vec4(VERTEX, 1.0);
    POSITION.z = 0.99999 * POSITION.w;  // behind everything
}
