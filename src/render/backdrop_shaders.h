#pragma once

// The shaders that paint backdrops. Noise is interpolated between values hashed from the corners of
// a lattice of integers, so it has the same bits with every driver that rounds alike.

namespace cambrian::backdrop {

inline constexpr const char* kVertexSource = R"(#version 330 core
layout(location = 0) in vec2 corner;  // texels
uniform vec2 size;                    // texels, of the whole texture
void main() {
    gl_Position = vec4(2.0 * corner / size - 1.0, 0.0, 1.0);
}
)";

// Before each of the others. A period of 0 means none.
inline constexpr const char* kNoiseSource = R"(#version 330 core
uniform vec2 size;
out vec4 color;

float hashed(ivec2 cell) {
    uint h = uint(cell.x) * 0x9E3779B1u ^ uint(cell.y) * 0x85EBCA77u;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    return float((h ^ (h >> 15)) >> 8) / 16777216.0;
}

float noise(vec2 at, int period) {
    ivec2 low = ivec2(floor(at));
    vec2 share = at - vec2(low);
    share *= share * (3.0 - 2.0 * share);
    int left = period > 0 ? low.x % period : low.x;
    int right = period > 0 ? (low.x + 1) % period : low.x + 1;
    return mix(mix(hashed(ivec2(left, low.y)), hashed(ivec2(right, low.y)), share.x),
               mix(hashed(ivec2(left, low.y + 1)), hashed(ivec2(right, low.y + 1)), share.x),
               share.y);
}

// Sum of octaves, 0 to 1.
float layered(vec2 at, int period) {
    float sum = 0.0;
    float share = 0.5;
    for (int octave = 0; octave < 5; ++octave) {
        sum += share * noise(at, period);
        at *= 2.0;
        period *= 2;
        share *= 0.5;
    }
    return sum / 0.97;
}

// Hides the steps of eight bits.
vec3 dithered(vec3 paint) {
    return paint + (hashed(ivec2(gl_FragCoord.xy) + 17) - 0.5) / 255.0;
}
)";

// The sky at half its size, smooth enough to be enlarged.
inline constexpr const char* kSkySource = R"(
uniform vec3 low;
uniform vec3 middle;
uniform vec3 high;
uniform vec3 ranges;   // of heights: where the gradient begins, its length; and the view's height
uniform vec2 weather;  // clouds, shafts
void main() {
    vec2 at = gl_FragCoord.xy;
    float t = clamp((at.y - ranges.x) / ranges.y, 0.0, 1.0);
    vec3 paint = t < 0.5 ? mix(low, middle, smoothstep(0.0, 0.5, t))
                         : mix(middle, high, smoothstep(0.5, 1.0, t));
    if (weather.x > 0.0) {
        int period = int(max(1.0, floor(1.5 * size.x / ranges.z + 0.5)));
        vec2 place = vec2(at.x / size.x * float(period) + 1.0, at.y / ranges.z * 4.3 + 23.1);
        float thick = layered(place, period);
        float towards_sun = layered(place + vec2(0.05, 0.16), period);
        float cover = smoothstep(0.53, 0.72, thick) * smoothstep(0.25, 0.55, t) * weather.x;
        vec3 bright = mix(low, vec3(1.0), 0.80);
        vec3 dim = mix(middle, vec3(1.0), 0.30) * 0.94;
        paint = mix(paint, mix(bright, dim, smoothstep(0.0, 0.25, thick - towards_sun + 0.06)),
                    0.85 * cover);
    }
    if (weather.y > 0.0) {
        float x = at.x / size.x;
        float light = 0.0;
        for (int shaft = 0; shaft < 9; ++shaft) {
            float middle_at = (float(shaft) + 0.7 * hashed(ivec2(shaft, 4))) / 9.0;
            float width = 0.012 + 0.028 * hashed(ivec2(shaft, 8));
            float away = fract(x - middle_at - (1.0 - t) * 0.12 + 0.5) - 0.5;
            away /= width * (0.5 + 1.2 * (1.0 - t));
            light += exp(-away * away) * (0.4 + 0.6 * hashed(ivec2(shaft, 2)));
        }
        paint += vec3(0.55, 0.85, 0.80) * light * 0.11 * smoothstep(0.15, 1.0, t) * weather.y;
        int waves = int(max(1.0, floor(6.0 * size.x / ranges.z + 0.5)));
        float ripple = noise(vec2(x * float(waves), 1.0), waves) - 0.5;
        paint += vec3(0.6, 0.9, 0.9) * smoothstep(0.92, 1.0, t + 0.035 * ripple) * 0.22 * weather.y;
    }
    color = vec4(paint, 1.0);
}
)";

