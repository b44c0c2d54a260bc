#pragma once

// The shaders of the painter of space. Places are relative to the camera's target.

namespace cambrian::space_shader {

inline constexpr const char* kVersion = "#version 330 core\n";

// What is around, for shaders of fragments.
inline constexpr const char* kAround = R"(
uniform vec3 eye;
uniform vec3 sun;       // of length 1
uniform vec3 level;     // colours of the medium
uniform vec3 upwards;
uniform vec3 downwards;
uniform vec2 haze;      // m: where it begins, where it has half after that
vec3 around(float rise) {
    vec3 color = mix(level, upwards, smoothstep(0.0, 0.75, rise));
    return mix(color, downwards, smoothstep(0.0, 0.8, -rise));
}
vec3 hazed(vec3 color, vec3 way) {
    float far = length(way);
    float behind = max(0.0, far - haze.x);
    return mix(color, around(way.y / far), behind / (behind + haze.y));
}
// Less than a step of a channel, against bands in slow gradients.
vec3 dithered(vec3 color) {
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    return color + (noise - 0.5) / 255.0;
}
)";

inline constexpr const char* kSkyVertex = R"(
uniform mat3 look;  // columns: half the picture's width and height, and its middle, m
out vec3 way;
void main() {
    vec2 corner = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID & 2) * 2 - 1);
    way = look * vec3(corner, 1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";
inline constexpr const char* kSkyFragment = R"(
in vec3 way;
out vec4 color;
void main() {
    color = vec4(dithered(around(way.y * inversesqrt(dot(way, way)))), 1.0);
}
)";

inline constexpr const char* kFloorVertex = R"(
uniform mat4 view;
uniform vec2 middle;
uniform float height;
uniform float reach;
out vec3 place;
void main() {
    vec2 corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
    place = vec3(middle.x + reach * corner.x, height, middle.y + reach * corner.y);
    gl_Position = view * vec4(place, 1.0);
}
)";
// What a software renderer does not run must not be in the source, so there is a shader for each
// set of GRAIN, RIPPLES and LINES.
inline constexpr const char* kFloorFragment = R"(
in vec3 place;
uniform vec3 base;
uniform vec4 lines;
uniform vec2 origin;      // of the grid
uniform vec4 surface;     // grain, ripples, their shifts
uniform sampler2D grain;
out vec4 color;
void main() {
    vec2 at = place.xz - origin;
    vec3 paint = base;
#ifdef GRAIN
    float fine = texture(grain, at * 0.47).r;
#ifdef RIPPLES
    float coarse = texture(grain, at * 0.11).r;
#else
    float coarse = fine;
#endif
    paint *= 1.0 + surface.x * (fine + coarse - 1.0);
#endif
#ifdef RIPPLES
    float one = texture(grain, at * 0.21 + surface.zw).g;
    float other = texture(grain, at * 0.26 - surface.wz).g;
    paint *= 1.0 + surface.y * (2.6 * min(one, other) - 0.35);
#endif
#ifdef LINES
    vec2 wide = fwidth(at);
    vec2 away = abs(fract(at - 0.5) - 0.5) / wide;
    float on = 1.0 - min(min(away.x, away.y), 1.0);
    on *= clamp(1.3 - 4.0 * max(wide.x, wide.y), 0.0, 1.0);
    paint = mix(paint, lines.rgb, lines.a * on);
#endif
    color = vec4(dithered(hazed(paint, place - eye)), 1.0);
}
)";

// The part of the floor on which the shadow falls, which darkens what is there but not the haze
// before it: colour of the haze that is added, and the share of the picture that stays.
inline constexpr const char* kShadedVertex = R"(
uniform mat4 view;
uniform vec4 area;  // low corner and size
uniform float height;
out vec3 place;
out vec2 inside;
void main() {
    inside = vec2(gl_VertexID & 1, (gl_VertexID & 2) / 2);
    vec2 at = area.xy + inside * area.zw;
    place = vec3(at.x, height, at.y);
    gl_Position = view * vec4(place, 1.0);
}
)";
inline constexpr const char* kShadedFragment = R"(
in vec3 place;
in vec2 inside;
uniform float shade;
uniform sampler2D shadow;
out vec4 color;
void main() {
    vec2 dark = texture(shadow, inside).rg;
    float stays = (1.0 - shade * dark.r) * (1.0 - 0.5 * shade * dark.g);
    color = vec4((1.0 - stays) * hazed(vec3(0.0), place - eye), stays);
}
)";

