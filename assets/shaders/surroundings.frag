// SPDX-License-Identifier: GPL-3.0-or-later
// What lies behind the organ, painted with its light, under the organ's shadow of this moment.
VARYING vec2 place;

void MAIN()
{
    float taken = texture(shadow, (place - 0.5) * shadowShare + 0.5).r;
    FRAGCOLOR = vec4(texture(ground, place).rgb * (1.0 - shadowDepth * taken), 1.0);
}
