// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/frames.h"

#include <zstd.h>

#include <algorithm>
#include <limits>

#include "base/contract.h"
#include "trace/import/compression.h"

namespace rivulet::trace {

namespace {

/// Fast enough for a thread beside the stream; higher levels gain little on numbers.
constexpr int kFrameLevel = 3;
constexpr std::string_view kFrameMagic = "\x28\xB5\x2F\xFD";
/// The table is a seek table of the zstd seekable format: other tools can use it.
constexpr std::uint32_t kSkippableMagic = 0x184D2A5EU;
constexpr std::uint32_t kSeekableMagic = 0x8F92EAB1U;
/// The index of a recording is a frame that every other reader skips.
constexpr std::uint32_t kIndexMagic = 0x184D2A50U;
constexpr int kIndexLevel = 9;
constexpr std::size_t kFooterBytes = 9;
constexpr std::size_t kEntryBytes = 8;
/// The table has 32 bits for the size of a frame.
constexpr std::uint64_t kFrameTextMax = std::numeric_limits<std::uint32_t>::max();
/// Of an index, packed and unpacked; one of `RecordingIndex::kGroupsMax` groups is much smaller.
constexpr base::Budget kIndexBudget(std::uint64_t{64} << 20U);

void appendLittle(std::string& out, std::uint32_t value) {
  for (unsigned shift = 0; shift < 32; shift += 8) {
    out += static_cast<char>((value >> shift) & 0xFFU);
  }
}

std::uint32_t littleAt(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (unsigned i = 0; i < 4; ++i) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  }
  return value;
}

struct FramePlace {
  std::size_t begin = 0;
  std::size_t size = 0;
};

struct FramePlaces {
  std::vector<FramePlace> frames;
  bool isCut = false;
  std::size_t cutAt = 0;  ///< where the frame begins that is not whole
  bool hasTable = false;
  std::size_t damaged = 0;
};

bool isSkippable(std::string_view bytes, std::size_t at) {
  return bytes.size() - at >= 8 && (littleAt(bytes, at) & 0xFFFFFFF0U) == 0x184D2A50U;
}

/// By the sizes in the frames. Where these are damaged, the search goes on at the next beginning of
/// a frame.
FramePlaces findFrames(std::string_view bytes) {
  FramePlaces places;
  std::size_t at = 0;
  while (at < bytes.size()) {
    if (isSkippable(bytes, at)) {
      const std::size_t size = 8 + std::size_t{littleAt(bytes, at + 4)};
      places.hasTable = at + size == bytes.size() && littleAt(bytes, at) == kSkippableMagic;
      at += std::min(size, bytes.size() - at);
      continue;
    }
    const std::string_view rest = bytes.substr(at);
    const std::size_t size = ZSTD_findFrameCompressedSize(rest.data(), rest.size());
    if (ZSTD_isError(size) == 0) {
      places.frames.push_back({at, size});
      at += size;
      continue;
    }
    std::size_t next = bytes.find(kFrameMagic, at + 1);
    if (next != std::string_view::npos && next >= at + 8 &&
        littleAt(bytes, next - 8) == kIndexMagic) {
      next -= 8;  // the content of the index is no text of the recording
    }
    if (next == std::string_view::npos) {
      places.isCut = true;
      places.cutAt = at;
      break;
    }
    ++places.damaged;
    at = next;
  }
  return places;
}

/// The bytes of a frame's text; nothing: they are not said, or no frame of its size can hold them.
/// @source RFC 8878, 3.1.1.2: a block of 4 bytes stands for 128 KiB at most
std::optional<std::size_t> textBytes(std::string_view frame) {
  constexpr unsigned long long kGrowthMax = (128U << 10U) / 4;
  const unsigned long long size = ZSTD_getFrameContentSize(frame.data(), frame.size());
  const bool isSaid = size != ZSTD_CONTENTSIZE_ERROR && size != ZSTD_CONTENTSIZE_UNKNOWN;
  return isSaid && size / kGrowthMax <= frame.size() ? std::optional(static_cast<std::size_t>(size))
                                                     : std::nullopt;
}

/// Appends the text of a frame. @return false: it is damaged, and nothing is appended
bool appendText(std::string& text, std::string_view frame) {
  const std::optional<std::size_t> size = textBytes(frame);
  if (!size) {
    return false;
  }
  const std::size_t before = text.size();
  text.resize(before + *size);
  const std::size_t read = ZSTD_decompress(text.data() + before, *size, frame.data(), frame.size());
  const bool isWhole = ZSTD_isError(read) == 0 && read == *size;
  text.resize(isWhole ? text.size() : before);
  return isWhole;
}

base::Result<void> requireText(std::size_t size, const base::Budget& budget) {
  return budget.require(static_cast<double>(size), "The text of the recording");
}

/// Of a frame that is cut, or of what is none.
base::Result<std::string> unpackRest(std::string_view bytes, const base::Budget& budget) {
  auto last = unpack(bytes, budget);
  return last ? base::Result<std::string>(std::move(last->text)) : base::fail(last.error());
}

}  // namespace