// The boxes: five vectors each, its axes with the centre, its half extents, and one over the
// direction of the light in its frame.
inline constexpr const char* kBoxes = R"(
layout(std140) uniform Boxes { vec4 boxes[1000]; };

// Returns how far towards the light a ray from a point (in the box's frame) enters and leaves a box.
vec2 through_box(int i, vec3 start) {
    vec3 inverse = boxes[5 * i + 4].xyz;
    vec3 span = abs(inverse) * boxes[5 * i + 3].xyz;
    vec3 enter = -inverse * start - span;
    vec3 leave = -inverse * start + span;
    return vec2(max(max(enter.x, enter.y), enter.z), min(min(leave.x, leave.y), leave.z));
}
)";

// The shadow on the floor, as a picture of the floor from above.
inline constexpr const char* kShadowVertex = R"(
out vec2 share;
void main() {
    vec2 corner = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID & 2) * 2 - 1);
    share = 0.5 * corner + 0.5;
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";
inline constexpr const char* kShadowFragment = R"(
in vec2 share;
uniform vec3 sun;
uniform vec4 area;   // low corner and size
uniform float height;
uniform float soft;  // width of a shadow's edge, in metres a metre of its height
uniform int count;
out vec4 color;
void main() {
    vec2 at = area.xy + share * area.zw;
    float light = 1.0;
    float open = 1.0;
    for (int i = 0; i < count; ++i) {
        vec4 a = boxes[5 * i], b = boxes[5 * i + 1], c = boxes[5 * i + 2];
        vec3 half_size = boxes[5 * i + 3].xyz;
        vec3 from = vec3(at.x, height, at.y) - vec3(a.w, b.w, c.w);
        vec3 start = vec3(dot(a.xyz, from), dot(b.xyz, from), dot(c.xyz, from));
        vec2 passed = through_box(i, start);
        float middle = max(0.5 * (passed.x + passed.y), 0.02);
        float inside = (passed.y - passed.x) / (middle * soft + 0.02);
        light *= 1.0 - smoothstep(-1.0, 1.0, inside) * step(0.0, passed.y);
        float near = dot(from, from) / dot(half_size, half_size);
        open *= 1.0 - 0.55 / (1.0 + 0.6 * near * near);
    }
    vec2 rim = min(share, 1.0 - share);
    float fade = clamp(10.0 * min(rim.x, rim.y), 0.0, 1.0);
    color = vec4(fade * (1.0 - light), fade * (1.0 - open), 0.0, 1.0);
}
)";

inline constexpr const char* kSolidVertex = R"(
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 axis_x;  // of the solid, with the centre
layout(location = 3) in vec4 axis_y;
layout(location = 4) in vec4 axis_z;
layout(location = 5) in vec4 size;    // half extents, radius
layout(location = 6) in vec4 fill;
layout(location = 7) in vec4 look;    // pattern, one over its wave, phase, gleam
layout(location = 8) in vec4 beside;  // indices of boxes that may shade it; -1 for none
layout(location = 9) in vec4 beside_too;
uniform mat4 view;
uniform vec4 grow;                    // what pushes the surface out: a metre of distance, direction
uniform vec3 eye;
out vec3 place;
out vec3 outward;
out vec3 inside;
flat out vec4 paint;
flat out vec4 kind;
flat out ivec4 near;
flat out ivec4 near_too;
flat out vec3 extent;
void main() {
    vec3 middle = vec3(axis_x.w, axis_y.w, axis_z.w);
    float wider = grow.x * max(dot(eye - middle, grow.yzw), 0.0);
    inside = corner * (size.xyz - size.w) + normal * size.w;
    vec3 out_there = inside + normal * wider;
    mat3 back = mat3(axis_x.xyz, axis_y.xyz, axis_z.xyz);
    place = middle + back * out_there;
    outward = back * normal;
    paint = fill;
    kind = look;
    near = ivec4(beside);
    near_too = ivec4(beside_too);
    extent = size.xyz;
    gl_Position = view * vec4(place, 1.0);
}
)";

