// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A recording on disk: its text in compressed frames, each with a checksum, one after another. A
/// file that is cut off anywhere keeps all frames before; a frame that is damaged is left out. At
/// the end, a table says where each frame is. Format: docs/formats.md. @threadsafety pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/budget.h"
#include "base/result.h"
#include "trace/recording_index.h"

namespace rivulet::trace {

/// Makes the frames of a file, in order.
class FrameWriter {
 public:
  /// @param lines  whole lines  @return bytes to append to the file
  [[nodiscard]] std::string frame(std::string_view lines);
  /// The index and the table; what is appended after them is not found by them.
  /// @return bytes to append to the file
  [[nodiscard]] std::string table() const;
  /// From the first record of all frames to the last.
  [[nodiscard]] base::Duration span() const;

 private:
  struct Size {
    std::uint32_t packed = 0;
    std::uint32_t text = 0;
  };
  std::vector<Size> m_frames;
  RecordingIndex m_index;
};

/// So many last bytes of a file say where its index is.
inline constexpr std::uint64_t kIndexTailBytes = 17;
struct IndexPlace {
  std::uint64_t at = 0;  ///< in the file
  std::uint64_t bytes = 0;
};
/// @param tail  the last `kIndexTailBytes` of the file  @return nothing: it has no index
[[nodiscard]] std::optional<IndexPlace> findIndex(std::string_view tail, std::uint64_t fileBytes);
/// @return nothing: it is damaged, or larger than any index is
[[nodiscard]] std::optional<RecordingIndex> unpackIndex(std::string_view bytes);

/// The text of each frame in turn, and the bytes from it to the next: what is damaged between is
/// counted with the frame before. A text that is not compressed is one frame.
/// @param budget  of one frame
/// @return error BudgetError::Exceeded; the frames before have been taken
[[nodiscard]] base::Result<void> forEachFrame(
    std::string_view bytes, const base::Budget& budget,
    const std::function<void(std::string_view text, std::uint64_t size)>& take);

struct Frames {
  std::string text;         ///< of all frames that can be read, and of the beginning of a cut one
  std::size_t damaged = 0;  ///< frames whose checksum or content is wrong; left out
  bool isCut = false;       ///< the file ends within a frame
  bool hasTable = false;    ///< the writer came to its end
};

/// @param bytes  of which `isCompressed` is true
/// @return error BudgetError::Exceeded: the text is larger
[[nodiscard]] base::Result<Frames> readFrames(std::string_view bytes,
                                              const base::Budget& budget = {});

}  // namespace rivulet::trace
