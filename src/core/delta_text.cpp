#include "core/delta_text.h"

#include "core/assert.h"

#include <zstd.h>

namespace cambrian {
namespace {

constexpr int kDeltaLevel = 1;  // higher levels save a tenth in five times the time and the memory

}  // namespace

void DeltaEncoder::Free::operator()(ZSTD_CCtx_s* context) const {
    ZSTD_freeCCtx(context);
}

DeltaEncoder::DeltaEncoder() : context_(ZSTD_createCCtx()) {
    CAMBRIAN_ASSERT(context_ != nullptr, "out of memory");
    ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_compressionLevel, kDeltaLevel);
    ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_contentSizeFlag, 0);
}

std::string_view DeltaEncoder::encode(std::string_view text, std::string_view base) {
    buffer_.resize(ZSTD_compressBound(text.size()));
    ZSTD_CCtx_refPrefix(context_.get(), base.data(), base.size());
    const std::size_t size =
        ZSTD_compress2(context_.get(), buffer_.data(), buffer_.size(), text.data(), text.size());
    CAMBRIAN_ASSERT(ZSTD_isError(size) == 0, "out of memory");
    return std::string_view(buffer_).substr(0, size);
}

void DeltaDecoder::Free::operator()(ZSTD_DCtx_s* context) const {
    ZSTD_freeDCtx(context);
}

DeltaDecoder::DeltaDecoder() : context_(ZSTD_createDCtx()) {
    CAMBRIAN_ASSERT(context_ != nullptr, "out of memory");
}

Result<std::string> DeltaDecoder::decode(std::string_view bytes, std::string_view base,
                                         std::size_t size) {
    std::string text(size, '\0');
    ZSTD_DCtx_refPrefix(context_.get(), base.data(), base.size());
    const std::size_t found =
        ZSTD_decompressDCtx(context_.get(), text.data(), text.size(), bytes.data(), bytes.size());
    if (ZSTD_isError(found) != 0 || found != size) return Error{"cannot be decompressed"};
    return text;
}

}  // namespace cambrian
