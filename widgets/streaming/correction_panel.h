// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Online correction of a run: the overlay on the path of each axis, set by hand or by a live
/// source, and the value that the control has confirmed. If a source becomes silent, the last value
/// is held, and the panel says so.
/// @threadsafety GUI thread.
#pragma once

#include <array>
#include <optional>

#include "base/axes.h"
#include "streaming/run/run.h"
#include "widgets/common/page.h"

class QComboBox;
class QDoubleSpinBox;
class QGroupBox;
class QLabel;
class QLayout;
class QPushButton;
class QSlider;

namespace rivulet::widgets {

class StatusLabel;
class WholeNumberField;

/// Where corrections come from.
struct CorrectionInput {
  bool isLive = false;    ///< false: by hand
  int port = 47550;       ///< UDP port of this computer alone
  double silenceS = 2.0;  ///< without a datagram for this long: silent

  friend bool operator==(const CorrectionInput&, const CorrectionInput&) = default;
};

/// State of a live source.
struct LiveSourceView {
  bool isOpen = false;      ///< the port could be opened
  bool hasValue = false;    ///< a correction has been received since the run began
  bool isSilent = false;    ///< nothing for longer than `CorrectionInput::silenceS`
  std::size_t unknown = 0;  ///< lines that were not corrections
};

class CorrectionPanel final : public Page {
  Q_OBJECT

 public:
  explicit CorrectionPanel(QWidget* parent = nullptr);

  /// Shown only if there is a limit. @param limitMm  0: the program has no correction
  void setLimit(double limitMm, const std::array<bool, base::kAxisCount>& axes);
  /// A run has begun (everything begins at zero) or ended.
  void setRunning(bool running);
  /// State as reported by the stream.
  void setCorrection(const std::optional<streaming::Correction>& correction);
  void setLiveSource(const LiveSourceView& view);
  [[nodiscard]] const CorrectionInput& input() const { return m_input; }

 Q_SIGNALS:
  /// By hand, in mm.
  void correctionRequested(const rivulet::base::Vec3& valueMm);
  void inputChanged(const rivulet::widgets::CorrectionInput& input);

 protected:
  void retranslate() override;
  /// Scrolling the column with the wheel must not move the machine.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Axis {
    QLabel* name;
    QSlider* slider;
    QDoubleSpinBox* field;
    QLabel* confirmed;
  };

  [[nodiscard]] QLayout* makeAxes();
  [[nodiscard]] QLayout* makeSource();
  void takeValue(std::size_t axis, double valueMm);
  void takeInput();
  void setZero();
  void showValues();
  void showStatus();

  double m_limitMm = 0.0;
  bool m_isRunning = false;
  bool m_isShowing = false;  ///< fields are being filled, not edited
  base::Vec3 m_valueMm;      ///< by hand
  CorrectionInput m_input;
  LiveSourceView m_live;
  std::optional<streaming::Correction> m_correction;

  QGroupBox* m_group = group({.text = QT_TR_NOOP("Online correction")});
  std::array<Axis, base::kAxisCount> m_axes{};
  QPushButton* m_zero =
      button({.text = QT_TR_NOOP("Zero"),
              .tip = QT_TR_NOOP("Set the correction of all axes to zero, then continue by hand")},
             &CorrectionPanel::setZero);
  QComboBox* m_source =
      list({.tip = QT_TR_NOOP("Datagrams to 127.0.0.1 with lines like X 0.01 Y -0.02, in mm"),
            .items = {QT_TR_NOOP("By hand"), QT_TR_NOOP("UDP on this computer")}});
  Form* m_sourceForm = nullptr;
  WholeNumberField* m_port;
  QDoubleSpinBox* m_silence;
  StatusLabel* m_status = status({.wraps = true});
};

}  // namespace rivulet::widgets
