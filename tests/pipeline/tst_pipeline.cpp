// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The six tasks make the same set points as the planner in one loop, to the bit, whoever schedules
// them and however long each step takes.

#include <QtTest>
#include <filesystem>

#include "base/file.h"
#include "base/random.h"
#include "machine/config.h"
#include "pipeline/pipeline.h"
#include "pipeline/reference.h"
#include "pipeline/virtual_run.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;

namespace {

constexpr const char* kEverything = R"nc(N10 G17 G90 G64 T1 D1 M6
N20 S3000 M3 M8
N30 G0 X10 Y10 Z5
N40 G1 Z0 F600
N50 G1 X60 F3000
N60 G2 X80 Y30 I0 J20
N70 G3 X60 Y50 Z-3 I-20 J0
N80 SOFT
N90 G1 X30 Y48
N100 X29.9 Y47.7
N110 X12 Y20
N120 G4 F0.05
N130 BRISK
N140 STOPRE
N150 FOR R1=1 TO 6
N160 G1 X=10+R1*5 Y=20+R1*R1 F=1200+R1*300
N170 G2 X=IC(2) Y=IC(0) CR=1.5
N180 ENDFOR
N190 G9 G1 X40 Y40
N200 M5 M9
N210 G1 X41 Y41 F5000
N220 M3 S500
N230 G0 X0 Y0 Z20
N240 M30
)nc";

constexpr const char* kRotary = R"nc(G90 G64
G1 X50 Y20 F2000
A10 C20
X60 Y30 A12 C40
X70 Y35 A14 C60 F4000
C90
X10 C0 A0
M30
)nc";

constexpr const char* kAlarm = R"nc(G1 X10 F1000
X20 Y5
X1e6
X30
M30
)nc";

constexpr const char* kJustEnds = "G1 X5 F600\nY3";

machine::MachineConfig preset(const QString& name) {
  auto config = machine::loadPreset(name.toStdString());
  if (!config) {
    qFatal("%s", config.error().text().c_str());
  }
  return *config;
}

struct Execution {
  std::vector<pipeline::SetPoint> points;
  pipeline::VirtualRun run;
};

base::Result<Execution> execute(const machine::MachineConfig& config, const std::string& text,
                                pipeline::PolicyKind policy, int processors, int capacity,
                                std::uint64_t seed) {
  tests::KeptPoints axes;
  pipeline::Pipeline tasks(config, axes);
  // In parts that split lines, as a network does.
  for (std::size_t at = 0; at < text.size(); at += 7) {
    tasks.receive().feed(std::string_view(text).substr(at, 7));
  }
  tasks.receive().endInput();
  base::Random random(seed);
  pipeline::VirtualOptions options;
  options.dispatch.processors = processors;
  options.dispatch.capacity = capacity;
  options.dispatch.positionCycle = 4ms;
  options.duration = [&](pipeline::Task, std::uint64_t) {
    return base::Duration{1'000 + static_cast<std::int64_t>(random.below(8'000'000))};
  };
  const auto scheduler = pipeline::factsOf(policy).make();
  auto run = pipeline::runVirtual(tasks.stages(), *scheduler, options);
  if (!run) {
    return base::fail(run.error());
  }
  return Execution{std::move(axes.points), *run};
}

}  // namespace

