// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Long recordings: how many bytes are read, and that nothing is missing.

#include <QTemporaryDir>
#include <QtTest>

#include "base/file.h"
#include "support/test_program.h"
#include "trace/frames.h"
#include "trace/recording_reader.h"

using namespace rivulet;
using namespace rivulet::trace;
using namespace std::chrono_literals;

namespace {

/// Counts what is read of a text in memory.
class CountingBytes final : public base::ByteSource {
 public:
  CountingBytes(std::string bytes, std::uint64_t* count)
      : m_bytes(std::move(bytes)), m_count(count) {}
  [[nodiscard]] std::uint64_t size() const override { return m_bytes.size(); }
  [[nodiscard]] base::Result<std::string> read(std::uint64_t at, std::uint64_t bytes) override {
    std::string part = at < m_bytes.size() ? m_bytes.substr(at, bytes) : std::string();
    *m_count += part.size();
    return part;
  }

 private:
  std::string m_bytes;
  std::uint64_t* m_count;
};

struct Made {
  std::string bytes;       ///< as a file
  std::string unfinished;  ///< the same without index and table: its writer was killed
  std::string text;
};

LiveSample sampleAt(base::Instant at, int i) {
  return {at, base::Vec3{0.001 * i, -0.002 * i, 5.0}, 10.0 + i % 7};
}

/// As the recorder writes it: a frame in each half second, with observations and requests.
Made make(std::chrono::seconds length) {
  Made made;
  FrameWriter frames;
  std::string waiting;
  const auto flush = [&] {
    made.bytes += frames.frame(waiting);
    made.text += waiting;
    waiting.clear();
  };
  RecordingWriter writer([&waiting](std::string_view lines) {
    waiting += lines;
    return true;
  });
  RunStart start;
  start.method = "window";
  start.programName = "long.mpf";
  writer.start(start);
  gcode::PointList points;
  points.points.resize(10);
  writer.points(points);
  flush();
  const int halfSeconds = static_cast<int>(length / 500ms);
  for (int i = 0; i < halfSeconds; ++i) {
    const base::Instant at{500ms * i};
    writer.sample(sampleAt(at, i));
    writer.access({at + 1ms, 4ms + 1us * (i % 100), i % 2 == 0, 3});
    writer.sample(sampleAt(at + 250ms, i));
    if (i % 1000 == 0) {
      writer.note({at, "running"});
    }
    flush();
  }
  ControlTrace control;
  control.cycle = 4ms;
  for (int i = 0; i < halfSeconds; ++i) {
    ControlSample sample;
    sample.at = base::Instant{500ms * i + 2ms};
    control.samples.push_back(sample);
    if (i % 100 == 0) {
      control.blocks.push_back({sample.at, sample.at + 1s, {}, {}, 1.0});
    }
  }
  writer.controlTrace(control);
  flush();
  RunEnd end;
  end.outcome = "completed";
  end.duration = length;
  writer.end(end);
  flush();
  made.unfinished = made.bytes;
  made.bytes += frames.table();
  return made;
}

std::unique_ptr<CountingBytes> counted(const std::string& bytes, std::uint64_t& count) {
  return std::make_unique<CountingBytes>(bytes, &count);
}

}  // namespace

class TestRecordingReader : public QObject {
  Q_OBJECT

  Made m_long;

 private Q_SLOTS:
  void initTestCase() { m_long = make(10h); }

  /// Opening reads the index and nothing else; the index does not grow with the run.
  void tenHoursAreOpenedByTheirIndex() {
    std::uint64_t count = 0;
    const auto reader = RecordingReader::open(counted(m_long.bytes, count));
    QVERIFY(reader.has_value());
    QVERIFY(reader->hadIndex());
    const auto place =
        findIndex(std::string_view(m_long.bytes).substr(m_long.bytes.size() - kIndexTailBytes),
                  m_long.bytes.size());
    QVERIFY(place.has_value());
    QCOMPARE(count, kIndexTailBytes + place->bytes);
    QVERIFY2(count < m_long.bytes.size() / 20, qPrintable(QString::number(count)));
    QVERIFY(reader->index().groups.size() <= RecordingIndex::kGroupsMax);
    QCOMPARE(reader->start().programName, std::string("long.mpf"));
    QVERIFY(reader->end().has_value());
    QCOMPARE(reader->end()->duration, base::Duration(10h));
    const IndexGroup total = reader->index().total();
    QCOMPARE(total.samples, std::uint64_t{2 * 72000});
    QCOMPARE(total.accesses, std::uint64_t{72000});
    QCOMPARE(total.notes, std::uint64_t{72});
    QCOMPARE(total.controlSamples, std::uint64_t{72000});
    QCOMPARE(total.first, base::Instant{});
    QCOMPARE(total.positionMm[0].max, 0.001 * 71999);
    QCOMPARE(total.positionMm[1].min, -0.002 * 71999);
    QCOMPARE(total.positionMm[2].min, 5.0);
    QCOMPARE(total.feedMmPerS.max, 16.0);
    QCOMPARE(total.accessMs.max, 4.099);
  }

