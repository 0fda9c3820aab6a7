// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <algorithm>

#include "base/file.h"
#include "support/test_program.h"
#include "trace/recording.h"

using namespace rivulet::trace;
using rivulet::base::Duration;
using rivulet::base::Instant;
using namespace std::chrono_literals;

namespace {

Recording smallRecording() {
  Recording recording;
  recording.start = {"0.1.0",
                     "signal",
                     7,
                     "paper",
                     0.3,
                     10.0,
                     "part \"A\".mpf",
                     "00ff",
                     "opc.tcp://127.0.0.1:4840",
                     "2026-01-02T03:04:05Z"};
  recording.points.points = {{{0.1, 0.2, 0.3}, {1}}, {{-1e-12, 1.0 / 3.0, 5}, {2}}};
  recording.points.merged = 4;
  recording.samples = {{Instant{5ms}, rivulet::base::Vec3{1, 2, 3}, 4.5},
                       {Instant{6ms}, std::nullopt, 0.0},
                       {Instant{7ms}, rivulet::base::Vec3{-1, 2, 3}, std::nullopt},
                       {Instant{8ms}, std::nullopt, std::nullopt}};
  recording.accesses = {{Instant{1ms}, 4300us, false, 3}, {Instant{9ms}, 5us, true, 20}};
  recording.pauses = {{Instant{10ms}, 40ms, PauseOrigin::Inferred},
                      {Instant{90ms}, 41ms, PauseOrigin::Measured},
                      {Instant{95ms}, 42ms, PauseOrigin::Predicted}};
  recording.notes = {{Instant{2ms}, "running"},
                     {Instant{3ms}, std::string("two\nlines \\n \"q\" \r \0 x=1 \xC3\xA4", 27)}};
  ControlTrace trace;
  trace.cycle = 4ms;
  trace.samples = {{Instant{4ms}, {1, 2, 3}, {4, 5, 6}, 7.5, {8}}};
  trace.blocks = {{Instant{1ms}, Instant{2ms}, {3}, {0.1, 0.2, 0.3}, 0.25}};
  recording.controlTrace = trace;
  recording.end = RunEnd{"failed", 5, 4, 3, 2, 1s, "The control stopped: alarm 10720."};
  return recording;
}

std::size_t linesOf(std::string_view text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// Records read, each of which is one line of the file.
std::size_t recordsOf(const Recording& r) {
  std::size_t count = r.points.points.size() + r.samples.size() + r.accesses.size() +
                      r.pauses.size() + r.notes.size() + (r.end ? 1 : 0);
  if (r.controlTrace) {
    count += r.controlTrace->samples.size() + r.controlTrace->blocks.size();
  }
  return count;
}

}  // namespace

class TestRecording : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void printsTheDocumentedLines() {
    QCOMPARE(
        printRecording(smallRecording()),
        std::string("rivulet-recording 1\n"
                    "run tool=\"0.1.0\" method=\"signal\" points_per_loop=7 layout=\"paper\" "
                    "delta_mm=0.3 feed_mm_per_s=10 program=\"part \\\"A\\\".mpf\" hash=\"00ff\" "
                    "endpoint=\"opc.tcp://127.0.0.1:4840\" started_utc=\"2026-01-02T03:04:05Z\"\n"
                    "points count=2 merged=4\n"
                    "p 1 0.1 0.2 0.3\n"
                    "p 2 -1e-12 0.3333333333333333 5\n"
                    "l 5000000 1 2 3 4.5\n"
                    "l 6000000 - 0\n"
                    "l 7000000 -1 2 3 -\n"
                    "l 8000000 - -\n"
                    "a 1000000 4300000 r 3\n"
                    "a 9000000 5000 w 20\n"
                    "z 10000000 40000000 inferred\n"
                    "z 90000000 41000000 measured\n"
                    "z 95000000 42000000 predicted\n"
                    "n 2000000 \"running\"\n"
                    "n 3000000 \"two\\nlines \\\\n \\\"q\\\" \\r \\0 x=1 \xC3\xA4\"\n"
                    "trace cycle_ns=4000000 truncated=0\n"
                    "s 4000000 1 2 3 4 5 6 7.5 8\n"
                    "b 1000000 2000000 3 0.1 0.2 0.3 0.25\n"
                    "trace-end samples=1 blocks=1\n"
                    "end outcome=\"failed\" sent=5 accepted=4 executed=3 total=2 "
                    "duration_ns=1000000000 error=\"The control stopped: alarm 10720.\"\n"));
  }

