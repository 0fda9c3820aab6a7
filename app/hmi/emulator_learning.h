// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The recordings on the page Emulator, and what is learned from them. Files are read, and
/// emulators learned and tested, outside the GUI thread; whatever fails leaves what was there
/// before. @threadsafety GUI thread; the work itself runs in the pool (`session/background.h`).
#pragma once

#include <QObject>
#include <QStringList>
#include <atomic>
#include <memory>
#include <vector>

#include "base/error.h"
#include "emulator/cross_test.h"
#include "emulator/overlay.h"
#include "learning/learning.h"
#include "machine/config.h"
#include "widgets/emulator/emulator_view.h"

namespace rivulet::hmi {

class EmulatorLearning final : public QObject {
  Q_OBJECT

 public:
  EmulatorLearning();
  /// Cancels learning.
  ~EmulatorLearning() override;

  [[nodiscard]] std::vector<widgets::RecordingView> recordings() const;
  [[nodiscard]] const QString& preset() const { return m_preset; }
  [[nodiscard]] bool isLearning() const { return m_cancelled != nullptr; }

  /// Those that cannot be read are reported and left out. Of three or more, the last one is used to
  /// test, until somebody chooses.
  void add(const QStringList& paths);
  void remove(int recording);
  void setProgram(int recording, const QString& path);
  void setUse(int recording, bool isForTest);
  /// @param preset  name or file; recordings with a program are read again
  void setPreset(const QString& preset);

  /// Does nothing while a recording is being read or lacks its program.
  void learn();
  /// Learns from each recording alone, and tests on all. Of what was learned last.
  void compare();
  /// Ends `learn` and `compare`.
  void cancel();
  /// Writes what was learned last as a preset.
  void save(const QString& path);
  /// @param run  index in EmulatorView: of those learned from, then of the unseen ones
  void drawOverlay(int run, const emulator::OverlayNames& names);

 Q_SIGNALS:
  void recordingsChanged();
  void presetChanged();
  void started();
  void progressed(const rivulet::emulator::LearnProgress& progress);
  /// While recordings are compared. @param share  0 to 1
  void comparing(double share);
  void compared(const rivulet::emulator::CrossTest& test);
  /// Learning or comparing has ended; `learned`, `compared` or `failed` follows.
  void ended();
  void learned(const std::shared_ptr<const rivulet::widgets::EmulatorView>& emulator);
  void failed(const rivulet::base::Error& error);
  void saved(const QString& path);
  void overlayDrawn(const rivulet::emulator::Overlay& overlay);

 private:
  struct Entry {
    int id = 0;
    learning::RecordingFile file;
    bool isForTest = false;
    widgets::RecordingView::State state = widgets::RecordingView::State::Reading;
    std::shared_ptr<const learning::Recording> recording{};
    learning::RecordingFacts facts{};
  };

  [[nodiscard]] Entry* find(int id);
  /// @param file  what is read now; if it fails, the entry stays as it was, or goes if it is new
  void read(Entry& entry, const learning::RecordingFile& file);
  void take(int id, const learning::RecordingFile& file,
            const base::Result<learning::Recording>& result, const learning::RecordingFacts& facts);
  void proposeUses();

  std::vector<Entry> m_entries;
  QString m_preset;
  std::shared_ptr<const machine::MachineConfig> m_machine;  ///< of the preset; null: not yet read
  int m_lastId = 0;
  int m_overlayRequest = 0;
  int m_presetRequest = 0;
  bool m_usesAreChosen = false;
  std::shared_ptr<std::atomic<bool>> m_cancelled;  ///< null: nothing is being learned
  std::shared_ptr<const learning::Learned> m_learned;
};

}  // namespace rivulet::hmi