// There is a shader for each PATTERN.
inline constexpr const char* kSolidFragment = R"(
in vec3 place;
in vec3 outward;
in vec3 inside;
flat in vec4 paint;
flat in vec4 kind;
flat in ivec4 near;
flat in ivec4 near_too;
flat in vec3 extent;
uniform vec3 key;
uniform vec3 above;
uniform vec3 below;
uniform float dimness;
out vec4 color;

// Takes away the light that a box keeps from this point: of the sun, and from around.
void shade_by(int i, vec3 normal, inout float light, inout float open) {
    vec4 a = boxes[5 * i], b = boxes[5 * i + 1], c = boxes[5 * i + 2];
    vec3 half_size = boxes[5 * i + 3].xyz;
    vec3 from = place - vec3(a.w, b.w, c.w);
    vec3 start = vec3(dot(a.xyz, from), dot(b.xyz, from), dot(c.xyz, from));
    vec2 passed = through_box(i, start);
    float middle = max(0.5 * (passed.x + passed.y), 0.0);
    float through = (passed.y - passed.x) / (0.25 * middle + 0.25 * half_size.y + 0.01);
    light *= 1.0 - smoothstep(-0.5, 1.0, through) * smoothstep(0.0, 0.04, passed.y);
    vec3 beyond = max(abs(start) - half_size, 0.0);
    float gap = length(beyond);
    vec3 there = sign(start) * beyond;
    vec3 turned = vec3(dot(a.xyz, normal), dot(b.xyz, normal), dot(c.xyz, normal));
    float facing = gap > 0.0001 ? dot(turned, -there) / gap : 1.0;
    open *= 1.0 - 0.62 * clamp(0.35 + 0.65 * facing, 0.0, 1.0) *
            exp2(-gap / (0.45 * min(half_size.y, half_size.z) + 0.005));
}

#if PATTERN > 0
// Returns how dark the pattern is, 0 to 1.
float pattern() {
    vec3 at = inside * kind.y;
    float along = at.x + kind.z;
    float sway = 0.12 * sin(at.y * 4.7 + kind.z * 5.0) + 0.10 * sin(at.z * 5.3);
#if PATTERN == 1
    float wave = abs(fract(along + sway) - 0.5) * 4.0 - 0.9;
#elif PATTERN == 2
    vec3 row = floor(at * 1.5 + 0.5);
    vec3 cell = at * 1.5 - row + vec3(0.2 * sin(3.7 * row.y), 0.0, 0.2 * sin(5.1 * row.x));
    float wave = (0.33 - length(cell)) * 7.0;
#elif PATTERN == 3
    float wave = abs(fract((at.y + at.z) * 0.95 + 0.25 + 0.06 * sin(along * 6.28318)) - 0.5) * 4.0 - 1.0;
#elif PATTERN == 4
    float wave = (inside.y / extent.y * 1.5 - 0.1 + 0.34 * sin(along * 6.28318) + sway) * 2.0;
#else
    float wave = abs(fract(along - (abs(at.y) + abs(at.z)) * 0.55) - 0.5) * 4.0 - 1.0;
#endif
    return smoothstep(-0.25, 0.25, wave);
}
#endif

