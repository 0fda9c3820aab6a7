// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// RND, RNDM, CHF and CHR: where the rounded or chamfered contour goes.

#include <QtTest>
#include <cmath>

#include "base/text.h"
#include "machine/machine.h"
#include "support/test_program.h"

using namespace rivulet;
using machine::ChannelStatus;
using machine::Machine;

namespace {

/// End points, "~" before that of an arc; or the alarm.
std::string run(const std::string& text) {
  machine::MachineConfig config = *machine::loadPreset("dmu75-mill");
  config.axes[2].startMm = 0.0;
  Machine machine(std::move(config), 1);
  const bool ready = machine.storeProgram("T.MPF", "G1 F2000 G17\n" + text + "\nM30\n", true) &&
                     machine.selectProgram("T.MPF") && machine.cycleStart();
  if (!ready) {
    qFatal("the program could not be started");
  }
  for (int i = 0; i < 100000 && machine.state().channel == ChannelStatus::Active; ++i) {
    machine.advance(machine.now() + base::fromMilliseconds(4.0));
  }
  if (machine.state().alarm != 0) {
    return "alarm " + std::to_string(machine.state().alarm);
  }
  std::string path;
  base::Vec3 from;
  for (const trace::ExecutedBlock& block : machine.trace().blocks) {
    if (!block.moves()) {
      continue;
    }
    const bool isArc = block.lengthMm > base::distance(from, block.targetMm) + 1e-6;
    path += (path.empty() ? "" : " ") + std::string(isArc ? "~" : "");
    for (std::size_t axis = 0; axis < 2; ++axis) {
      path += (axis == 0 ? "" : ",") +
              base::formatNumber(std::round(block.targetMm[axis] * 1e4) / 1e4 + 0.0);
    }
    from = block.targetMm;
  }
  return path;
}

}  // namespace

class TestContourCorners : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void corners_data() {
    QTest::addColumn<std::string>("program");
    QTest::addColumn<std::string>("path");
    const auto row = [](const char* name, const char* program, const char* path) {
      QTest::newRow(name) << std::string(program) << std::string(path);
    };
    row("rounded", "X30 RND=5\nY20", "25,0 ~30,5 30,20");
    row("the other way", "X30 RND=5\nY-20", "25,0 ~30,-5 30,-20");
    row("chamfered by its length", "X30 CHF=5\nY20", "26.4645,0 30,3.5355 30,20");
    row("chamfered by what it takes", "X30 CHR=5\nY20", "25,0 30,5 30,20");
    row("obtuse", "X30 RND=5\nX40 Y10", "27.9289,0 ~31.4645,1.4645 40,10");
    row("at each corner", "RNDM=2\nX30\nY20\nX0 RNDM=0\nY0", "28,0 ~30,2 30,18 ~28,20 0,20 0,0");
    row("a value that is calculated", "R1=2\nX30 RND=R1+3\nY20", "25,0 ~30,5 30,20");
    row("too large for its sides", "X30 RND=100\nY20", "10,0 ~30,20");
    row("at an arc", "X30 RND=5\nG2 X50 Y20 CR=20", "25.5051,0 ~30.4041,4 ~50,20");
    row("straight on", "X30 RND=5\nX40", "30,0 40,0");
    row("the path goes on before it turns", "X30 RND=5\nM8\nY20", "25,0 ~30,5 30,20");
    row("nothing follows", "X30 RND=5", "30,0");
    row("chamfer at an arc", "X30 CHR=5\nG2 X40 Y10 CR=10", "alarm 12550");
    row("inch", "G70\nX1 RND=0.1\nY1", "22.86,0 ~25.4,2.54 25.4,25.4");
  }
  void corners() {
    QFETCH(std::string, program);
    QFETCH(std::string, path);
    QCOMPARE(run(program), path);
  }
};

RIVULET_TEST(TestContourCorners)
#include "tst_contour_corners.moc"
