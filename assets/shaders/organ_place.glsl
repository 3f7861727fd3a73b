// SPDX-License-Identifier: GPL-3.0-or-later
// Where a vertex of the organ lies: its constant numbers and the rows of the frame, as sim/scene/shader_skin.h
// describes them. ShaderSkin::place_m is the same in C++.
const int VERTEX_TEXELS = 5;
const int WIDE = 1024;               // texels in a line of the constant textures
const float STRAIGHT = 1e-9;         // a bend that does nothing, 1/m
const float LIMIT_FROM = 0.455;      // of a bend, which never reaches LIMIT
const float LIMIT = 0.495;

vec4 numbersOf(int vertex, int which)
{
    int at = vertex * VERTEX_TEXELS + which;
    return texelFetch(organVertices, ivec2(at % WIDE, at / WIDE), 0);
}

int neighbourOf(int at)
{
    return int(texelFetch(organNeighbours, ivec2(at % WIDE, at / WIDE), 0).r + 0.5);
}

vec4 rowAt(int row, float share, int which)
{
    return mix(texelFetch(organRows, ivec2(which, row), 0), texelFetch(organRows, ivec2(which, row + 1), 0), share);
}

// A point of a folded section: across and round it are the ways that a fold moves it.
vec3 foldedPlace(vec3 local, vec4 fold, vec4 across, vec4 round, bool wound)
{
    float cosine = cos(fold.z * across.w);
    float sine = sin(fold.z * across.w);
    float up = fold.x * cosine + fold.y * sine;
    float aside = fold.x * sine - fold.y * cosine;
    float turn = aside * ((0.5 + 0.25 * fold.z * fold.z) * up - 1.0) / fold.z;
    float c = (1.0 + up) * cos(turn);
    float s = (1.0 + up) * sin(turn);
    return wound ? local + (c - 1.0) * across.xyz + s * round.xyz
                 : vec3(c * local.x - s * local.y, s * local.x + c * local.y, (1.0 + up) * local.z);
}

// A point of a straight section, in one that is bent: the area along a fibre stays.
vec2 bentPlace(vec2 w, vec2 k)
{
    float k2 = dot(k, k);
    if (k2 < STRAIGHT * STRAIGHT)
        return w;
    float straight = dot(w, k);
    float z = straight;
    if (z > LIMIT_FROM) {
        float y = (z - LIMIT_FROM) / (LIMIT - LIMIT_FROM);
        z = LIMIT_FROM + (LIMIT - LIMIT_FROM) * y / (1.0 + y);
    }
    return w + k * ((2.0 * z / (1.0 + sqrt(1.0 - 2.0 * z)) - straight) / k2);
}

vec3 turned(vec4 q, vec3 v)
{
    return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v);
}

// The dent under an instrument: x, y, z and reach of its patch; its depth along the normal; radius of the tool.
vec3 dentAt(vec3 place, vec4 patch0, vec4 depth)
{
    float away = distance(place, patch0.xyz);
    if (patch0.w <= depth.w || away >= patch0.w)
        return vec3(0.0);
    return depth.xyz * (log(patch0.w / max(depth.w, away)) / log(patch0.w / depth.w));
}

// World frame, m.
vec3 placeOf(int vertex)
{
    vec4 base = numbersOf(vertex, 0);
    vec4 rest = numbersOf(vertex, 1);
    int row = int(base.w);
    float share = base.w - float(row);
    vec4 place = rowAt(row, share, 0);
    vec4 bend = rowAt(row, share, 2);
    vec4 fold = rowAt(row, share, 3);
    vec3 local = base.xyz;
    if (fold.x != 0.0 || fold.y != 0.0) {
        fold.z = texelFetch(organRows, ivec2(3, row), 0).z;
        local = foldedPlace(local, fold, numbersOf(vertex, 2), numbersOf(vertex, 3), numbersOf(vertex, 4).z > 0.5);
    }
    vec2 u = bentPlace(place.w * local.xy, bend.xy);
    float longer = bend.z * (1.0 - dot(u, bend.xy)) / rest.z;
    vec3 lies = place.xyz
              + turned(normalize(rowAt(row, share, 1)), vec3(u + rest.xy, longer * local.z + bend.w * rest.w));
    return lies + dentAt(lies, dentPlace0, dentDepth0) + dentAt(lies, dentPlace1, dentDepth1);
}

// Sum of the normals of the triangles round a vertex, each as long as twice its area.
vec3 normalOf(int vertex, vec3 place)
{
    vec4 ring = numbersOf(vertex, 4);
    int first = int(ring.x + 0.5);
    int count = int(ring.y + 0.5);
    vec3 sum = vec3(0.0);
    vec3 side = placeOf(neighbourOf(first + count - 1)) - place;
    for (int i = 0; i < count; ++i) {
        vec3 next = placeOf(neighbourOf(first + i)) - place;
        sum += cross(side, next);
        side = next;
    }
    return sum;
}

// Factor on the colour of the tissue, linear light: blood by how far it comes through the twist, and over it what
// covers it, premultiplied, with what shows through.
vec3 tintOf(int vertex, vec4 cover)
{
    vec3 encoded = clamp(mix(vec3(1.0), organBlood, numbersOf(vertex, 3).w) * cover.a + cover.rgb, 0.0, 1.0);
    return mix(encoded / 12.92, pow((encoded + 0.055) / 1.055, vec3(2.4)), step(0.04045, encoded));
}
