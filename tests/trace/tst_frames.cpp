// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "base/random.h"
#include "support/test_program.h"
#include "trace/frames.h"
#include "trace/recording.h"

using namespace rivulet::trace;
namespace base = rivulet::base;

namespace {

struct Written {
  std::string bytes;
  std::string text;
  std::vector<std::size_t> ends;  ///< of the frames in the bytes
};

Written written(std::size_t frames, bool withTable) {
  Written all;
  FrameWriter writer;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    std::string lines;
    for (std::size_t line = 0; line < 50; ++line) {
      lines += "n " + std::to_string(1000 * frame + line) + " \"note\"\n";
    }
    all.bytes += writer.frame(lines);
    all.text += lines;
    all.ends.push_back(all.bytes.size());
  }
  all.bytes += withTable ? writer.table() : std::string();
  return all;
}

}  // namespace

class TestFrames : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everythingIsReadAgain() {
    for (const bool withTable : {false, true}) {
      const Written all = written(20, withTable);
      const Frames frames = readFrames(all.bytes).value();
      QCOMPARE(frames.text, all.text);
      QCOMPARE(frames.hasTable, withTable);
      QVERIFY(!frames.isCut && frames.damaged == 0);
    }
  }

  /// Wherever the file is cut, all whole frames before are read.
  void aCutFileKeepsItsFrames() {
    const Written all = written(5, true);
    const std::size_t frameText = all.text.size() / 5;
    for (std::size_t size = 4; size < all.bytes.size(); ++size) {
      const Frames frames = readFrames(std::string_view(all.bytes).substr(0, size)).value();
      const auto whole = std::count_if(all.ends.begin(), all.ends.end(),
                                       [size](std::size_t end) { return end <= size; });
      QCOMPARE(all.text.compare(0, frames.text.size(), frames.text), 0);
      QVERIFY(frames.text.size() + 500 >= static_cast<std::size_t>(whole) * frameText);
      QVERIFY(!frames.hasTable);
    }
  }

  /// Of a long frame that was cut, what can be unpacked is read.
  void aLongFrameIsReadUpToItsCut() {
    rivulet::base::Random random(7);
    std::string lines;
    while (lines.size() < 1'000'000) {
      lines += "n " + std::to_string(random.uniform()) + " \"note\"\n";
    }
    FrameWriter writer;
    const std::string bytes = writer.frame(lines);
    const Frames frames = readFrames(std::string_view(bytes).substr(0, bytes.size() / 2)).value();
    QVERIFY(frames.isCut);
    QVERIFY2(frames.text.size() > lines.size() / 4 && frames.text.size() < lines.size(),
             std::to_string(frames.text.size()).c_str());
    QCOMPARE(lines.compare(0, frames.text.size(), frames.text), 0);
  }

  /// A damaged frame is left out; those before and after it are read.
  void aDamagedFrameIsLeftOut() {
    const Written all = written(5, true);
    std::size_t detected = 0;
    for (std::size_t at = all.ends[1] + 1; at < all.ends[2]; ++at) {
      std::string damaged = all.bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
      const Frames frames = readFrames(damaged).value();
      detected += frames.text != all.text && (frames.damaged > 0 || frames.isCut) ? 1U : 0U;
      QVERIFY(frames.text.find("n 1049 ") != std::string::npos);
    }
    QCOMPARE(detected, all.ends[2] - all.ends[1] - 1);
  }

  /// Nobody unpacks what is larger than he may hold, and a size that no frame of so few bytes can
  /// have is a damage and no size.
  void theTextIsReadWithinItsBudget() {
    const Written all = written(20, true);
    const base::Budget enough(all.text.size());
    QCOMPARE(readFrames(all.bytes, enough)->text, all.text);
    const auto refused = readFrames(all.bytes, enough.without(1));
    QVERIFY(!refused && refused.error().code == base::BudgetError::Exceeded);
    std::size_t taken = 0;
    const base::Budget one(all.text.size() / 2);
    QVERIFY(forEachFrame(all.bytes, one, [&](std::string_view text, std::uint64_t) {
              taken += text.size();
            }).has_value());
    QCOMPARE(taken, all.text.size());
    QVERIFY(!forEachFrame(all.bytes, base::Budget(10), [](std::string_view, std::uint64_t) {}));
    // 4 bytes of magic, a descriptor that announces 8 bytes of size, and no block.
    const std::string boast = std::string("\x28\xB5\x2F\xFD\xE0", 5) +
                              std::string("\0\0\0\0\0\1\0\0", 8) + std::string("\1\0\0", 3);
    const auto frames = readFrames(boast + all.bytes, enough);
    QVERIFY(frames.has_value());
    QCOMPARE(frames->damaged, std::size_t{1});
    QCOMPARE(frames->text, all.text);
  }

  void aRecordingInFramesIsARecording() {
    FrameWriter writer;
    std::string bytes = writer.frame("rivulet-recording 1\nrun method=\"window\"\n");
    const std::string second = writer.frame("n 7 \"here\"\n");
    bytes += second;
    auto recording = parseRecording(bytes);
    QVERIFY(recording.has_value());
    QCOMPARE(recording->start.method, std::string("window"));
    QCOMPARE(recording->notes.size(), std::size_t{1});
    QCOMPARE(recording->unreadableLines, std::size_t{0});
    bytes.resize(bytes.size() - second.size() / 2);
    recording = parseRecording(bytes);
    QCOMPARE(recording->notes.size(), std::size_t{0});
    QCOMPARE(recording->unreadableLines, std::size_t{1});
  }
};

RIVULET_TEST(TestFrames)
#include "tst_frames.moc"