void main() {
    vec3 normal = normalize(outward);
    vec3 way = place - eye;
    vec3 sight = normalize(way);
    float light = 1.0;
    float open = 1.0;
    for (int k = 0; k < 4 && near[k] >= 0; ++k) shade_by(near[k], normal, light, open);
    for (int k = 0; k < 4 && near_too[k] >= 0; ++k) shade_by(near_too[k], normal, light, open);
    light = 1.0 - dimness * (1.0 - light);
    vec3 base = paint.rgb * paint.rgb;
#if PATTERN > 0
    base *= 1.0 - 0.42 * pattern();
#endif
    float facing = dot(normal, sun);
    float lit = max(0.86 * facing + 0.14, 0.0) * light;
    vec3 sky = mix(below, above, 0.5 + 0.5 * normal.y);
    vec3 shown = base * (sky * sky * open + key * lit);
    vec3 between = normalize(sun - sight);
    float gleam = max(dot(normal, between), 0.0);
    gleam *= gleam; gleam *= gleam; gleam *= gleam; gleam *= gleam;
    shown += key * light * (kind.w > 0.5 ? 0.9 * gleam * gleam * gleam : 0.10 * gleam);
    float edge = 1.0 + dot(normal, sight);
    shown += 0.32 * edge * edge * edge * above * above * open * (0.6 + 0.4 * normal.y);
    color = vec4(hazed(sqrt(clamp(shown, 0.0, 1.0)), way), paint.a);
}
)";

inline constexpr const char* kInkFragment = R"(
in vec3 place;
flat in vec4 paint;
uniform float ink;
out vec4 color;
void main() { color = vec4(hazed(paint.rgb * ink, place - eye), 1.0); }
)";

inline constexpr const char* kMarkVertex = R"(
layout(location = 0) in vec4 disc;    // centre, radius
layout(location = 1) in vec4 fill;
layout(location = 2) in vec2 edge;    // least radius in metres a metre of distance; softness
uniform mat4 view;
uniform vec3 right;
uniform vec3 up;
uniform vec3 back;
uniform vec3 eye;
out vec2 point;
out vec3 place;
flat out vec4 paint;
flat out float soft;
void main() {
    point = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
    float wide = max(disc.w, edge.x * max(dot(eye - disc.xyz, back), 0.0));
    place = disc.xyz + wide * (point.x * right + point.y * up);
    paint = fill;
    soft = edge.y;
    gl_Position = view * vec4(place, 1.0);
}
)";
inline constexpr const char* kMarkFragment = R"(
in vec2 point;
in vec3 place;
flat in vec4 paint;
flat in float soft;
out vec4 color;
void main() {
    float cover = clamp((1.0 - length(point)) / soft, 0.0, 1.0);
    color = vec4(paint.rgb, paint.a * cover);
}
)";

// Smooths edges while it copies: where neighbours differ, colours are mixed along the edge.
inline constexpr const char* kSmoothFragment = R"(
in vec2 share;
uniform sampler2D picture;
uniform vec2 pixel;    // share of the picture
uniform ivec2 corner;  // of the target
out vec4 color;
vec3 at(int x, int y) { return texelFetch(picture, ivec2(gl_FragCoord.xy) - corner + ivec2(x, y), 0).rgb; }
float luma(vec3 paint) { return dot(paint, vec3(0.3, 0.59, 0.11)); }
void main() {
    vec3 here = at(0, 0);
    float middle = luma(here);
    float north = luma(at(0, 1)), south = luma(at(0, -1));
    float east = luma(at(1, 0)), west = luma(at(-1, 0));
    float most = max(middle, max(max(north, south), max(east, west)));
    float least = min(middle, min(min(north, south), min(east, west)));
    vec2 across = vec2(east - west, north - south);
    vec2 along = vec2(-across.y, across.x) * inversesqrt(dot(across, across) + 1e-8) * pixel;
    vec2 place = (gl_FragCoord.xy - vec2(corner)) * pixel;
    vec3 near = texture(picture, place + 0.5 * along).rgb + texture(picture, place - 0.5 * along).rgb;
    vec3 far = texture(picture, place + 1.5 * along).rgb + texture(picture, place - 1.5 * along).rgb;
    vec3 mixed = mix(0.25 * near + 0.25 * far, here, 0.3);
    color = vec4(most - least < 0.05 ? here : mixed, 1.0);
}
)";

}  // namespace cambrian::space_shader
