// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/frames.h"

#include <zstd.h>

#include <algorithm>

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
/// No frame of ours is larger.
constexpr std::uint64_t kFrameTextMax = std::uint64_t{1} << 30U;

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

/// By the table at the end; nothing: there is none.
std::optional<std::vector<FramePlace>> readSeekTable(std::string_view bytes) {
  if (bytes.size() < kFooterBytes + 8 || littleAt(bytes, bytes.size() - 4) != kSeekableMagic) {
    return std::nullopt;
  }
  const std::size_t count = littleAt(bytes, bytes.size() - kFooterBytes);
  const std::size_t size = 8 + count * kEntryBytes + kFooterBytes;
  if (size > bytes.size() || littleAt(bytes, bytes.size() - size) != kSkippableMagic) {
    return std::nullopt;
  }
  std::vector<FramePlace> frames;
  std::size_t at = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t entry = bytes.size() - size + 8 + i * kEntryBytes;
    const std::size_t packed = littleAt(bytes, entry);
    // The index has no text.
    if (littleAt(bytes, entry + 4) != 0) {
      frames.push_back({at, packed});
    }
    at += packed;
  }
  return at + size == bytes.size() ? std::optional(std::move(frames)) : std::nullopt;
}

std::optional<std::string> textOf(std::string_view frame) {
  const unsigned long long size = ZSTD_getFrameContentSize(frame.data(), frame.size());
  if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN || size > kFrameTextMax) {
    return std::nullopt;
  }
  std::string text(static_cast<std::size_t>(size), '\0');
  const std::size_t read = ZSTD_decompress(text.data(), text.size(), frame.data(), frame.size());
  return ZSTD_isError(read) == 0 && read == size ? std::optional(std::move(text)) : std::nullopt;
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
  if (littleAt(tail, 4) != 0 || table + bytes > fileBytes) {
    return std::nullopt;
  }
  return IndexPlace{fileBytes - table - bytes, bytes};
}

std::optional<RecordingIndex> unpackIndex(std::string_view bytes) {
  if (bytes.size() < 8 || littleAt(bytes, 0) != kIndexMagic ||
      std::uint64_t{littleAt(bytes, 4)} + 8 != bytes.size() || !isCompressed(bytes.substr(8))) {
    return std::nullopt;
  }
  const Unpacked text = unpack(bytes.substr(8));
  return text.whole ? parseIndex(text.text) : std::nullopt;
}

void forEachFrame(std::string_view bytes,
                  const std::function<void(std::string_view text, std::uint64_t size)>& take) {
  if (!isCompressed(bytes)) {
    take(bytes, bytes.size());
    return;
  }
  const FramePlaces places = findFrames(bytes);
  const std::size_t end = places.isCut ? places.cutAt : bytes.size();
  for (std::size_t i = 0; i < places.frames.size(); ++i) {
    const FramePlace& place = places.frames[i];
    const std::size_t next = i + 1 < places.frames.size() ? places.frames[i + 1].begin : end;
    take(textOf(bytes.substr(place.begin, place.size)).value_or(std::string()), next - place.begin);
  }
  if (places.isCut) {
    const std::string_view rest = bytes.substr(places.cutAt);
    take(unpack(rest).text, rest.size());
  }
}

Frames readFrames(std::string_view bytes) {
  const FramePlaces places = findFrames(bytes);
  Frames frames;
  frames.isCut = places.isCut;
  frames.hasTable = places.hasTable;
  frames.damaged = places.damaged;
  for (const FramePlace& place : places.frames) {
    if (const auto text = textOf(bytes.substr(place.begin, place.size))) {
      frames.text += *text;
    } else {
      ++frames.damaged;
    }
  }
  if (places.isCut) {
    frames.text += unpack(bytes.substr(places.cutAt)).text;
  }
  return frames;
}

std::optional<FrameEnds> readFrameEnds(std::string_view bytes, std::size_t tailBytes) {
  auto places = readSeekTable(bytes);
  if (!places) {
    places = findFrames(bytes).frames;
  }
  FrameEnds ends;
  ends.frames = places->size();
  for (const FramePlace& place : *places) {
    const unsigned long long size =
        ZSTD_getFrameContentSize(bytes.data() + place.begin, place.size);
    ends.textBytes += size < kFrameTextMax ? size : 0;
  }
  const auto head = places->empty()
                        ? std::nullopt
                        : textOf(bytes.substr(places->front().begin, places->front().size));
  // Without a whole frame, the beginning of the first one.
  ends.head = head ? *head : unpack(bytes).text;
  if (ends.head.empty()) {
    return std::nullopt;
  }
  for (std::size_t i = places->size(); i-- > 0 && ends.tail.size() < tailBytes;) {
    if (const auto text = textOf(bytes.substr((*places)[i].begin, (*places)[i].size))) {
      ends.tail.insert(0, *text);
    }
  }
  return ends;
}

}  // namespace rivulet::trace
