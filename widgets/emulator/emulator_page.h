// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// From recordings of a machine to an emulator of it: choose recordings, learn, look at what was
/// learned and how far it is off, save it as a preset of the virtual machine. A line says what to
/// do next, and what went wrong. @threadsafety GUI thread.
#pragma once

#include <QStringList>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "emulator/cross_test.h"
#include "emulator/identification.h"
#include "widgets/common/page.h"
#include "widgets/common/table_model.h"
#include "widgets/emulator/emulator_view.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableView;

namespace rivulet::widgets {

class BoxPlot;
class CurveChart;
class FoldingTabs;
class HeatMap;
class OverlayPanel;
class ResponsePanel;
class StatusLabel;

class EmulatorPage final : public Page {
  Q_OBJECT

 public:
  explicit EmulatorPage(QWidget* parent = nullptr);
  ~EmulatorPage() override;

  /// @param reason  why nothing can be learned now; empty: it can
  void setBlocked(const QString& reason);
  void setRecordings(std::vector<RecordingView> recordings);
  /// Presets of the virtual machine, and the one that is chosen: a name or a file.
  void setPresets(const QStringList& names, const QString& chosen);
  /// Learning has begun: the curve of the error starts anew.
  void startLearning();
  void addProgress(const emulator::LearnProgress& progress);
  /// Recordings are being compared. @param share  0 to 1
  void showComparing(double share);
  /// Learning or comparing has ended, in whatever way.
  void endLearning();
  /// @param emulator  null: nothing is learned
  void setEmulator(std::shared_ptr<const EmulatorView> emulator);
  void setCrossTest(emulator::CrossTest test);
  /// One sentence; what is shown stays. The operator's next action takes it away.
  void showProblem(const QString& sentence);
  void showSaved(const QString& path);
  [[nodiscard]] OverlayPanel* overlay() const { return m_overlay; }

 Q_SIGNALS:
  void addRequested(const QStringList& paths);
  void removeRequested(int recording);
  /// @param path  empty: without a program
  void programChosen(int recording, const QString& path);
  void useChosen(int recording, bool isForTest);
  void presetChosen(const QString& preset);
  void learnRequested();
  void cancelRequested();
  void compareRequested();
  void saveRequested(const QString& path);

 protected:
  void retranslate() override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  /// A row of the table of parameters.
  struct ParameterRow {
    char axis = 'X';
    emulator::ParameterEstimate estimate;
  };
  /// A row of the table of tests.
  struct TestRow {
    emulator::RunFit fit;
    bool isUnseen = false;
  };

  QWidget* makeRecordings();
  QWidget* makeParameters();
  QWidget* makeTests();
  QWidget* makeMatrix();
  void connectParts();
  void chooseRecordings();
  void chooseProgram();
  void choosePreset(int index);
  void chooseFileToSave();
  [[nodiscard]] int chosenRecording() const;
  void showChoice();
  void showCurve();
  void showResult();
  void showMatrix();
  /// What stands in the way of learning; empty: nothing.
  [[nodiscard]] QString obstacle() const;
  void refresh();
  /// What was said last is over when the operator does something else.
  void forgetNews();

  QString m_blocked;
  QString m_problem;
  QString m_saved;
  std::vector<RecordingView> m_recordings;
  QStringList m_presets;
  QString m_preset;
  std::optional<emulator::LearnProgress> m_progress;  ///< the last one
  bool m_isLearning = false;
  bool m_isComparing = false;
  double m_shareShown = 0.0;
  std::map<char, std::vector<emulator::LearnProgress>> m_steps;
  std::shared_ptr<const EmulatorView> m_emulator;
  emulator::CrossTest m_crossTest;

  StatusLabel* m_note = status({.id = "emulatorNote", .wraps = true});
  QPushButton* m_add = button({.text = QT_TR_NOOP("Add…"),
                               .tip = QT_TR_NOOP("Add recordings of the machine"),
                               .id = "emulatorAdd"},
                              &EmulatorPage::chooseRecordings);
  QPushButton* m_learn =
      button({.text = QT_TR_NOOP("Learn"),
              .tip = QT_TR_NOOP("Learn from the recordings how the axes follow their set points"),
              .id = "emulatorLearn"},
             &EmulatorPage::learnRequested);
  QPushButton* m_cancel = button({.text = QT_TR_NOOP("Cancel"),
                                  .tip = QT_TR_NOOP("Stop learning; what was learned before stays"),
                                  .id = "emulatorCancel"},
                                 &EmulatorPage::cancelRequested);
  QPushButton* m_save =
      button({.text = QT_TR_NOOP("Save…"),
              .tip = QT_TR_NOOP("Save the emulator as a preset of the virtual machine"),
              .id = "emulatorSave"},
             &EmulatorPage::chooseFileToSave);
  QProgressBar* m_bar;
  FoldingTabs* m_tabs;

  struct RecordingsTab {
    QTableView* table = nullptr;
    TableModel<RecordingView>* model = nullptr;
    QPushButton* program = nullptr;
    QPushButton* use = nullptr;
    QPushButton* remove = nullptr;
    QComboBox* presets = nullptr;
    CurveChart* curve = nullptr;
  };
  RecordingsTab m_recordingsTab;

  struct ParametersTab {
    StatusLabel* remark = nullptr;
    QTableView* table = nullptr;
    TableModel<ParameterRow>* model = nullptr;
    QPushButton* more = nullptr;
    ResponsePanel* response = nullptr;
  };
  ParametersTab m_parameters;

  struct TestsTab {
    QLabel* stretches = nullptr;
    QTableView* table = nullptr;
    TableModel<TestRow>* model = nullptr;
  };
  TestsTab m_tests;

  struct MatrixTab {
    QPushButton* compare = nullptr;
    QLabel* text = nullptr;
    HeatMap* matrix = nullptr;
    QLabel* worthText = nullptr;
    BoxPlot* worth = nullptr;
  };
  MatrixTab m_comparison;

  OverlayPanel* m_overlay;
};

}  // namespace rivulet::widgets