  void eventsOfTheControlAreKept() {
    Recording recording = smallRecording();
    recording.controlTrace->events = {
        {Instant{1ms}, Instant{6ms}, {2}, ControlEvent::Kind::ToolChange, 3.0, "MILL"}};
    std::string text = printRecording(recording);
    const auto back = parseRecording(text);
    QVERIFY(back && back->complete && !back->controlTrace->truncated);
    QCOMPARE(back->controlTrace->events.size(), std::size_t{1});
    QCOMPARE(back->controlTrace->events[0].name, std::string("MILL"));
    const std::size_t event = text.find("\ne ") + 1;
    text.erase(event, text.find('\n', event) + 1 - event);
    QVERIFY(parseRecording(text)->controlTrace->truncated);
  }

  /// Which blocks of the program on the control follow each other without a stop.
  void continuationsAreKept() {
    const auto step = [](std::uint32_t from, std::uint32_t to) {
      return rivulet::base::Continuation{rivulet::base::LineNumber{from},
                                         rivulet::base::LineNumber{to}};
    };
    Recording recording = smallRecording();
    recording.start.continuations = {step(12, 13), step(13, 14), step(14, 12), step(14, 20)};
    const std::string text = printRecording(recording);
    QVERIFY2(text.find(" continues=\"12>13>14>12,14>20\"") != std::string::npos, text.c_str());
    QVERIFY(parseRecording(text)->start.continuations == recording.start.continuations);
    QVERIFY(parseRecording(printRecording(smallRecording()))->start.continuations.empty());
    for (const char* wrong : {"12>x", "0>1", "12>>13"}) {
      std::string damaged = text;
      damaged.replace(damaged.find("12>13>14>12"), 11, wrong);
      QVERIFY(parseRecording(damaged)->unreadableLines > 0);
    }
  }

  void readsBackWhatWasWritten() {
    const Recording recording = smallRecording();
    const std::string text = printRecording(recording);
    const auto back = parseRecording(text);
    QVERIFY(back);
    QVERIFY(back->complete);
    QVERIFY(back->pointsComplete);
    QCOMPARE(back->unreadableLines, std::size_t{0});
    QCOMPARE(back->start.programName, recording.start.programName);
    QCOMPARE(back->points.points[1].positionMm.y, 1.0 / 3.0);
    QVERIFY(!back->samples[1].positionMm);
    QVERIFY(!back->samples[2].feedMmPerS);
    QVERIFY(back->accesses[1].write);
    QCOMPARE(back->notes[1].text, recording.notes[1].text);
    QVERIFY(!back->controlTrace->truncated);
    QCOMPARE(back->end->errorText, recording.end->errorText);
    QCOMPARE(printRecording(*back), text);
  }

  /// While the run lasts, its trace comes in pieces between the other records.
  void aTraceInPiecesIsReadAsOne() {
    Recording recording = smallRecording();
    ControlTrace& trace = *recording.controlTrace;
    trace.samples.resize(7, trace.samples.front());
    trace.blocks.resize(3, trace.blocks.front());
    for (const bool isWhole : {true, false}) {
      std::string text;
      RecordingWriter writer([&text](std::string_view lines) {
        text += lines;
        return true;
      });
      writer.start(recording.start);
      writer.points(recording.points);
      ControlTrace piece;
      piece.cycle = trace.cycle;
      writer.controlTraceBegin(piece);
      piece.samples.assign(trace.samples.begin(), trace.samples.begin() + 4);
      piece.blocks.assign(trace.blocks.begin(), trace.blocks.begin() + 1);
      writer.controlTracePiece(piece);
      writer.note(recording.notes.front());
      piece.samples.assign(trace.samples.begin() + 4, trace.samples.end());
      piece.blocks.assign(trace.blocks.begin() + 1, trace.blocks.end());
      writer.controlTracePiece(piece);
      if (isWhole) {
        writer.controlTraceEnd();
      }
      writer.end(*recording.end);
      const auto read = parseRecording(text);
      QVERIFY(read.has_value() && read->controlTrace);
      QCOMPARE(read->controlTrace->truncated, !isWhole);
      QCOMPARE(read->notes.size(), std::size_t{1});
      ControlTrace seen = *read->controlTrace;
      seen.truncated = false;
      QVERIFY(printControlTrace(seen) == printControlTrace(trace));
    }
  }

