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
#include <utility>
#include <vector>

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

  /// Begins a run: an empty trace to which values are appended.
  void startLive();
  /// A value that is older than the last one is shown at the time of that.
  void appendLive(const QString& formula, double atS, double value);

  /// Null: the trace has no such signal, or it is being calculated; `changed` reports it.
  [[nodiscard]] Samples samples(std::size_t trace, const QString& formula);

 Q_SIGNALS:
  /// Traces or curves are there that were not.
  void changed();
  /// A formula is not possible.
  void failed(const QString& formula, const rivulet::base::Error& error);

 private:
  using Key = std::pair<const trace::ShownTrace*, QString>;

  void take(const Key& key, const base::Result<Samples>& samples);

  WorkRunner m_runner;
  Traces m_traces;
  bool m_isLive = false;
  std::map<QString, std::shared_ptr<trace::Envelope>> m_live;
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
