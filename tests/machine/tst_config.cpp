// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include "machine/config.h"
#include "support/test_program.h"

using namespace rivulet::machine;

class TestConfig : public QObject {
  Q_OBJECT

  static std::string preset() {
    QFile file(QStringLiteral(RIVULET_SOURCE_DIR "/resources/presets/dmu75.toml"));
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
  }

 private Q_SLOTS:
  void everyBuiltInPresetLoads() {
    QVERIFY(presetNames().size() >= 3);
    for (const std::string& name : presetNames()) {
      const auto config = loadPreset(name);
      QVERIFY2(config.has_value(), name.c_str());
      QCOMPARE(config->name, name);
    }
    QCOMPARE(loadPreset("dmu75")->interpolationCycle, rivulet::base::fromMilliseconds(4.0));
  }

  void arraysAreConfigured() {
    const ArrayAccess arrays = loadPreset("dmu75-arrays")->access.arrays;
    QVERIFY(arrays.count && arrays.range);
    QVERIFY(arrays.write == ArrayWrite::All && arrays.charge == ArrayCharge::Node);
    QVERIFY(loadPreset("dmu75")->access.arrays.charge == ArrayCharge::Element);
    QVERIFY(!loadPreset("plc")->access.arrays.count);
    std::string text = preset();
    text.replace(text.find("\"count\", "), 9, "");
    text.replace(text.find("\"all\""), 5, "\"firstOnly\"");
    const auto config = parsePreset(text, "test");
    QVERIFY2(config.has_value(), config ? "" : config.error().text().c_str());
    QVERIFY(!config->access.arrays.count && config->access.arrays.range);
    QVERIFY(config->access.arrays.write == ArrayWrite::FirstOnly);
  }

  /// Leaving out any line that holds a value is an error that names the setting.
  void everySettingIsRequired() {
    const QStringList lines = QString::fromStdString(preset()).split(QLatin1Char('\n'));
    int tried = 0;
    for (const QString& line : lines) {
      if (!line.contains(QLatin1Char('=')) || line.startsWith(QLatin1Char('#'))) {
        continue;
      }
      QString text = lines.join(QLatin1Char('\n'));
      text.remove(text.indexOf(line), line.size());
      const auto config = parsePreset(text.toStdString(), "test");
      QVERIFY2(!config, qPrintable(line));
      QVERIFY(config.error().code == MachineError::PresetMalformed);
      const QString key = line.section(QLatin1Char('='), 0, 0).trimmed();
      QVERIFY2(QString::fromStdString(config.error().message).contains(key), qPrintable(line));
      ++tried;
    }
    QVERIFY(tried >= 20);
  }

  void anEmulatorIsAPreset() {
    const std::string text =
        "[emulator]\nversion = 1\npreset = \"dmu75\"\n"
        "[axes.X]\naccelerationMmPerS2 = 600.0\n"
        "[axes.X.servo]\nposition_gain = 40.0\nfeed_forward = 0.5\ndelay = 0.002\n";
    const auto config = parsePreset(text, "mine.toml");
    QVERIFY2(config.has_value(), config ? "" : config.error().text().c_str());
    const MachineConfig named = *loadPreset("dmu75");
    QCOMPARE(config->axes[0].accelerationMmPerS2Max, 600.0);  // said here
    QCOMPARE(config->axes[1].accelerationMmPerS2Max, named.axes[1].accelerationMmPerS2Max);
    QVERIFY(config->interpolationCycle == named.interpolationCycle);
    using P = rivulet::emulator::AxisParameter;
    QCOMPARE((*config->axisLaw(0))[P::PositionGain], 40.0);
    QVERIFY(std::abs((*config->axisLaw(1))[P::PositionGain] - 100.0) < 1e-9);  // not learned
    QVERIFY(named.followingLag() == rivulet::base::fromMilliseconds(10.0));
    QVERIFY(config->followingLag() == rivulet::base::fromMilliseconds(2.0 + 12.5));
  }

