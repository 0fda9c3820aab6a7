// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/import/compression.h"

#include <zstd.h>

#include <memory>

#include "base/contract.h"

namespace rivulet::trace {

namespace {

constexpr std::string_view kMagic = "\x28\xB5\x2F\xFD";

/// @param take  gets the text in pieces; false: no more is wanted
/// @return the archive is whole
template <class Take>
bool unpackInto(std::string_view bytes, Take take) {
  const std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream(ZSTD_createDStream(),
                                                                             ZSTD_freeDStream);
  RIVULET_ASSERT(stream != nullptr);
  std::string chunk(ZSTD_DStreamOutSize(), '\0');
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  for (;;) {
    ZSTD_outBuffer out{chunk.data(), chunk.size(), 0};
    const std::size_t before = in.pos;
    const std::size_t missing = ZSTD_decompressStream(stream.get(), &out, &in);
    if (ZSTD_isError(missing) != 0 || !take(std::string_view(chunk).substr(0, out.pos))) {
      return false;
    }
    const bool isAtEnd = in.pos == in.size && out.pos < out.size;
    if (isAtEnd || (in.pos == before && out.pos == 0)) {
      return missing == 0;  // the end of a frame
    }
  }
}

}  // namespace

bool isCompressed(std::string_view bytes) {
  return bytes.substr(0, kMagic.size()) == kMagic;
}

base::Result<Unpacked> unpack(std::string_view bytes, const base::Budget& budget) {
  // What the archive says of its size need not be true. Counted first, it is unpacked where it
  // stays: a text that grows is copied, and needs up to three times its size.
  std::size_t size = 0;
  unpackInto(bytes,
             [&](std::string_view chunk) { return (size += chunk.size()) <= budget.left(); });
  if (size > budget.left()) {
    return base::fail(budget.exceeded("The unpacked archive"));
  }
  Unpacked unpacked;
  unpacked.text.reserve(size);
  unpacked.whole = unpackInto(bytes, [&unpacked](std::string_view chunk) {
    unpacked.text += chunk;
    return true;
  });
  return unpacked;
}

std::string unpackFirst(std::string_view bytes, std::size_t count) {
  std::string text;
  unpackInto(bytes, [&](std::string_view chunk) {
    text += chunk.substr(0, count - text.size());
    return text.size() < count;
  });
  return text;
}

std::string pack(std::string_view text, int level) {
  const std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> context(ZSTD_createCCtx(),
                                                                        ZSTD_freeCCtx);
  RIVULET_ASSERT(context != nullptr);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  std::string packed(ZSTD_compressBound(text.size()), '\0');
  const std::size_t size =
      ZSTD_compress2(context.get(), packed.data(), packed.size(), text.data(), text.size());
  RIVULET_ASSERT(ZSTD_isError(size) == 0);
  packed.resize(size);
  return packed;
}

}  // namespace rivulet::trace