  /// A time is read with the groups in which it is; what is found is what the whole file holds.
  void aTimeIsReadAlone() {
    std::uint64_t count = 0;
    auto reader = RecordingReader::open(counted(m_long.bytes, count));
    QVERIFY(reader.has_value());
    const base::Instant from{20000s};
    const base::Instant until{20010s};
    std::uint64_t expected = 0;
    for (const IndexGroup& group : reader->index().groups) {
      expected += group.first <= until && group.last >= from ? group.bytes : 0;
    }
    count = 0;
    const auto part = reader->read(from, until);
    QVERIFY(part.has_value());
    QCOMPARE(count, expected);
    QCOMPARE(part->samples.size(), std::size_t{41});
    QCOMPARE(part->samples.front().at, from);
    QCOMPARE(part->samples.back().at, until);
    QCOMPARE(part->samples.front().positionMm->x, 0.001 * 40000);
    QCOMPARE(part->accesses.size(), std::size_t{20});
    QCOMPARE(part->notes.size(), std::size_t{1});
    QVERIFY(part->controlTrace.has_value());
    QCOMPARE(part->controlTrace->cycle, base::Duration(4ms));
    QCOMPARE(part->controlTrace->samples.size(), std::size_t{20});
    QCOMPARE(part->controlTrace->blocks.size(), std::size_t{1});
    QVERIFY(part->points.points.empty() && !part->pointsComplete);
    QCOMPARE(part->start.programName, std::string("long.mpf"));
    QVERIFY(part->end.has_value());
  }

  /// The parts, one after another, are the whole.
  void thePartsAreTheWhole() {
    const Made made = make(5min);
    const auto whole = parseRecording(made.bytes);
    QVERIFY(whole.has_value());
    QCOMPARE(whole->unreadableLines, std::size_t{0});
    for (const std::string& bytes : {made.bytes, made.unfinished, made.text}) {
      std::uint64_t count = 0;
      auto reader = RecordingReader::open(counted(bytes, count));
      QVERIFY(reader.has_value());
      QCOMPARE(reader->hadIndex(), bytes == made.bytes);
      std::vector<base::Instant> samples;
      for (auto from = base::Instant{}; from < base::Instant{5min}; from += 7s) {
        const auto part = reader->read(from, from + 7s - 1ns);
        QVERIFY(part.has_value());
        for (const LiveSample& sample : part->samples) {
          samples.push_back(sample.at);
        }
      }
      QCOMPARE(samples.size(), whole->samples.size());
      for (std::size_t i = 0; i < samples.size(); ++i) {
        QCOMPARE(samples[i], whole->samples[i].at);
      }
    }
  }

  /// Wherever the file was cut or damaged: what is there is found, or it is said that nothing is.
  void whatIsLeftIsFound() {
    const Made made = make(10s);
    for (std::size_t size = 0; size < made.bytes.size(); size += 3) {
      std::uint64_t count = 0;
      const std::string cut = made.bytes.substr(0, size);
      auto reader = RecordingReader::open(counted(cut, count));
      const auto whole = parseRecording(cut);
      QCOMPARE(reader.has_value(), whole.has_value());
      if (reader) {
        const auto part = reader->read(base::Instant{}, base::Instant{1h});
        QVERIFY(part.has_value());
        QCOMPARE(part->samples.size(), whole->samples.size());
        QCOMPARE(part->end.has_value(), whole->end.has_value());
      }
    }
    // A damaged index is made again.
    const auto place =
        findIndex(std::string_view(made.bytes).substr(made.bytes.size() - kIndexTailBytes),
                  made.bytes.size());
    QVERIFY(place.has_value());
    for (std::uint64_t at = place->at; at < place->at + place->bytes; at += 5) {
      std::string damaged = made.bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
      std::uint64_t count = 0;
      const auto reader = RecordingReader::open(counted(damaged, count));
      QVERIFY(reader.has_value());
      QCOMPARE(reader->index().total().samples, std::uint64_t{40});
      const auto recording = parseRecording(damaged);
      QVERIFY(recording.has_value());
      QCOMPARE(recording->samples.size(), std::size_t{40});
    }
  }

  void whatIsNoRecordingIsRefused() {
    std::uint64_t count = 0;
    QVERIFY(!RecordingReader::open(counted("rubbish\n", count)).has_value());
    QVERIFY(!RecordingReader::open(counted("", count)).has_value());
    QVERIFY(!RecordingReader::open(counted("rivulet-recording 999\n", count)).has_value());
  }

  /// A file that does not fit into the memory is not taken into it.
  void aHugeFileWithoutIndexIsRefused() {
    class Huge final : public base::ByteSource {
     public:
      [[nodiscard]] std::uint64_t size() const override { return std::uint64_t{50} << 30U; }
      [[nodiscard]] base::Result<std::string> read(std::uint64_t, std::uint64_t bytes) override {
        return std::string(static_cast<std::size_t>(std::min<std::uint64_t>(bytes, 1000)), '\0');
      }
    };
    const auto reader = RecordingReader::open(std::make_unique<Huge>());
    QVERIFY(!reader.has_value());
    QVERIFY(reader.error().code == base::BudgetError::Exceeded);
  }

  void filesAreReadInParts() {
    QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath(QStringLiteral("a")).toStdString();
    QVERIFY(base::writeFile(path, "0123456789").has_value());
    auto file = base::FileBytes::open(path);
    QVERIFY(file.has_value());
    QCOMPARE(file->size(), std::uint64_t{10});
    QCOMPARE(file->read(3, 4).value(), std::string("3456"));
    QCOMPARE(file->read(8, 4).value(), std::string("89"));
    QCOMPARE(file->read(20, 4).value(), std::string());
    QVERIFY(!base::FileBytes::open(path / "none").has_value());
    QVERIFY(!base::FileBytes::open(path.parent_path()).has_value());
  }
};

RIVULET_TEST(TestRecordingReader)
#include "tst_recording_reader.moc"
