// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What tests of killed programs have in common: a machine that keeps its state over a loss of
/// power, homes for the clients, the program that is streamed, and the judge, who has nothing but
/// the list of points and the machine's own list of executed blocks. @threadsafety the test's
/// thread.
#pragma once

#include <QByteArray>
#include <QDebug>
#include <QDir>
#include <QFile>
#include <QProcessEnvironment>
#include <QString>
#include <QTemporaryDir>
#include <QThread>
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "gcode/program.h"
#include "opcua/await.h"
#include "opcua/open62541/ua_link.h"
#include "opcua/variable.h"
#include "support/machine_process.h"
#include "templates/window_protocol.h"
#include "trace/analysis/integrity.h"

namespace rivulet::tests {

class KillScene {
 public:
  /// Which of the folders of runs that are kept is looked at.
  enum class Kept { Runs, Jobs };

  /// @param machine  the executable @param preset  empty: its own
  explicit KillScene(QString machine, const QString& preset = {}, Kept kept = Kept::Runs)
      : m_machineProgram(std::move(machine)), m_kept(kept) {
    if (!preset.isEmpty()) {
      m_arguments << QStringLiteral("--preset") << preset;
    }
    QFile program(programFile());
    if (!program.open(QIODevice::WriteOnly) || program.write(rows()) <= 0) {
      qFatal("the program cannot be written");
    }
  }

  [[nodiscard]] QString path(const char* name) const {
    return m_folder.filePath(QString::fromUtf8(name));
  }
  [[nodiscard]] QString programFile() const { return path("rows.nc"); }
  [[nodiscard]] const QString& endpoint() const { return m_endpoint; }

  /// Of a client with homes of its own.
  [[nodiscard]] QProcessEnvironment environment() const {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("XDG_STATE_HOME"), path("state"));
    environment.insert(QStringLiteral("XDG_DATA_HOME"), path("data"));
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"), path("config"));
    return environment;
  }

  /// For the first time, or after a loss of power.
  void switchOn() {
    const bool hadPower = !m_endpoint.isEmpty();
    switchOff();
    m_machine = std::make_unique<MachineProcess>(
        m_machineProgram, m_arguments + QStringList{QStringLiteral("--seed"), QStringLiteral("1"),
                                                    QStringLiteral("--state"), path("machine"),
                                                    QStringLiteral("--port"), portOfThisProcess()});
    m_endpoint = m_machine->endpoint();
    if (m_endpoint.isEmpty()) {
      qFatal("rivulet-machine does not start");
    }
    if (hadPower) {
      m_switchedOnAt.push_back(executed().size());
    }
  }
  /// As if its power failed.
  void switchOff() {
    if (m_machine) {
      m_machine->kill();
    }
    m_machine.reset();
  }

  [[nodiscard]] bool isOff() const { return m_machine == nullptr; }

