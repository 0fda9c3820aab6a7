// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/scope/scope_curves.h"

#include <QCoreApplication>
#include <QPointer>

#include "widgets/common/number_format.h"

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
    if (formula == "program_length_act") {
      return tr("Length along the program, actual");
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
  ++m_axisRequest;
  if (m_alignment.axis != trace::RunAxis::Time) {
    m_calculated.clear();
  }
  // A difference may be that from another first trace.
  std::erase_if(m_calculated, [this](const auto& one) {
    return one.first.isDifference ||
           std::none_of(m_traces.begin(), m_traces.end(),
                        [&one](const auto& trace) { return trace.get() == one.first.trace; });
  });
  m_alignment = {};
  m_wantedAxis = m_alignment.axis;
  m_alignment.places.resize(m_traces.size());
  m_showsDifferences = m_showsDifferences && m_traces.size() > 1;
  ++m_generation;
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
  Q_EMIT tracesChanged();
  Q_EMIT changed();
}

void ScopeCurves::setAxis(trace::RunAxis axis) {
  m_wantedAxis = axis;
  run([self = QPointer(this), request = ++m_axisRequest, traces = m_traces,
       axis]() -> std::function<void()> {
    auto alignment = trace::alignRuns(traces, axis);
    return [self, request, alignment = std::move(alignment)] {
      if (!self || self->m_axisRequest != request) {
        return;
      }
      if (alignment) {
        self->setAlignment(*alignment);
      } else {
        Q_EMIT self->axisFailed(alignment.error());
      }
    };
  });
}

void ScopeCurves::setAlignment(trace::RunAlignment alignment) {
  m_alignment = std::move(alignment);
  m_calculated.clear();
  m_awaited.clear();
  ++m_generation;
  Q_EMIT axisChanged();
  Q_EMIT changed();
}

double ScopeCurves::placeOnAxis(std::size_t trace, double atS) const {
  if (trace >= m_alignment.places.size() || m_alignment.places[trace] == nullptr) {
    return atS;
  }
  const trace::Envelope& places = *m_alignment.places[trace];
  if (places.empty()) {
    return 0.0;
  }
  const base::Instant at = instantOf(atS);
  const std::size_t last = places.size() - 1;
  return at <= places.timeAt(0)      ? places.valueAt(0)
         : at >= places.timeAt(last) ? places.valueAt(last)
                                     : trace::valueAt(places, at);
}

double ScopeCurves::axisEnd() const {
  double end = 0.0;
  for (std::size_t trace = 0; trace < m_traces.size(); ++trace) {
    end = std::max(end, placeOnAxis(trace, base::toSeconds(m_traces[trace]->length)));
  }
  return end;
}

QString ScopeCurves::axisTitle() const {
  switch (m_alignment.axis) {
    case trace::RunAxis::Time:
      return tr("Time, s");
    case trace::RunAxis::Path:
      return tr("Path, mm");
    case trace::RunAxis::Point:
      return tr("Point");
  }
  return {};
}

QString ScopeCurves::axisText(double at, int decimals) const {
  switch (m_alignment.axis) {
    case trace::RunAxis::Time:
      return secondsText(at, decimals);
    case trace::RunAxis::Path:
      return lengthText(at, decimals);
    case trace::RunAxis::Point:
      return tr("point %1").arg(numberText(at, 2));
  }
  return {};
}

void ScopeCurves::showDifferences(bool wanted) {
  if (m_showsDifferences != wanted) {
    m_showsDifferences = wanted;
    Q_EMIT changed();
  }
}

std::vector<SignalOffer> ScopeCurves::liveOffers() {
  std::vector<SignalOffer> offers;
  for (const char* name : {"x_act", "y_act", "z_act"}) {
    const std::string label(1, static_cast<char>(name[0] - 'a' + 'A'));
    offers.push_back({SignalGroup::Actual, label, name, "mm"});
  }
  offers.push_back({SignalGroup::Speed, "", "per_min(path_speed)", "mm/min"});
  return offers;
}

void ScopeCurves::startLive(std::vector<SignalOffer> offers) {
  setTraces({});
  m_isLive = true;
  m_offers = std::move(offers);
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
  return calculated(trace, formula, false);
}

std::vector<ScopeCurves::Curve> ScopeCurves::curves(const QString& formula) {
  std::vector<Curve> curves;
  if (m_isLive || m_traces.size() < 2) {
    if (m_isLive || !m_traces.empty()) {
      curves.push_back({formula, title(formula), samples(0, formula)});
    }
    return curves;
  }
  const auto nameOf = [this](std::size_t trace) {
    return QString::fromStdString(m_traces[trace]->name);
  };
  for (std::size_t trace = m_showsDifferences ? 1 : 0; trace < m_traces.size(); ++trace) {
    const QString of = m_showsDifferences ? QStringLiteral("%1 − %2").arg(nameOf(trace), nameOf(0))
                                          : nameOf(trace);
    curves.push_back({formula, title(formula) + QStringLiteral(" · ") + of,
                      calculated(trace, formula, m_showsDifferences)});
  }
  return curves;
}

ScopeCurves::Samples ScopeCurves::calculated(std::size_t trace, const QString& formula,
                                             bool isDifference) {
  if (trace >= m_traces.size()) {
    return nullptr;
  }
  const Key key{m_traces[trace].get(), formula, isDifference};
  if (const auto found = m_calculated.find(key); found != m_calculated.end()) {
    return found->second;
  }
  // A recorded signal needs no calculation.
  const trace::Channel* channel = m_traces[trace]->signalSet.find(formula.toStdString());
  if (channel != nullptr && !isDifference && m_alignment.places[trace] == nullptr) {
    return channel->samples;
  }
  if (m_awaited.insert(key).second) {
    // Where this runs, `self` is only carried.
    run([self = QPointer(this), key, generation = m_generation, of = m_traces[trace],
         places = m_alignment.places[trace], reference = isDifference ? m_traces[0] : nullptr,
         referencePlaces = m_alignment.places[0],
         text = formula.toStdString()]() -> std::function<void()> {
      auto samples = of->signalSet.calculate(text);
      if (samples) {
        samples = trace::onAxis(*samples, places.get());
      }
      if (samples && reference) {
        const auto first = reference->signalSet.calculate(text);
        samples = first ? base::Result<Samples>(trace::differenceOf(
                              *trace::onAxis(*first, referencePlaces.get()), **samples))
                        : base::Result<Samples>(base::fail(first.error()));
      }
      return [self, key, of, generation, samples = std::move(samples)] {
        if (self && self->m_generation == generation) {
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
  // That one of several traces lacks a signal of another is nothing to complain about.
  const std::string text = key.formula.toStdString();
  const bool isOffered = std::any_of(m_offers.begin(), m_offers.end(),
                                     [&](const auto& offer) { return offer.formula == text; });
  if (!samples && !isOffered) {
    Q_EMIT failed(key.formula, samples.error());
  }
  Q_EMIT changed();
}

}  // namespace rivulet::widgets
