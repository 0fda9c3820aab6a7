// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/scope/scope_curves.h"

#include <QCoreApplication>
#include <QPointer>

namespace rivulet::widgets {

using trace::SignalGroup;
using trace::SignalOffer;

namespace {

struct SignalTexts {
  Q_DECLARE_TR_FUNCTIONS(SignalTexts)

 public:
  static QString group(SignalGroup group) {
    switch (group) {
      case SignalGroup::SetPoint:
        return tr("Set point");
      case SignalGroup::Actual:
        return tr("Actual position");
      case SignalGroup::Lag:
        return tr("Lag (set point minus actual)");
      case SignalGroup::Speed:
        return tr("Speed");
      case SignalGroup::Acceleration:
        return tr("Acceleration");
      case SignalGroup::Jerk:
        return tr("Jerk");
      case SignalGroup::ContourError:
        return tr("Contour error");
      case SignalGroup::Program:
        return tr("Program");
      case SignalGroup::Client:
        return tr("Requests to the control");
      case SignalGroup::Column:
        return tr("Columns of the file");
    }
    return {};
  }

  static QString ofAxis(SignalGroup group) {
    switch (group) {
      case SignalGroup::SetPoint:
        return tr("%1 set point", "of an axis");
      case SignalGroup::Actual:
        return tr("%1 actual", "of an axis");
      case SignalGroup::Lag:
        return tr("%1 lag", "of an axis");
      case SignalGroup::Speed:
        return tr("%1 speed", "of an axis");
      case SignalGroup::Acceleration:
        return tr("%1 acceleration", "of an axis");
      case SignalGroup::Jerk:
        return tr("%1 jerk", "of an axis");
      default:
        return {};
    }
  }

  static QString single(const std::string& formula) {
    if (formula == "per_min(path_speed)") {
      return tr("Path speed");
    }
    if (formula == "d(path_speed)") {
      return tr("Path acceleration");
    }
    if (formula == "contour_error") {
      return tr("Contour error, actual");
    }
    if (formula == "contour_error_set") {
      return tr("Contour error, set point");
    }
    if (formula == "line") {
      return tr("Line on the control");
    }
    if (formula == "program_line") {
      return tr("Line of the program");
    }
    if (formula == "program_point") {
      return tr("Point of the program");
    }
    if (formula == "program_length") {
      return tr("Length along the program");
    }
    if (formula == trace::kTimeSignal) {
      return tr("Time since the first sample");
    }
    if (formula == "per_min(programmed_feed)") {
      return tr("Programmed feed");
    }
    if (formula == "override") {
      return tr("Override");
    }
    if (formula == "write_ms") {
      return tr("Duration of writes");
    }
    return formula == "read_ms" ? tr("Duration of reads") : QString();
  }
};

}  // namespace

QString signalGroupTitle(SignalGroup group) {
  return SignalTexts::group(group);
}

QString signalTitle(const SignalOffer& offer) {
  const QString label = QString::fromStdString(offer.label);
  if (offer.group == SignalGroup::Column) {
    return label;
  }
  const QString single = SignalTexts::single(offer.formula);
  return single.isEmpty() ? SignalTexts::ofAxis(offer.group).arg(label) : single;
}

ScopeCurves::ScopeCurves(QObject* parent) : QObject(parent) {
}

void ScopeCurves::run(Work work) const {
  if (m_runner) {
    m_runner(std::move(work));
  } else {
    work()();
  }
}

void ScopeCurves::setTraces(Traces traces) {
  m_isLive = false;
  m_live.clear();
  m_traces = std::move(traces);
  std::erase_if(m_calculated, [this](const auto& one) {
    return std::none_of(m_traces.begin(), m_traces.end(),
                        [&one](const auto& trace) { return trace.get() == one.first.first; });
  });
  m_awaited.clear();
  m_offers.clear();
  for (const auto& trace : m_traces) {
    for (SignalOffer& offer : trace->signalSet.offers()) {
      const bool isKnown =
          std::any_of(m_offers.begin(), m_offers.end(),
                      [&offer](const SignalOffer& one) { return one.formula == offer.formula; });
      if (!isKnown) {
        m_offers.push_back(std::move(offer));
      }
    }
  }
  std::stable_sort(m_offers.begin(), m_offers.end(),
                   [](const SignalOffer& a, const SignalOffer& b) { return a.group < b.group; });
  Q_EMIT changed();
}

void ScopeCurves::startLive() {
  setTraces({});
  m_isLive = true;
  for (const char* name : {"x_act", "y_act", "z_act"}) {
    const std::string label(1, static_cast<char>(name[0] - 'a' + 'A'));
    m_offers.push_back({SignalGroup::Actual, label, name, "mm"});
  }
  m_offers.push_back({SignalGroup::Speed, "", "per_min(path_speed)", "mm/min"});
  for (const SignalOffer& offer : m_offers) {
    m_live[QString::fromStdString(offer.formula)] = std::make_shared<trace::Envelope>();
  }
  Q_EMIT changed();
}

void ScopeCurves::appendLive(const QString& formula, double atS, double value) {
  const auto found = m_live.find(formula);
  if (found == m_live.end()) {
    return;
  }
  trace::Envelope& samples = *found->second;
  base::Instant at = instantOf(atS);
  if (!samples.empty()) {
    at = std::max(at, samples.timeAt(samples.size() - 1));
  }
  samples.append(at, value);
}

std::vector<SignalOffer> ScopeCurves::offers() const {
  return m_offers;
}

QString ScopeCurves::title(const QString& formula) const {
  const std::string text = formula.toStdString();
  for (const SignalOffer& offer : m_offers) {
    if (offer.formula == text) {
      return signalTitle(offer);
    }
  }
  return formula;
}

QString ScopeCurves::unit(const QString& formula) const {
  const std::string text = formula.toStdString();
  for (const SignalOffer& offer : m_offers) {
    if (offer.formula == text) {
      return QString::fromStdString(offer.unit);
    }
  }
  return {};
}

ScopeCurves::Samples ScopeCurves::samples(std::size_t trace, const QString& formula) {
  if (m_isLive) {
    const auto found = m_live.find(formula);
    return found == m_live.end() ? nullptr : found->second;
  }
  if (trace >= m_traces.size()) {
    return nullptr;
  }
  const Key key{m_traces[trace].get(), formula};
  if (const auto found = m_calculated.find(key); found != m_calculated.end()) {
    return found->second;
  }
  // A recorded signal needs no calculation.
  if (const trace::Channel* channel = m_traces[trace]->signalSet.find(formula.toStdString())) {
    return channel->samples;
  }
  if (m_awaited.insert(key).second) {
    run([self = QPointer(this), key, of = m_traces[trace], formula]() -> std::function<void()> {
      // Where this runs, `self` is only carried.
      auto samples = of->signalSet.calculate(formula.toStdString());
      return [self, key, of, samples = std::move(samples)] {
        if (self) {
          self->take(key, samples);
        }
      };
    });
    if (const auto found = m_calculated.find(key); found != m_calculated.end()) {
      return found->second;
    }
  }
  return nullptr;
}

void ScopeCurves::take(const Key& key, const base::Result<Samples>& samples) {
  const bool isWanted = m_awaited.erase(key) > 0;
  if (!isWanted) {
    return;  // its trace is no longer shown
  }
  m_calculated[key] = samples ? *samples : nullptr;
  if (!samples) {
    Q_EMIT failed(key.second, samples.error());
  }
  Q_EMIT changed();
}

}  // namespace rivulet::widgets
