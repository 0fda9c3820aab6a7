// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "base/random.h"
#include "support/test_program.h"
#include "trace/frames.h"
#include "trace/recording.h"

using namespace rivulet::trace;

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
      const Frames frames = readFrames(all.bytes);
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
      const Frames frames = readFrames(std::string_view(all.bytes).substr(0, size));
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
    const Frames frames = readFrames(std::string_view(bytes).substr(0, bytes.size() / 2));
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
      const Frames frames = readFrames(damaged);
      detected += frames.text != all.text && (frames.damaged > 0 || frames.isCut) ? 1U : 0U;
      QVERIFY(frames.text.find("n 1049 ") != std::string::npos);
    }
    QCOMPARE(detected, all.ends[2] - all.ends[1] - 1);
  }

  void theEndsAreFoundWithoutReadingAll() {
    for (const bool withTable : {false, true}) {
      const Written all = written(2000, withTable);
      const auto ends = readFrameEnds(all.bytes, 100);
      QVERIFY(ends.has_value());
      QCOMPARE(ends->frames, std::size_t{2000});
      QCOMPARE(ends->textBytes, all.text.size());
      QCOMPARE(all.text.compare(0, ends->head.size(), ends->head), 0);
      QVERIFY(ends->tail.size() < 5000);
      QCOMPARE(all.text.substr(all.text.size() - ends->tail.size()), ends->tail);
    }
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
