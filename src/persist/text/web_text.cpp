#include "persist/text/web_text.h"

#include <cstdint>
#include <map>

namespace cambrian {
namespace {

// Replaces what would end or begin an element of a document.
std::string escaped(std::string_view text, const std::map<char, std::string_view>& escapes) {
    std::string result;
    for (const char c : text) {
        const auto escape = escapes.find(c);
        if (escape == escapes.end())
            result += c;
        else
            result += escape->second;
    }
    return result;
}

}  // namespace

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t j = 0; j < 3; ++j)
            three =
                three << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
        for (std::size_t j = 0; j < 4; ++j)
            text += i + j > bytes.size() ? '=' : kDigits[three >> (18 - 6 * j) & 63U];
    }
    return text;
}

std::string dense_text(std::string_view bytes) {
    constexpr std::uint32_t kSymbols = 91;
    constexpr int kBitsOfPair = 13;
    // The characters from '!', without '<', '\\' and '`'.
    const auto symbol = [](std::uint32_t value) {
        auto code = static_cast<char>('!' + value);
        for (const char left_out : {'<', '\\', '`'})
            if (code >= left_out) ++code;
        return code;
    };
    std::string text;
    text.reserve(bytes.size() * 16 / kBitsOfPair + 16);
    std::uint32_t held = 0;
    int bits = 0;
    const auto put = [&](std::uint32_t byte) {
        held |= byte << bits;
        bits += 8;
        if (bits < kBitsOfPair) return;
        const std::uint32_t pair = held & ((1U << kBitsOfPair) - 1U);
        text += symbol(pair % kSymbols);
        text += symbol(pair / kSymbols);
        held >>= kBitsOfPair;
        bits -= kBitsOfPair;
    };
    for (int i = 0; i < 4; ++i)
        put(static_cast<std::uint32_t>(bytes.size() >> (8 * i)) & 0xffU);
    for (const char byte : bytes)
        put(static_cast<unsigned char>(byte));
    for (int i = 0; i < 2; ++i)  // fill the last pair
        put(0);
    return text;
}

std::string html_text(std::string_view text) {
    return escaped(text, {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}});
}

std::string script_json(std::string_view json) {
    return escaped(json, {{'<', "\\u003c"}});
}

}  // namespace cambrian