std::string FrameWriter::frame(std::string_view lines) {
  RIVULET_ASSERT(lines.size() < kFrameTextMax);
  std::string packed = pack(lines, kFrameLevel);
  m_frames.push_back(
      {static_cast<std::uint32_t>(packed.size()), static_cast<std::uint32_t>(lines.size())});
  m_index.addFrame(lines, packed.size());
  return packed;
}

base::Duration FrameWriter::span() const {
  const IndexGroup all = m_index.total();
  return all.last < all.first ? base::Duration{} : all.last - all.first;
}

std::string FrameWriter::table() const {
  const std::string index = pack(printIndex(m_index), kIndexLevel);
  std::string out;
  appendLittle(out, kIndexMagic);
  appendLittle(out, static_cast<std::uint32_t>(index.size()));
  out += index;
  std::vector<Size> frames = m_frames;
  frames.push_back({static_cast<std::uint32_t>(out.size()), 0});
  appendLittle(out, kSkippableMagic);
  appendLittle(out, static_cast<std::uint32_t>(frames.size() * kEntryBytes + kFooterBytes));
  for (const Size& size : frames) {
    appendLittle(out, size.packed);
    appendLittle(out, size.text);
  }
  appendLittle(out, static_cast<std::uint32_t>(frames.size()));
  out += '\0';  // no checksums in the table: each frame has its own
  appendLittle(out, kSeekableMagic);
  return out;
}

std::optional<IndexPlace> findIndex(std::string_view tail, std::uint64_t fileBytes) {
  static_assert(kIndexTailBytes == kEntryBytes + kFooterBytes);
  if (tail.size() != kIndexTailBytes || littleAt(tail, tail.size() - 4) != kSeekableMagic) {
    return std::nullopt;
  }
  const std::uint64_t count = littleAt(tail, kEntryBytes);
  const std::uint64_t table = 8 + count * kEntryBytes + kFooterBytes;
  const std::uint64_t bytes = littleAt(tail, 0);
  if (littleAt(tail, 4) != 0 || table + bytes > fileBytes || bytes > kIndexBudget.left()) {
    return std::nullopt;
  }
  return IndexPlace{fileBytes - table - bytes, bytes};
}

std::optional<RecordingIndex> unpackIndex(std::string_view bytes) {
  if (bytes.size() < 8 || littleAt(bytes, 0) != kIndexMagic ||
      std::uint64_t{littleAt(bytes, 4)} + 8 != bytes.size() || !isCompressed(bytes.substr(8))) {
    return std::nullopt;
  }
  const auto text = unpack(bytes.substr(8), kIndexBudget);
  return text && text->whole ? parseIndex(text->text) : std::nullopt;
}

base::Result<void> forEachFrame(
    std::string_view bytes, const base::Budget& budget,
    const std::function<void(std::string_view text, std::uint64_t size)>& take) {
  if (!isCompressed(bytes)) {
    take(bytes, bytes.size());
    return {};
  }
  const FramePlaces places = findFrames(bytes);
  const std::size_t end = places.isCut ? places.cutAt : bytes.size();
  std::string text;
  for (std::size_t i = 0; i < places.frames.size(); ++i) {
    const std::string_view frame = bytes.substr(places.frames[i].begin, places.frames[i].size);
    if (auto fits = requireText(textBytes(frame).value_or(0), budget); !fits) {
      return fits;
    }
    text.clear();
    appendText(text, frame);
    const std::size_t next = i + 1 < places.frames.size() ? places.frames[i + 1].begin : end;
    take(text, next - places.frames[i].begin);
  }
  if (places.isCut) {
    const std::string_view rest = bytes.substr(places.cutAt);
    const auto last = unpackRest(rest, budget);
    if (!last) {
      return base::fail(last.error());
    }
    take(*last, rest.size());
  }
  return {};
}

base::Result<Frames> readFrames(std::string_view bytes, const base::Budget& budget) {
  const FramePlaces places = findFrames(bytes);
  Frames frames;
  frames.isCut = places.isCut;
  frames.hasTable = places.hasTable;
  frames.damaged = places.damaged;
  std::size_t size = 0;
  for (const FramePlace& place : places.frames) {
    size += textBytes(bytes.substr(place.begin, place.size)).value_or(0);
  }
  if (auto fits = requireText(size, budget); !fits) {
    return base::fail(fits.error());
  }
  frames.text.reserve(size);
  for (const FramePlace& place : places.frames) {
    frames.damaged += appendText(frames.text, bytes.substr(place.begin, place.size)) ? 0U : 1U;
  }
  if (places.isCut) {
    const auto last = unpackRest(bytes.substr(places.cutAt), budget.without(2 * size));
    if (!last) {
      return base::fail(last.error());
    }
    frames.text += *last;
  }
  return frames;
}

}  // namespace rivulet::trace