  void aRunStillOpenIsReadable() {
    Recording recording = smallRecording();
    recording.end.reset();
    recording.controlTrace.reset();
    const auto back = parseRecording(printRecording(recording));
    QVERIFY(back);
    QVERIFY(!back->complete);
    QVERIFY(!back->controlTrace);
    QVERIFY(back->pointsComplete);
  }

  void keepsWholeLinesWhereverItIsCut() {
    const std::string text = printRecording(smallRecording());
    const std::size_t headerBytes = text.find('\n') + 1;
    // run, points, trace and trace-end are lines, but no records of their own.
    const auto withoutRecord = [&text](std::size_t length) {
      std::size_t count = 0;
      for (const char* keyword : {"\nrun ", "\npoints ", "\ntrace ", "\ntrace-end "}) {
        const std::size_t begin = text.find(keyword) + 1;
        count += text.find('\n', begin) < length ? 1U : 0U;
      }
      return count;
    };
    for (std::size_t length = 0; length <= text.size(); ++length) {
      const std::string cut = text.substr(0, length);
      const auto back = parseRecording(cut);
      if (length < headerBytes) {
        QVERIFY(!back);
        QVERIFY(length == 0 ? back.error().code == TraceError::NotATrace
                            : back.error().code == TraceError::Damaged);
        continue;
      }
      QVERIFY(back);
      QCOMPARE(back->complete, length == text.size());
      QCOMPARE(back->unreadableLines, std::size_t{cut.back() == '\n' ? 0U : 1U});
      QCOMPARE(recordsOf(*back), linesOf(cut) - 1 - withoutRecord(length));
      // A trace whose end is missing is never taken for a whole one.
      const bool traceWhole = cut.find("\ntrace-end samples=1 blocks=1\n") != std::string::npos;
      QVERIFY(!back->controlTrace || back->controlTrace->truncated == !traceWhole);
      QCOMPARE(back->pointsComplete, recordsOf(*back) >= 2);
    }
  }

  void survivesAnyChangedByte() {
    const std::string text = printRecording(smallRecording());
    const std::size_t headerBytes = text.find('\n') + 1;
    for (std::size_t i = headerBytes; i < text.size(); ++i) {
      for (const char c : {'\0', ' ', '\n', '"', '\\', 'x', '-', '='}) {
        std::string changed = text;
        changed[i] = c;
        const auto back = parseRecording(changed);
        QVERIFY(back);
        // At worst two halves of the line that begins a trace, and the three lines of the trace.
        QVERIFY(back->unreadableLines <= 5);
      }
    }
  }

  void countsWhatItCannotRead_data() {
    QTest::addColumn<std::string>("line");
    for (const char* line : {"x",
                             "p 1 2 3",
                             "p 1 2 3 4 5",
                             "p -1 2 3 4",
                             "l 5",
                             "l 5 -",
                             "l 5 - - -",
                             "l 5 1 2 3",
                             "a 1 2 q 3",
                             "a 1 2 r",
                             "a 1 2 r x",
                             "z 1 2 guessed",
                             "z 1 2",
                             "n 1",
                             "n 1 text",
                             "n 1 \"open",
                             "n 1 \"a\" b",
                             "n 1 \"a\"b",
                             "n 1 \"\\q\"",
                             "n 1 \"\\",
                             "run tool=",
                             "run tool=1",
                             "run points_per_loop=x",
                             "run tool",
                             "points count=-1",
                             "points count= 1",
                             "trace cycle_ns=x",
                             "trace-end samples=0 blocks=0",
                             "s 1 2 3",
                             "b 1",
                             "s 4 1 2 3 4 5 6 7 8",
                             "b 1 2 3 4 5 6 7",
                             "end sent=x",
                             "end outcome=failed",
                             "pp 1"}) {
      QTest::newRow(line) << std::string(line);
    }
  }