class TestPipeline : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void sameSetPointsAsInOneLoop_data() {
    QTest::addColumn<QString>("machine");
    QTest::addColumn<QString>("text");
    QTest::newRow("everything") << "dmu75-mill" << kEverything;
    QTest::newRow("blocks that take a cycle") << "dmu75" << kEverything;
    QTest::newRow("rotary axes") << "dmu75-5axis" << kRotary;
    QTest::newRow("alarm") << "dmu75" << kAlarm;
    QTest::newRow("no M30") << "dmu75" << kJustEnds;
    QTest::newRow("nothing") << "dmu75"
                             << "";
    const auto cam = base::readFile(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");
    QVERIFY(cam.has_value());
    QTest::newRow("CAM program") << "dmu75-mill"
                                 << QString::fromStdString(cam->substr(0, cam->find("X", 4000)));
    const std::filesystem::path corpus = RIVULET_SOURCE_DIR "/../shared/corpus/cead-nc-interpreter";
    std::error_code status;
    for (const char* name : {"arc", "for_loop", "goto", "trans", "repeat", "multiple_m_codes"}) {
      const std::filesystem::path file = corpus / (std::string(name) + ".mpf");
      if (const auto text = base::readFile(file); text && exists(file, status)) {
        QTest::newRow(name) << "dmu75-mill" << QString::fromStdString(*text + "\nM30\n");
      }
    }
  }
  void sameSetPointsAsInOneLoop() {
    QFETCH(QString, machine);
    QFETCH(QString, text);
    const machine::MachineConfig config = preset(machine);
    const tests::Planned planned = tests::planInProcess(config, text.toStdString());
    std::uint64_t seed = 1;
    for (const pipeline::PolicyFacts& policy : pipeline::policies()) {
      for (const int processors : {1, 2, 6}) {
        for (const int capacity : {1, 50}) {
          const auto done =
              execute(config, text.toStdString(), policy.kind, processors, capacity, ++seed);
          QVERIFY2(done, done ? "" : done.error().text().c_str());
          QVERIFY(done->run.hasEnded);
          const std::string difference = tests::firstDifference(planned, done->points);
          QVERIFY2(difference.empty(), difference.c_str());
        }
      }
    }
  }

  /// The comparison itself: it notices the last bit, a missing point and another function.
  void aDifferenceIsNoticed() {
    const machine::MachineConfig config = preset(QStringLiteral("dmu75-mill"));
    tests::Planned planned = tests::planInProcess(config, kEverything);
    QVERIFY(planned.cycles.size() > 1000);
    QCOMPARE(planned.actions.size(), std::size_t{11});
    const auto done = execute(config, kEverything, pipeline::PolicyKind::TaskDependency, 2, 50, 1);
    QVERIFY(tests::firstDifference(planned, done->points).empty());
    tests::Planned other = planned;
    other.cycles[700].mm.x = std::nextafter(other.cycles[700].mm.x, 1e9);
    QCOMPARE(tests::firstDifference(other, done->points), std::string("set point 701"));
    auto points = done->points;
    points.erase(points.begin() + 30);
    QVERIFY(!tests::firstDifference(planned, points).empty());
    other = planned;
    other.actions.pop_back();
    QVERIFY(!tests::firstDifference(other, done->points).empty());
  }

  /// What needs the machine around the interpreter is an alarm with a sentence.
  void aSynchronizedActionIsAnAlarm() {
    const auto done = execute(preset(QStringLiteral("dmu75")),
                              "G1 X1 F600\nID=1 WHENEVER $AA_IW[X]>5 DO $AC_OVR=50\nX9\nM30\n",
                              pipeline::PolicyKind::DataFlow, 2, 50, 1);
    QVERIFY(done.has_value());
    QVERIFY(done->points.back().head.kind == pipeline::CycleKind::Alarm);
    QVERIFY(done->points.back().head.alarm.text.view().find("synchronized") !=
            std::string_view::npos);
    QCOMPARE(done->points.back().positionMm.x - done->points.front().positionMm.x > 0.0, true);
  }

  /// A set point that is lost or comes twice stops position control.
  void positionControlTakesEachSetPointOnce() {
    for (const std::uint64_t wrong : {std::uint64_t{1}, std::uint64_t{3}}) {
      pipeline::RingMemory<pipeline::SetPoint> ring;
      auto writer = *pipeline::RingWriter<pipeline::SetPoint>::open(ring);
      tests::KeptPoints axes;
      pipeline::PositionTask task(*pipeline::RingReader<pipeline::SetPoint>::open(ring), axes);
      pipeline::SetPoint point;
      point.head.cycle = 1;
      QVERIFY(*writer.push(point));
      point.head.cycle = wrong;
      QVERIFY(*writer.push(point));
      QVERIFY(task.step().has_value());
      const auto second = task.step();
      QVERIFY(!second);
      QVERIFY(second.error().code == pipeline::PipelineError::SetPointMissing);
      QCOMPARE(axes.points.size(), std::size_t{1});
    }
  }
};

RIVULET_TEST(TestPipeline)
#include "tst_pipeline.moc"