  void aPresetNamesItsMachineFromItsOwnFolder() {
    QTemporaryDir folder;
    const auto write = [&](const char* name, const std::string& text) {
      QFile file(folder.filePath(QLatin1String(name)));
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write(text.c_str());
    };
    std::string other = preset();
    other.replace(other.find("accelerationMmPerS2 = 5000"), 26, "accelerationMmPerS2 = 1234");
    write("plain.toml", other);
    write(
        "mine.toml",
        "[emulator]\nversion = 1\npreset = \"plain.toml\"\n[axes.Y.servo]\nposition_gain = 7.0\n");
    write("twice.toml",
          "[emulator]\nversion = 1\npreset = \"mine.toml\"\n[axes.Y.servo]\nposition_gain = 7.0\n");
    const auto mine = loadPreset(folder.filePath(QStringLiteral("mine.toml")).toStdString());
    QVERIFY2(mine.has_value(), mine ? "" : mine.error().text().c_str());
    QCOMPARE(mine->name, std::string("mine"));
    QCOMPARE(mine->axes[0].accelerationMmPerS2Max, 1234.0);
    const auto twice = loadPreset(folder.filePath(QStringLiteral("twice.toml")).toStdString());
    QVERIFY(!twice);
    QVERIFY(twice.error().message.find("mine.toml") != std::string::npos);
  }

