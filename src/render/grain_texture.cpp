#include "render/grain_texture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace cambrian {
namespace {

constexpr int kGrainSide = 256;  // texels

// Returns a number in [0, 1) that belongs to a point of a lattice.
float lattice(std::uint32_t x, std::uint32_t y, std::uint32_t salt) {
    std::uint32_t bits = x * 0x9E3779B1U ^ y * 0x85EBCA77U ^ salt * 0xC2B2AE3DU;
    bits = (bits ^ (bits >> 15U)) * 0x2C1B3C6DU;
    bits = (bits ^ (bits >> 12U)) * 0x297A2D39U;
    bits ^= bits >> 15U;
    return static_cast<float>(bits >> 8U) / 16777216.0F;
}

// Returns smooth noise, 0 to 1, that repeats after `period` cells each way.
float noise(float x, float y, std::uint32_t period, std::uint32_t salt) {
    const auto column = static_cast<std::uint32_t>(x);
    const auto row = static_cast<std::uint32_t>(y);
    const auto ease = [](float t) { return t * t * (3.0F - 2.0F * t); };
    const float right = ease(x - static_cast<float>(column));
    const float upper = ease(y - static_cast<float>(row));
    const auto at = [&](std::uint32_t i, std::uint32_t j) {
        return lattice((column + i) % period, (row + j) % period, salt);
    };
    const float low = at(0, 0) + right * (at(1, 0) - at(0, 0));
    const float high = at(0, 1) + right * (at(1, 1) - at(0, 1));
    return low + upper * (high - low);
}

// Returns how near a point is to the middle of the wall between two cells around scattered points,
// 0 to 1: the net of light that waves cast.
float net(float x, float y, std::uint32_t period) {
    const auto column = static_cast<int>(x);
    const auto row = static_cast<int>(y);
    float nearest = 9.0F;
    float second = 9.0F;
    const auto cells = static_cast<int>(period);
    for (int j = row - 1; j <= row + 1; ++j) {
        for (int i = column - 1; i <= column + 1; ++i) {
            const auto u = static_cast<std::uint32_t>((i + cells) % cells);
            const auto v = static_cast<std::uint32_t>((j + cells) % cells);
            const float dx = static_cast<float>(i) + lattice(u, v, 7) - x;
            const float dy = static_cast<float>(j) + lattice(u, v, 8) - y;
            const float away = std::sqrt(dx * dx + dy * dy);
            second = std::min(second, std::max(nearest, away));
            nearest = std::min(nearest, away);
        }
    }
    const float wall = std::clamp(1.0F - 2.2F * (second - nearest), 0.0F, 1.0F);
    return wall * wall;
}

}  // namespace

GLuint make_grain() {
    std::vector<std::uint8_t> texels;
    constexpr float kSide = kGrainSide;
    for (int y = 0; y < kGrainSide; ++y) {
        for (int x = 0; x < kGrainSide; ++x) {
            const float u = static_cast<float>(x) / kSide;
            const float v = static_cast<float>(y) / kSide;
            const float uneven = 0.5F * noise(8 * u, 8 * v, 8, 1) +
                                 0.3F * noise(24 * u, 24 * v, 24, 2) +
                                 0.2F * noise(72 * u, 72 * v, 72, 3);
            const float warp_x = 1.2F * noise(4 * u, 4 * v, 4, 4);
            const float warp_y = 1.2F * noise(4 * u, 4 * v, 4, 5);
            const float light =
                net(std::fmod(8 * u + warp_x, 8.0F), std::fmod(8 * v + warp_y, 8.0F), 8);
            for (const float share : {uneven, light, 0.0F, 1.0F})
                texels.push_back(static_cast<std::uint8_t>(255.0F * std::clamp(share, 0.0F, 1.0F)));
        }
    }
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kGrainSide, kGrainSide, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
}

}  // namespace cambrian
