// SPDX-License-Identifier: GPL-3.0-or-later
// Living tissue: a painted skin, fine relief, light that wanders through it, and a film of moisture on top.
VARYING vec3 rest;
VARYING float arc;
VARYING vec3 tint;

const float PI = 3.14159265;

vec3 wetNormal;      // of the film, which follows the relief more than the tissue below does
float wetRoughness;

uint scrambled(uvec3 p)
{
    uint h = p.x * 0x9E3779B1u ^ p.y * 0x85EBCA77u ^ p.z * 0xC2B2AE3Du;
    h ^= h >> 15; h *= 0x2C1B3C6Du; h ^= h >> 12; h *= 0x297A2D39u; h ^= h >> 15;
    return h;
}

float corner(ivec3 p)
{
    return float(scrambled(uvec3(p)) >> 8) * (2.0 / 16777216.0) - 1.0;
}

// Smooth noise in [-1, 1]: slope in xyz, value in w.
vec4 relief(vec3 p)
{
    ivec3 i = ivec3(floor(p));
    vec3 f = p - vec3(i);
    vec3 u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    vec3 du = 30.0 * f * f * (f * (f - 2.0) + 1.0);
    float a = corner(i), b = corner(i + ivec3(1, 0, 0));
    float c = corner(i + ivec3(0, 1, 0)), d = corner(i + ivec3(1, 1, 0));
    float e = corner(i + ivec3(0, 0, 1)), g = corner(i + ivec3(1, 0, 1));
    float h = corner(i + ivec3(0, 1, 1)), k = corner(i + ivec3(1, 1, 1));
    float k1 = b - a, k2 = c - a, k3 = e - a;
    float k4 = a - b - c + d, k5 = a - c - e + h, k6 = a - b - e + g;
    float k7 = -a + b + c - d + e - g - h + k;
    float value = a + k1 * u.x + k2 * u.y + k3 * u.z + k4 * u.x * u.y + k5 * u.y * u.z + k6 * u.z * u.x
                + k7 * u.x * u.y * u.z;
    vec3 slope = du * (vec3(k1, k2, k3) + u.yzx * vec3(k4, k5, k6) + u.zxy * vec3(k6, k4, k5)
                + k7 * u.yzx * u.zxy);
    return vec4(slope, value);
}

// Waves shorter than a few pixels are left out: they would glitter when the view moves.
float seen(float wave, float pixel)
{
    return 1.0 - smoothstep(0.12, 0.40, pixel / wave);
}

// The normal of a surface that rises by a height with this slope over the tissue at rest.
vec3 bumped(vec3 normal, vec3 slope)
{
    vec3 px = dFdx(VAR_WORLD_POSITION);
    vec3 py = dFdy(VAR_WORLD_POSITION);
    vec3 rx = cross(py, normal);
    vec3 ry = cross(normal, px);
    float area = dot(px, rx);
    vec3 lean = sign(area) * (dot(slope, dFdx(rest)) * rx + dot(slope, dFdy(rest)) * ry);
    return normalize(abs(area) * normal - lean + 1e-12 * normal);
}

vec3 linearOf(vec3 c)
{
    return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878);
}

void MAIN()
{
    vec3 skin = linearOf(texture(skinMap, UV0).rgb) * tint;
    float pixel = max(length(dFdx(rest)), length(dFdy(rest)));
    vec4 broad = relief(rest / 7.3);
    vec4 middle = relief(rest / 2.6 + 31.0) * seen(2.6, pixel);
    vec4 small = relief(rest / 0.85 + 57.0) * seen(0.85, pixel);
    vec3 slope = bumpBroad * broad.xyz / 7.3 + bumpMiddle * middle.xyz / 2.6 + bumpSmall * small.xyz / 0.85;
    vec3 film = 1.25 * slope;

    if (poreDepth > 0.0) {
        // Pores: the deep ends of a fine noise; creases: its zero lines, stretched round the limb.
        float visible = seen(0.9, pixel);
        vec4 pore = relief(rest / vec3(0.75, 0.9, 0.75) + 11.0);
        float deep = smoothstep(0.25, 0.75, pore.w) * visible;
        vec4 crease = relief(rest / vec3(2.4, 0.8, 2.4) + 3.7);
        float line = (1.0 - smoothstep(0.0, 0.22, abs(crease.w))) * seen(1.6, pixel);
        slope -= poreDepth * visible * smoothstep(0.1, 0.5, pore.w) * pore.xyz / vec3(0.75, 0.9, 0.75);
        film = slope;
        skin *= 1.0 - 0.10 * deep - 0.05 * line;
    }
    if (foldDepth > 0.0) {
        // Circular folds: dFdx of the arc length gives their direction on the screen.
        float wave = 4.6;
        float phase = 6.2831853 * arc / wave + 1.6 * relief(rest / 8.0).w;
        float amount = foldDepth * seen(wave, pixel) * cos(phase);
        vec2 along = vec2(dFdx(arc), dFdy(arc));
        vec3 qx = dFdx(rest), qy = dFdy(rest);
        float xx = dot(qx, qx), xy = dot(qx, qy), yy = dot(qy, qy);
        float area = max(xx * yy - xy * xy, 1e-9);
        vec3 towards = ((along.x * yy - along.y * xy) * qx + (along.y * xx - along.x * xy) * qy) / area;
        slope += amount * towards;
        film += amount * towards;
    }
    vec3 smoothNormal = NORMAL;
    NORMAL = bumped(smoothNormal, slope);
    wetNormal = bumped(smoothNormal, film);
    // Where waves were left out their glitter stays as roughness.
    wetRoughness = clamp(filmRoughness + 0.10 * middle.w + 0.06 * broad.w + 0.05 * (1.0 - seen(2.6, pixel)),
                         0.08, 1.0);
    BASE_COLOR = vec4(skin * (1.0 + 0.05 * small.w), 1.0);
    METALNESS = 0.0;
    ROUGHNESS = clamp(tissueRoughness + 0.08 * broad.w, 0.2, 1.0);
    SPECULAR_AMOUNT = 0.5;
}