  /// Files of the runs that are kept, the newest first.
  [[nodiscard]] QStringList savedRuns() const {
    const QDir folder(runsFolder());
    QStringList files;
    for (const QString& name :
         folder.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Time)) {
      files << folder.filePath(name);
    }
    return files;
  }
  void forgetRuns() const { QDir(runsFolder()).removeRecursively(); }
  /// The control obeys the newest run that is kept.
  [[nodiscard]] bool isGranted() const {
    const QStringList files = savedRuns();
    QFile file(files.value(0));
    return !files.isEmpty() && file.open(QIODevice::ReadOnly) &&
           file.readAll().contains("\"granted\": true");
  }

  /// No program is active on the control.
  [[nodiscard]] bool isReset() const {
    return read({{opcua::VariableKind::ChannelStatus, 0}})[0] == opcua::kChannelReset;
  }
  /// Nothing moves: no program is active, or its client has held it on the path.
  [[nodiscard]] bool isHeldOrReset() const {
    const std::vector<double> now = read({{opcua::VariableKind::ChannelStatus, 0},
                                          opcua::rParameter(templates::WindowProtocol::Override),
                                          {opcua::VariableKind::PathFeed, 0}});
    return now[0] == opcua::kChannelReset ||
           (now[1] == templates::FeedCell::kHold && now[2] == 0.0);
  }
  /// Where the tool is, in the workpiece frame, and how fast its path goes.
  struct Look {
    base::Vec3 toolMm;
    double feedMmPerMin = 0.0;
    bool isReset = false;
  };
  [[nodiscard]] Look look() const {
    using opcua::VariableKind;
    const std::vector<double> now = read({{VariableKind::ActualPosition, 0},
                                          {VariableKind::ActualPosition, 1},
                                          {VariableKind::ActualPosition, 2},
                                          {VariableKind::PathFeed, 0},
                                          {VariableKind::ChannelStatus, 0}});
    return {{now[0], now[1], now[2]}, now[3], now[4] == opcua::kChannelReset};
  }
  /// Waits until nothing moves any more: every window has been executed, or the axes stand because
  /// their client is gone.
  void awaitStandstill() const {
    using templates::WindowProtocol;
    constexpr unsigned kPollMs = 10;
    for (;; QThread::msleep(kPollMs)) {
      const std::vector<double> now = read({{opcua::VariableKind::ChannelStatus, 0},
                                            opcua::rParameter(WindowProtocol::Delivered),
                                            opcua::rParameter(WindowProtocol::Latched),
                                            opcua::rParameter(WindowProtocol::Executed),
                                            opcua::rParameter(WindowProtocol::OverrideActs),
                                            {opcua::VariableKind::PathFeed, 0}});
      const bool isDone = now[1] == now[2] && now[2] == now[3];
      const bool isHeld = now[4] == templates::FeedCell::kHold && now[5] == 0.0;
      if (now[0] == opcua::kChannelReset || isDone || isHeld) {
        return;
      }
    }
  }

  /// Waits until the axes have stood for longer than between two windows, as during a hold.
  void awaitRest() const {
    constexpr unsigned kPollMs = 50;
    constexpr int kReads = 10;
    for (int standing = 0; standing < kReads; QThread::msleep(kPollMs)) {
      standing = read({{opcua::VariableKind::PathFeed, 0}})[0] == 0.0 ? standing + 1 : 0;
    }
  }

  /// All that the machine has executed, over all losses of power. @param skip  blocks of earlier
  /// runs
  [[nodiscard]] std::vector<trace::ExecutedBlock> executed(std::size_t skip = 0) const {
    constexpr qsizetype kColumns = 8;
    constexpr qsizetype kLength = 6;
    std::vector<trace::ExecutedBlock> blocks;
    QFile file(path("machine/executed.txt"));
    if (!file.open(QIODevice::ReadOnly)) {
      qFatal("the machine has not kept what it executed");
    }
    for (const QByteArray& line : file.readAll().split('\n')) {
      const QList<QByteArray> words = line.split(' ');
      if (words.size() != kColumns) {
        continue;
      }
      trace::ExecutedBlock block;
      block.targetMm = {words[0].toDouble(), words[1].toDouble(), words[2].toDouble()};
      block.lengthMm = words[kLength].toDouble();
      blocks.push_back(block);
    }
    const auto first = static_cast<std::ptrdiff_t>(std::min(skip, blocks.size()));
    return {blocks.begin() + first, blocks.end()};
  }

  /// Of a job whose moves go to one whole millimetre in X after the other: how many were made; -1:
  /// one was left out, made twice, or is foreign. The approach to the place where the job was left
  /// is no move. @param skip  blocks of earlier jobs
  [[nodiscard]] int movesMade(std::size_t skip) const {
    constexpr double kStandsMm = 0.01;
    int moves = 0;
    const auto all = executed();
    double xMm = skip > 0 && skip <= all.size() ? all[skip - 1].targetMm.x : 0.0;
    for (const trace::ExecutedBlock& block : executed(skip)) {
      // A program has whole millimetres only: others are where a move was interrupted, and returned
      // to.
      if (block.targetMm.x > moves && block.targetMm.x < moves + 1) {
        continue;
      }
      const bool isApproach =
          std::abs(block.targetMm.x - xMm) <= kStandsMm || (moves == 0 && block.targetMm.x == 0.0);
      xMm = block.targetMm.x;
      if (isApproach) {
        continue;
      }
      ++moves;
      if (block.targetMm.x != moves) {
        return -1;
      }
    }
    return moves;
  }

  /// Each point of the program once and in order. @param skip  blocks of earlier runs
  /// @return false, and says what was wrong
  [[nodiscard]] bool isWhole(std::size_t skip) const {
    const auto program = gcode::loadProgram(programFile().toStdString());
    const auto points = gcode::streamPoints(program->trajectory, {}).points;
    const trace::Integrity integrity =
        trace::judgeIntegrity(points, executedWithoutRests(skip), trace::kPointToleranceMm);
    if (integrity.isFaultless() && integrity.executed == points.size()) {
      return true;
    }
    qWarning("%zu of %zu executed, %zu repeated, %zu skipped, %zu foreign", integrity.executed,
             points.size(), integrity.repeated, integrity.skipped, integrity.foreign);
    for (const trace::ExecutedBlock& block : executed(skip)) {
      qWarning("to X%g Y%g Z%g over %g mm", block.targetMm.x, block.targetMm.y, block.targetMm.z,
               block.lengthMm);
    }
    return false;
  }

 private:
  /// Rows of short moves; the first block names every axis, so the start does not matter.
  [[nodiscard]] static QByteArray rows() {
    QByteArray text("G1 X1 Y1 Z20 F3000\n");
    for (int row = 0; row < 6; ++row) {
      for (int i = 0; i <= 7; ++i) {
        text += QByteArray("G1 X") + QByteArray::number(row % 2 == 0 ? 2 * i : 14 - 2 * i) + " Y" +
                QByteArray::number(3 + 3 * row) + " Z" + QByteArray::number(10 - row) + '\n';
      }
    }
    return text;
  }
  /// What was executed without the rests of blocks: a control has executed a block when its set
  /// point is at the end. If its power fails then, the axes are still behind by the following
  /// error, and the resumed run takes them over the rest.
  [[nodiscard]] std::vector<trace::ExecutedBlock> executedWithoutRests(std::size_t skip) const {
    // Of the axes of dmu75 at F1500: time constant of their servos and one cycle of 4 ms.
    constexpr double kFollowingErrorMm = 25.0 * (0.010 + 0.004);
    std::vector<trace::ExecutedBlock> blocks = executed(skip);
    for (auto at = m_switchedOnAt.rbegin(); at != m_switchedOnAt.rend(); ++at) {
      const std::size_t next = *at > skip ? *at - skip : 0;
      if (next > 0 && next < blocks.size() && blocks[next].targetMm == blocks[next - 1].targetMm &&
          blocks[next].lengthMm <= kFollowingErrorMm) {
        blocks.erase(blocks.begin() + static_cast<std::ptrdiff_t>(next));
      }
    }
    return blocks;
  }
  [[nodiscard]] QString runsFolder() const {
    return path(m_kept == Kept::Runs ? "state/rivulet/runs" : "state/rivulet/jobs");
  }

  [[nodiscard]] std::vector<double> read(const std::vector<opcua::Variable>& variables) const {
    opcua::ConnectOptions options;
    options.security = opcua::unencrypted();
    options.endpoint = m_endpoint.toStdString();
    options.connectDeadline = std::chrono::seconds(20);
    options.commandDeadline = std::chrono::seconds(20);
    const auto link = opcua::UaLink::connect(options);
    if (!link) {
      qFatal("the machine does not answer");
    }
    const auto numbers = opcua::readNumbers(**link, variables, std::chrono::seconds(5));
    if (!numbers) {
      qFatal("the machine cannot be read");
    }
    return *numbers;
  }

  QString m_machineProgram;
  QStringList m_arguments;
  Kept m_kept;
  QTemporaryDir m_folder;
  std::unique_ptr<MachineProcess> m_machine;
  QString m_endpoint;
  std::vector<std::size_t> m_switchedOnAt;  ///< blocks of all runs executed by then
};

}  // namespace rivulet::tests
