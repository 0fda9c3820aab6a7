// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/import/compression.h"

#include <zstd.h>

#include <memory>

#include "base/contract.h"

namespace rivulet::trace {

namespace {

constexpr std::string_view kMagic = "\x28\xB5\x2F\xFD";

}  // namespace

bool isCompressed(std::string_view bytes) {
  return bytes.substr(0, kMagic.size()) == kMagic;
}

Unpacked unpack(std::string_view bytes) {
  Unpacked unpacked;
  const std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream(ZSTD_createDStream(),
                                                                             ZSTD_freeDStream);
  RIVULET_ASSERT(stream != nullptr);
  std::string chunk(ZSTD_DStreamOutSize(), '\0');
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  std::size_t missing = 1;  // 0 at the end of a frame
  for (;;) {
    ZSTD_outBuffer out{chunk.data(), chunk.size(), 0};
    const std::size_t before = in.pos;
    missing = ZSTD_decompressStream(stream.get(), &out, &in);
    if (ZSTD_isError(missing) != 0) {
      unpacked.whole = false;
      return unpacked;
    }
    unpacked.text.append(chunk.data(), out.pos);
    if (unpacked.text.size() > kUnpackedBytesMax) {
      unpacked.whole = false;
      return unpacked;
    }
    if (in.pos == in.size && out.pos < out.size) {
      break;
    }
    if (in.pos == before && out.pos == 0) {
      break;
    }
  }
  unpacked.whole = missing == 0;
  return unpacked;
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
