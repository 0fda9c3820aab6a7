// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The traces that the panes show, and the curves that have been calculated from them. What takes
/// long is given away as work; a pane shows a curve when it is there.
/// @threadsafety GUI thread; only `Work` itself may run elsewhere.
#pragma once

#include <QObject>
#include <QString>
#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "trace/comparison.h"
#include "trace/signal_set.h"

namespace rivulet::widgets {

/// Calculates without touching any widget, and returns what is to be done on the GUI thread.
using Work = std::function<std::function<void()>()>;
/// Has work done, somewhere, and its result handed over on the GUI thread.
using WorkRunner = std::function<void(Work)>;

class ScopeCurves final : public QObject {
  Q_OBJECT

 public:
  using Samples = std::shared_ptr<const trace::Envelope>;
  using Traces = std::vector<std::shared_ptr<const trace::ShownTrace>>;

  explicit ScopeCurves(QObject* parent = nullptr);

  /// Without one, work is done at once.
  void setRunner(WorkRunner runner) { m_runner = std::move(runner); }
  void run(Work work) const;

  /// Replaces what was shown, also what was seen live. Curves of traces that stay are kept.
  void setTraces(Traces traces);
  [[nodiscard]] const Traces& traces() const { return m_traces; }
  [[nodiscard]] bool isLive() const { return m_isLive; }
  /// What is offered by any of the traces, once each.
  [[nodiscard]] std::vector<trace::SignalOffer> offers() const;
  /// That of the offers with this formula, or the formula itself, and its unit.
  [[nodiscard]] QString title(const QString& formula) const;
  [[nodiscard]] QString unit(const QString& formula) const;

  /// What is seen of every run while it lasts.
  [[nodiscard]] static std::vector<trace::SignalOffer> liveOffers();
  /// Begins a run: an empty trace to which values are appended. @param offers  its signals
  void startLive(std::vector<trace::SignalOffer> offers = liveOffers());
  /// A value that is older than the last one is shown at the time of that.
  void appendLive(const QString& formula, double atS, double value);

  /// What all traces share along the axis of the panes. On another one than time, what is called
  /// time elsewhere is a place: mm, or points of the program. `axisChanged` or `axisFailed` reports
  /// it. New traces begin with time.
  void setAxis(trace::RunAxis axis);
  [[nodiscard]] trace::RunAxis axis() const { return m_alignment.axis; }
  /// That of the last `setAxis`, also if it failed or is being made.
  [[nodiscard]] trace::RunAxis wantedAxis() const { return m_wantedAxis; }
  [[nodiscard]] const trace::RunAlignment& alignment() const { return m_alignment; }
  /// Where a trace is on the axis at a time from its first sample, and where the axis ends.
  [[nodiscard]] double placeOnAxis(std::size_t trace, double atS) const;
  [[nodiscard]] double axisEnd() const;
  /// "Time, s", and "1.234 s".
  [[nodiscard]] QString axisTitle() const;
  [[nodiscard]] QString axisText(double at, int decimals = 3) const;

  /// Curves of all traces but the first show what they have more than that.
  void showDifferences(bool wanted);
  [[nodiscard]] bool showsDifferences() const { return m_showsDifferences; }

  /// Null: the trace has no such signal, or it is being calculated; `changed` reports it.
  [[nodiscard]] Samples samples(std::size_t trace, const QString& formula);

  struct Curve {
    QString formula;
    QString title;  ///< with the name of the trace, if there are several
    Samples samples;
  };
  /// What panes and tables show of a signal: one curve per trace, or the differences.
  [[nodiscard]] std::vector<Curve> curves(const QString& formula);

 Q_SIGNALS:
  /// Traces or curves are there that were not.
  void changed();
  /// Other traces.
  void tracesChanged();
  void axisChanged();
  void axisFailed(const rivulet::base::Error& error);
  /// A formula is not possible.
  void failed(const QString& formula, const rivulet::base::Error& error);

 private:
  /// A signal of a trace, or what it has more than the first trace.
  struct Key {
    const trace::ShownTrace* trace = nullptr;
    QString formula;
    bool isDifference = false;

    friend bool operator<(const Key& a, const Key& b) {
      return std::tie(a.trace, a.formula, a.isDifference) <
             std::tie(b.trace, b.formula, b.isDifference);
    }
  };

  void setAlignment(trace::RunAlignment alignment);
  [[nodiscard]] Samples calculated(std::size_t trace, const QString& formula, bool isDifference);
  void take(const Key& key, const base::Result<Samples>& samples);

  WorkRunner m_runner;
  Traces m_traces;
  bool m_isLive = false;
  std::map<QString, std::shared_ptr<trace::Envelope>> m_live;
  trace::RunAlignment m_alignment;
  trace::RunAxis m_wantedAxis = trace::RunAxis::Time;
  bool m_showsDifferences = false;
  int m_axisRequest = 0;
  int m_generation = 0;                 ///< of the axis that curves are calculated for
  std::map<Key, Samples> m_calculated;  ///< null: not possible
  std::set<Key> m_awaited;
  std::vector<trace::SignalOffer> m_offers;
};

/// "X actual", "X lag", "Path speed" in the language of the operator.
[[nodiscard]] QString signalTitle(const trace::SignalOffer& offer);
[[nodiscard]] QString signalGroupTitle(trace::SignalGroup group);

/// Seconds as an instant, and back.
[[nodiscard]] inline base::Instant instantOf(double seconds) {
  return base::Instant{base::fromSeconds(std::clamp(seconds, -1e9, 1e9))};
}

}  // namespace rivulet::widgets
