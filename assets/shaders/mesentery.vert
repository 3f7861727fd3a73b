// SPDX-License-Identifier: GPL-3.0-or-later
VARYING vec2 place;   // along the loop, and from the root to it

void MAIN()
{
    place = UV0;
    POSITION = MODELVIEWPROJECTION_MATRIX * vec4(VERTEX, 1.0);
    POSITION.z = 0.99998 * POSITION.w;  // behind everything but the painted square: it hides nothing
}
