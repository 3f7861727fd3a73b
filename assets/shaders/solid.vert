// SPDX-License-Identifier: GPL-3.0-or-later
VARYING vec3 outward;   // normal, world
VARYING vec3 toEye;
VARYING vec4 tint;      // times the material's own colour; how much of the pixel it covers
VARYING float kind;     // added to the material's surface
VARYING vec3 place;     // mm in the instrument's own frame, z along its shaft

void MAIN()
{
    outward = normalize(NORMAL_MATRIX * NORMAL);
    vec3 world = (MODEL_MATRIX * vec4(VERTEX, 1.0)).xyz;
    toEye = CAMERA_POSITION - world;
    tint = COLOR;
    kind = UV0.x;
    place = VERTEX;
    POSITION = MODELVIEWPROJECTION_MATRIX * vec4(VERTEX, 1.0);
    // What shows something stands a little before what it stands on.
    POSITION.z -= 0.004 * POSITION.w * max(-(surface + kind), 0.0);
}
