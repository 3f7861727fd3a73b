// SPDX-License-Identifier: GPL-3.0-or-later
// The painted mesentery of a loop of bowel, thin over what lies behind it.
VARYING vec2 place;

void MAIN()
{
    vec4 thin = texture(fan, place);
    FRAGCOLOR = vec4(thin.rgb, 1.0) * thin.a;
}
