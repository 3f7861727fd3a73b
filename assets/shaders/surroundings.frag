// SPDX-License-Identifier: GPL-3.0-or-later
// What lies behind the organ, painted with its light, under the organ's shadow of this moment.
VARYING vec2 place;

// Beyond the painted square its outermost part goes on, there and back: a border drawn out would be streaks.
vec2 continued(vec2 at)
{
    const float kOutermost = 0.36;  // of half the square: cloth only, no table and no ring
    vec2 away = abs(at - 0.5) * 2.0;
    vec2 beyondBorder = max(away - 1.0, 0.0);
    vec2 back = kOutermost - abs(mod(beyondBorder, 2.0 * kOutermost) - kOutermost);
    return 0.5 + 0.5 * sign(at - 0.5) * (min(away, 1.0) - back);
}

void MAIN()
{
    float taken = texture(shadow, (place - 0.5) * shadowShare + 0.5).r;
    FRAGCOLOR = vec4(texture(ground, continued(place)).rgb * (1.0 - shadowDepth * taken), 1.0);
}
