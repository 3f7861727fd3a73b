// SPDX-License-Identifier: GPL-3.0-or-later
VARYING vec2 place;   // on the painted square

void MAIN()
{
    place = UV0;
    POSITION = MODELVIEWPROJECTION_MATRIX * vec4(VERTEX, 1.0);
}