// Light goes in, wanders and comes out beside: the edge of the shade is soft, and red, which goes furthest.
vec3 wandered(float facing, vec3 way)
{
    vec3 lit = clamp((vec3(facing) + way) / (1.0 + way), 0.0, 1.0);
    return lit * mix(vec3(1.0), lit, 0.35);
}

void DIRECTIONAL_LIGHT()
{
    vec3 way = scatter * vec3(0.55, 0.20, 0.14);
    vec3 shade = mix(vec3(SHADOW_CONTRIB), vec3(1.0), 0.5 * way);
    vec3 lit = wandered(dot(NORMAL, TO_LIGHT_DIR), way) * shade;
    // Some comes through where the tissue is seen along its edge and lit from behind.
    float thin = 1.0 - clamp(dot(NORMAL, VIEW_VECTOR), 0.0, 1.0);
    float through = pow(clamp(dot(VIEW_VECTOR, -normalize(TO_LIGHT_DIR + 0.5 * NORMAL)), 0.0, 1.0), 2.0);
    lit += scatter * 0.9 * through * thin * thin * vec3(1.0, 0.32, 0.22);
    DIFFUSE += LIGHT_COLOR * lit * BASE_COLOR.rgb;
}

float lobe(vec3 normal, vec3 towards, vec3 viewer, float roughness)
{
    vec3 half_ = normalize(towards + viewer);
    float a = roughness * roughness;
    float nh = clamp(dot(normal, half_), 0.0, 1.0);
    float spread = nh * nh * (a * a - 1.0) + 1.0;
    float lh = clamp(dot(towards, half_), 0.05, 1.0);
    float mirror = 0.028 + 0.972 * pow(1.0 - lh, 5.0);
    // Geometry term folded in (Karis' approximation of Schlick-Smith through 1 / lh^2).
    return mirror * a * a / (4.0 * PI * spread * spread * max(0.1, lh * lh) * (roughness + 0.5))
         * clamp(dot(normal, towards) * 4.0, 0.0, 1.0);
}

void SPECULAR_LIGHT()
{
    float below = lobe(NORMAL, TO_LIGHT_DIR, VIEW_VECTOR, ROUGHNESS);
    float film = wetness * lobe(wetNormal, TO_LIGHT_DIR, VIEW_VECTOR, wetRoughness);
    SPECULAR += LIGHT_COLOR * SHADOW_CONTRIB * LIGHT_ATTENUATION * PI * (0.6 * below + film);
}

#if QSSG_ENABLE_LIGHT_PROBE
vec3 around(vec3 direction, float level)
{
    return textureLod(IBL_TEXTURE, direction, level).rgb * IBL_EXPOSE;
}

vec3 mirrored(vec3 normal, vec3 viewer, float roughness)
{
    float facing = clamp(dot(normal, viewer), 0.0, 1.0);
    float mirror = 0.028 + 0.34 * (1.0 - roughness) * pow(1.0 - facing, 5.0);
    float level = min(roughness * 5.0, float(IBL_MAXMIPMAP) - 1.0);
    return around(reflect(-viewer, normal), level) * mirror;
}

void IBL_PROBE()
{
    vec3 lit = around(NORMAL, float(IBL_MAXMIPMAP));
    // Blood colours what the tissue sends from its depth: the rim glows a little.
    float thin = 1.0 - clamp(dot(NORMAL, VIEW_VECTOR), 0.0, 1.0);
    lit *= 1.0 + scatter * 0.45 * thin * thin * vec3(0.9, 0.15, 0.10);
    DIFFUSE += lit * BASE_COLOR.rgb * AO_FACTOR;
    SPECULAR += (0.6 * mirrored(NORMAL, VIEW_VECTOR, ROUGHNESS) + wetness * mirrored(wetNormal, VIEW_VECTOR, wetRoughness))
              * mix(AO_FACTOR, 1.0, 0.3);
}
#endif
