// SPDX-License-Identifier: GPL-3.0-or-later
VARYING vec3 place;   // mm in the instrument's own frame, z along its shaft
VARYING vec3 shaft;   // world direction of the shaft

void MAIN()
{
    place = VERTEX;
    shaft = (MODEL_MATRIX * vec4(0.0, 0.0, 1.0, 0.0)).xyz;
}