  void countsWhatItCannotRead() {
    QFETCH(std::string, line);
    const auto back = parseRecording("rivulet-recording 1\n" + line + "\nn 7 \"still here\"\n");
    QVERIFY(back);
    QCOMPARE(back->unreadableLines, std::size_t{1});
    QCOMPARE(back->notes.size(), std::size_t{1});
    QCOMPARE(recordsOf(*back), std::size_t{1});
    QVERIFY(!back->complete);
  }

  void ignoresKeysOfLaterReleases() {
    const auto back = parseRecording(
        "rivulet-recording 1\nrun future=\"a b=c\" method=\"signal\" more=3\nend sent=4 x=\"y\"\n");
    QVERIFY(back);
    QCOMPARE(back->unreadableLines, std::size_t{0});
    QCOMPARE(back->start.method, std::string("signal"));
    QCOMPARE(back->end->sent, std::size_t{4});
  }

  void saysWhenPointsAreMissing() {
    std::string text = printRecording(smallRecording());
    text.replace(text.find("p 1 0.1"), 7, "p 1 0.x");
    const auto back = parseRecording(text);
    QVERIFY(back);
    QCOMPARE(back->unreadableLines, std::size_t{1});
    QVERIFY(!back->pointsComplete);
    QVERIFY(back->complete);
  }

  void refusesOtherAndNewerFiles() {
    const auto newer = parseRecording("rivulet-recording 3\nanything\n");
    QVERIFY(!newer);
    QVERIFY(newer.error().code == TraceError::NewerVersion);
    QVERIFY(newer.error().message.find("format 3") != std::string::npos);
    for (const char* text : {"G1 X0\n", "rivulet-control-trace 1 cycle_ns=4\n", "\n",
                             "rivulet-recording\n", "rivulet-recording x\n", "riv-x"}) {
      const auto other = parseRecording(text);
      QVERIFY(!other);
      QVERIFY2(other.error().code == TraceError::NotATrace, text);
    }
  }

  void handsWholeLinesToTheSink() {
    Recording recording = smallRecording();
    recording.points.points.resize(20'000);
    std::string all;
    std::size_t largest = 0;
    RecordingWriter writer([&](std::string_view lines) {
      largest = std::max(largest, lines.size());
      all += lines;
      return !lines.empty() && lines.back() == '\n';
    });
    QVERIFY(writer.start(recording.start));
    QVERIFY(writer.points(recording.points));
    QVERIFY(writer.end(*recording.end));
    QVERIFY(writer.ok());
    QVERIFY(largest < 70'000);
    const auto back = parseRecording(all);
    QVERIFY(back);
    QVERIFY(back->complete);
    QCOMPARE(back->points.points.size(), std::size_t{20'000});
  }

  void documentedExamplesAreValid() {
    const auto document = rivulet::base::readFile(RIVULET_SOURCE_DIR "/docs/formats.md");
    QVERIFY(document);
    const auto example = [&document](const std::string& name) {
      const std::size_t begin = document->find("```\n" + name + " ") + 4;
      return document->substr(begin, document->find("```", begin) - begin);
    };
    const auto recording = parseRecording(example("rivulet-recording"));
    QVERIFY(recording);
    QVERIFY(recording->complete);
    QVERIFY(recording->pointsComplete);
    QVERIFY(recording->controlTrace && !recording->controlTrace->truncated);
    QCOMPARE(recording->unreadableLines, std::size_t{0});
    QVERIFY(parseControlTrace(example("rivulet-control-trace")));
  }

  void staysSilentAfterARefusal() {
    int calls = 0;
    RecordingWriter writer([&calls](std::string_view) { return ++calls < 2; });
    QVERIFY(writer.start({}));
    QVERIFY(!writer.note({Instant{1ms}, "lost"}));
    QVERIFY(!writer.note({Instant{2ms}, "never tried"}));
    QVERIFY(!writer.ok());
    QCOMPARE(calls, 2);
  }
};

RIVULET_TEST(TestRecording)
#include "tst_recording.moc"
