#version 440
// SPDX-License-Identifier: GPL-3.0-or-later
// Steps along edges become slopes (after FXAA by Timothy Lottes, 2009, its form for consoles).
layout(location = 0) in vec2 qt_TexCoord0;
layout(location = 0) out vec4 fragColor;
layout(std140, binding = 0) uniform buf {
    mat4 qt_Matrix;
    float qt_Opacity;
};
layout(binding = 1) uniform sampler2D source;

float lightness(vec4 c)
{
    return c.g + 0.51 * c.r;
}

void main()
{
    vec2 pixel = 1.0 / vec2(textureSize(source, 0));
    vec2 turned = vec2(qt_TexCoord0.x, 1.0 - qt_TexCoord0.y);  // the scene is drawn from below
    ivec2 at = ivec2(turned / pixel);
    vec4 middle = texelFetch(source, at, 0);
    float m = lightness(middle);
    float nw = lightness(texelFetch(source, at + ivec2(-1, -1), 0));
    float ne = lightness(texelFetch(source, at + ivec2(1, -1), 0));
    float sw = lightness(texelFetch(source, at + ivec2(-1, 1), 0));
    float se = lightness(texelFetch(source, at + ivec2(1, 1), 0));
    float least = min(m, min(min(nw, ne), min(sw, se)));
    float most = max(m, max(max(nw, ne), max(sw, se)));
    fragColor = middle;
    if (most - least > max(0.08, 0.12 * most)) {
        vec2 along = vec2(-((nw + ne) - (sw + se)), (nw + sw) - (ne + se));
        float reduce = max((nw + ne + sw + se) * 0.03125, 0.0078125);
        along = clamp(along / (min(abs(along.x), abs(along.y)) + reduce), -8.0, 8.0) * pixel;
        vec2 uv = (vec2(at) + 0.5) * pixel;
        vec4 near = 0.5 * (texture(source, uv - along / 6.0) + texture(source, uv + along / 6.0));
        vec4 far = 0.5 * near + 0.25 * (texture(source, uv - 0.5 * along) + texture(source, uv + 0.5 * along));
        float f = lightness(far);
        fragColor = f < least || f > most ? near : far;
    }
    fragColor *= qt_Opacity;
}