  void badEmulatorsAreNamed_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("named");
    const QString head = QStringLiteral("[emulator]\nversion = 1\n");
    const QString preset = QStringLiteral("preset = \"dmu75\"\n");
    const QString axis = QStringLiteral("[axes.X.servo]\nposition_gain = 40.0\n");
    QTest::newRow("no preset") << head + axis << "axes.X.positionMm";
    QTest::newRow("unknown preset")
        << head + QStringLiteral("preset = \"nowhere\"\n") + axis << "nowhere";
    QTest::newRow("missing file") << head + QStringLiteral("preset = \"no/such.toml\"\n") + axis
                                  << "";
    QTest::newRow("out of range") << head + preset +
                                         QStringLiteral("[axes.X.servo]\nposition_gain = 1e9\n")
                                  << "position_gain";
    QTest::newRow("unknown parameter")
        << head + preset + axis + QStringLiteral("gain = 1.0\n") << "gain of axis X";
    QTest::newRow("a servo without an emulator") << axis << "servo.position_gain";
    QTest::newRow("unknown setting")
        << head + preset + axis + QStringLiteral("[axes.X]\nspeed = 3\n") << "axes.X.speed";
  }
  void badEmulatorsAreNamed() {
    QFETCH(QString, text);
    QFETCH(QString, named);
    std::string whole = text.toStdString();
    if (!text.contains(QLatin1String("[emulator]"))) {
      whole = preset() + whole;
    }
    const auto config = parsePreset(whole, "mine.toml");
    QVERIFY(!config);
    const QString message = QString::fromStdString(config.error().text());
    QVERIFY2(message.contains(named), qPrintable(message));
  }

  void badValuesAreNamed_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("named");
    QTest::newRow("unknown key") << "[access]"
                                 << "[access]\nspeed = 3"
                                 << "speed";
    QTest::newRow("wrong type") << "relatchMs = 18.0"
                                << "relatchMs = \"30\""
                                << "relatchMs";
    QTest::newRow("out of range") << "bufferedBlocks = 100"
                                  << "bufferedBlocks = 0"
                                  << "bufferedBlocks";
    QTest::newRow("word") << "\"atInterpretation\""
                          << "\"sometimes\""
                          << "rRead";
    QTest::newRow("list") << "[\"count\", \"range\"]"
                          << "[\"count\", \"index\"]"
                          << "arrayForms";
    QTest::newRow("no list") << "[\"count\", \"range\"]"
                             << "\"count\""
                             << "arrayForms";
    QTest::newRow("array write") << "\"all\""
                                 << "\"some\""
                                 << "arrayWrite";
    QTest::newRow("array charge") << "\"element\""
                                  << "\"request\""
                                  << "arrayCharge";
    QTest::newRow("syntax") << "[access]"
                            << "[access"
                            << "line";
  }
  void badValuesAreNamed() {
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QString, named);
    QString text = QString::fromStdString(preset());
    QVERIFY(text.contains(from));
    text.replace(from, to);
    const auto config = parsePreset(text.toStdString(), "test");
    QVERIFY(!config);
    QVERIFY(QString::fromStdString(config.error().message).contains(named));
  }

  /// What makes the part may be left out; what is given must be right.
  void equipmentIsOptional_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("named");
    QTest::newRow("nothing") << ""
                             << "";
    QTest::newRow("spindle") << "[spindle]\nspeedPerMinMax = 9000.0\nrunUpSeconds = 1.0\n"
                             << "";
    QTest::newRow("half a spindle") << "[spindle]\nspeedPerMinMax = 9000.0\n"
                                    << "runUpSeconds";
    const QString tools = QStringLiteral(
        "[tools]\nchangeSeconds = 3.0\nmissing = \"%1\"\n"
        "table = [%2]\n");
    const QString first = QStringLiteral("{ number = 1, lengthMm = [90.0], radiusMm = [5.0] }");
    QTest::newRow("tools") << tools.arg("alarm", first) << "";
    QTest::newRow("no tools yet") << tools.arg("accepted", "") << "";
    QTest::newRow("missing") << tools.arg("ignored", first) << "missing";
    QTest::newRow("twice") << tools.arg("alarm", first + ", " + first) << "number";
    QTest::newRow("edges differ")
        << tools.arg("alarm", "{ number = 1, lengthMm = [90.0, 80.0], radiusMm = [5.0] }")
        << "radiusMm";
    QTest::newRow("unknown") << tools.arg(
                                    "alarm",
                                    "{ number = 1, lengthMm = [9.0], radiusMm = [5.0], x = 1 }")
                             << "x";
    QTest::newRow("offset") << "[workOffsetsMm]\nG57 = [1.0, 2.0, 3.0]\nG599 = [1.0, 2.0, 3.0]\n"
                            << "";
    // Ten times this number is 5000 in 32 bits.
    QTest::newRow("offset beyond all numbers")
        << "[workOffsetsMm]\n\"G-2147483148\" = [1.0, 2.0, 3.0]\n"
        << "G-2147483148";
    QTest::newRow("no such offset") << "[workOffsetsMm]\nG58 = [1.0, 2.0, 3.0]\n"
                                    << "G58";
    QTest::newRow("offset of two axes") << "[workOffsetsMm]\nG54 = [1.0, 2.0]\n"
                                        << "G54";
    QTest::newRow("fixed point") << "[fixedPointsMm]\nFP2 = [1.0, 2.0, 3.0]\n"
                                 << "";
    QTest::newRow("no such fixed point") << "[fixedPointsMm]\nFP5 = [1.0, 2.0, 3.0]\n"
                                         << "FP5";
  }
  void equipmentIsOptional() {
    QFETCH(QString, text);
    QFETCH(QString, named);
    const auto config = parsePreset(preset() + text.toStdString(), "test");
    QVERIFY2(config.has_value() == named.isEmpty(), config ? "" : config.error().message.c_str());
    QVERIFY(config || QString::fromStdString(config.error().message).contains(named));
  }

  void equipmentIsRead() {
    const MachineConfig mill = *loadPreset("dmu75-mill");
    QVERIFY(mill.spindle && mill.tools && mill.coolantTime && mill.optionalStop);
    QCOMPARE(mill.spindle->speedPerMinMax, 20000.0);
    QCOMPARE(mill.tools->find("mill_10")->number, 3);
    QCOMPARE(mill.tools->find(3)->edges.at(1).radiusMm, 4.98);
    QVERIFY(!mill.tools->find(11) && !mill.tools->find("MILL"));
    QCOMPARE(mill.workOffsetsMm.at(550).x, 100.0);
    QCOMPARE(mill.workOffsetsMm.at(5050).y, -100.0);
    QCOMPARE(mill.fixedPointsMm.at(1).z, 280.0);
    const MachineConfig plain = *loadPreset("dmu75");
    QVERIFY(!plain.spindle && !plain.tools && !plain.coolantTime && plain.workOffsetsMm.empty());
  }

  void missingPresetListsTheOthers() {
    const auto config = loadPreset("dmu76");
    QVERIFY(!config);
    QVERIFY(config.error().code == MachineError::PresetMissing);
    QVERIFY(config.error().message.find("dmu75") != std::string::npos);
    QVERIFY(!loadPreset("/nowhere/x.toml"));
  }
};

RIVULET_TEST(TestConfig)
#include "tst_config.moc"