// The sky at its full size, with stars, and what stands still among them.
inline constexpr const char* kFinishSource = R"(
uniform sampler2D picture;
uniform vec3 body;        // texels: place, radius; none if the radius is 0
uniform vec4 body_color;  // and 1 for the Earth
uniform float stars;
uniform vec2 ranges;      // of heights: where stars begin, and where all are seen
void main() {
    vec2 at = gl_FragCoord.xy;
    vec3 paint = texture(picture, at / size).rgb;
    if (stars > 0.0) {
        vec2 cell = floor(at / 11.0);
        ivec2 which = ivec2(cell);
        vec2 place = 2.0 + 7.0 * vec2(hashed(which + 51), hashed(which + 87));
        float bright = step(1.0 - 0.08 * stars, hashed(which + 3)) * pow(hashed(which + 9), 2.0);
        float away = length(at - 11.0 * cell - place);
        paint += vec3(0.95, 0.97, 1.0) * 1.1 * bright * smoothstep(1.5, 0.2, away) *
                 smoothstep(ranges.x, ranges.y, at.y);
    }
    if (body.z > 0.0) {
        vec2 there = (at - body.xy) / body.z;
        float away = length(there);
        float inside = clamp((1.0 - away) * body.z * 0.8, 0.0, 1.0);
        if (body_color.a > 0.5) {
            float front = sqrt(max(0.0, 1.0 - away * away));
            float land = smoothstep(0.50, 0.56, layered(there * 2.1 / (0.6 + 0.6 * front) + 14.0, 0));
            float cover = smoothstep(0.5, 0.75, layered(there * vec2(1.6, 4.0) + 21.0, 0));
            vec3 globe = mix(vec3(0.08, 0.27, 0.55), vec3(0.23, 0.42, 0.22), land);
            globe = mix(globe, vec3(0.95), 0.75 * cover);
            float day = clamp(dot(vec3(there, front), normalize(vec3(-0.7, 0.35, 0.55))), 0.0, 1.0);
            paint = mix(paint, globe * (0.03 + 1.05 * day), inside);
            paint += vec3(0.25, 0.45, 0.9) * exp(-9.0 * max(away - 1.0, 0.0)) * 0.30 *
                     (1.0 - inside) * clamp(0.5 - there.x, 0.0, 1.0);
        } else {
            inside *= clamp((length(there - vec2(0.42, 0.12)) - 0.95) * body.z * 0.8, 0.0, 1.0);
            paint = mix(paint, body_color.rgb, inside) + body_color.rgb * exp(-0.9 * away) * 0.10;
        }
    }
    color = vec4(dithered(paint), 1.0);
}
)";

// A chain of hills, dunes, bergs or clouds as far up as its strip; transparent above them.
inline constexpr const char* kRidgeSource = R"(
uniform vec4 strip;  // texels: foot, height; seed, waves across the picture
uniform vec3 crest;
uniform vec3 foot;
uniform vec3 glint;  // added along the crest
uniform float rough;
uniform int form;    // of RidgeForm
void main() {
    float up = (gl_FragCoord.y - strip.x) / strip.y;
    float across = gl_FragCoord.x / size.x * strip.w;
    int waves = int(strip.w);
    float seed = strip.z;
    float height = 0.25 + 0.60 * layered(vec2(across, seed), waves);
    if (form == 1) height = 0.30 + 0.42 * layered(vec2(across, seed), waves);
    if (form == 2) {
        float peaks = 2.0 * abs(noise(vec2(2.0 * across, seed), 2 * waves) - 0.5);
        float edges = 2.0 * abs(noise(vec2(4.0 * across, seed + 5.0), 4 * waves) - 0.5);
        height = 0.18 + 0.10 * (1.0 - edges) +
                 0.50 * (1.0 - peaks) * (0.35 + 0.65 * layered(vec2(across, seed + 2.0), waves));
    }
    height += rough * (layered(vec2(16.0 * across, seed + 3.0), 16 * waves) - 0.5);
    float below = (height - up) * strip.y;
    float cover = clamp(below + 0.5, 0.0, 1.0);
    if (form == 3) {
        float thick = layered(vec2(2.0 * across, 2.4 * up + seed), 2 * waves);
        cover = smoothstep(0.0, 0.22, thick + 0.27 - 1.25 * up);
    }
    float grain = layered(vec2(10.0 * across, 18.0 * up + 3.0), 10 * waves);
    vec3 paint = mix(crest, foot, clamp(below / (0.75 * strip.y), 0.0, 1.0));
    paint = paint * (0.965 + 0.07 * grain) + glint * clamp(1.0 - below / 5.0, 0.0, 1.0);
    if (form == 2)
        paint = mix(paint, vec3(1.0), 0.40 * smoothstep(0.30, 0.0, below / strip.y) *
                                          smoothstep(0.35, 0.6, grain));
    color = vec4(paint, cover);
}
)";

// Ground that is cut open, a tile of it; its surface is the upper edge.
inline constexpr const char* kSoilSource = R"(
uniform vec3 cover;
uniform vec3 upper;
uniform vec3 deep;
uniform vec3 stones;
uniform int form;  // of SoilForm
void main() {
    const int kWaves = 4;  // across the tile
    float down = (size.y - gl_FragCoord.y) / size.y;
    vec2 at = vec2(gl_FragCoord.x, size.y - gl_FragCoord.y) / size.x * float(kWaves);
    float coarse = layered(at * 3.0, 3 * kWaves);
    float fine = layered(at * 12.0 + vec2(0.0, 7.0), 12 * kWaves);
    vec2 bent = vec2(at.x * 5.0, at.y * 8.0);
    bent.y += 0.5 * noise(vec2(at.x * 3.0, at.y * 5.6), 3 * kWaves);
    float lump = noise(bent, 5 * kWaves);
    vec3 paint = mix(upper, deep, smoothstep(0.0, 1.0, 1.1 * down));
    if (form == 0) {
        paint *= 0.74 + 0.36 * coarse + 0.22 * (fine - 0.5);
        float stone = smoothstep(0.80, 0.83, lump);
        paint = mix(paint, stones * (0.7 + 0.5 * coarse), 0.55 * stone);
        paint -= 0.05 * smoothstep(0.76, 0.80, lump) * (1.0 - stone);
    } else if (form == 1) {
        paint *= 0.80 + 0.30 * coarse + 0.28 * (fine - 0.5);
        paint += stones * 0.10 * smoothstep(0.70, 0.85, lump);
        paint -= 0.05 * smoothstep(0.64, 0.70, lump);
    } else if (form == 2) {
        float crack = abs(layered(at * 2.0 + vec2(0.0, 3.0), 2 * kWaves) - 0.5);
        paint += 0.16 * stones * smoothstep(0.014, 0.0, crack) * (0.3 + 0.7 * coarse);
        paint = (paint + stones * 0.12 * (coarse - 0.4)) * (0.95 + 0.1 * fine);
    } else {
        paint *= (0.86 + 0.22 * coarse) * (0.97 + 0.05 * sin(70.0 * at.y + 6.0 * coarse));
    }
    float thick = form == 0 ? 0.050 : 0.030;
    float edge = thick * (0.55 + 0.9 * noise(vec2(at.x * 8.0, 2.0), 8 * kWaves));
    paint = mix(paint, cover * (0.80 + 0.45 * fine), smoothstep(edge, 0.55 * edge, at.y));
    if (form == 1 || form == 2) paint = mix(paint, cover, 0.8 * smoothstep(1.2 * edge, 0.0, at.y));
    color = vec4(dithered(paint), 1.0);
}
)";

// A tile of ground at another size.
inline constexpr const char* kScaleSource = R"(
uniform sampler2D picture;
void main() {
    color = texture(picture, gl_FragCoord.xy / size);
}
)";

// Ground below a line that slopes, whose soil lies along it. `line` is a place on it and its
// steepness, `tile` the size of the picture of ground and its column at the left edge of the view;
// all are in pixels.
inline constexpr const char* kSlopeSource = R"(
uniform sampler2D picture;
uniform vec2 view;
uniform vec3 line;
uniform vec3 tile;
uniform vec3 deep;
void main() {
    vec2 at = gl_FragCoord.xy - view;
    float depth = line.y + line.z * (at.x - line.x) - at.y;
    vec3 soil = texture(picture, vec2((at.x + tile.z) / tile.x, 1.0 - depth / tile.y)).rgb;
    if (depth > tile.y) soil = deep;
    color = vec4(soil, clamp(depth * inversesqrt(1.0 + line.z * line.z) + 0.5, 0.0, 1.0));
}
)";

}  // namespace cambrian::backdrop
