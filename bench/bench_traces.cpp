// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How fast long traces are drawn: five signals of so many samples in the panes of the window, and
// as line series of Qt Charts. The same views one after another: first all, then zooms and moves.
// Then what following a run takes that sends twenty signals. Times are those of the processor.

#include <fmt/format.h>

#include <QApplication>
#include <QChart>
#include <QChartView>
#include <QLineSeries>
#include <QPixmap>
#include <QValueAxis>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "base/median.h"
#include "measuring.h"
#include "widgets/plots/time_window.h"
#include "widgets/scope/scope_pane.h"
#include "widgets/scope/scope_view.h"

namespace {

using namespace rivulet;

constexpr int kSignals = 5;
constexpr double kStepS = 0.001;
constexpr int kWidth = 1600;
constexpr int kHeight = 900;
constexpr double kChartsBudgetS = 60.0;
constexpr int kLiveSignals = 20;
constexpr int kLiveS = 120;
constexpr int kLiveFramesPerS = 1000 / widgets::ScopePane::kFollowMs;

template <class Work>
double millisecondsOf(const Work& work) {
  const double before = 1e3 * bench::processorS();
  work();
  return 1e3 * bench::processorS() - before;
}

/// A contour with the resolution of a control: 0.1 µm, up to 60 mm/s, and some noise.
double valueOf(int signal, int sample) {
  const double at = sample * kStepS;
  const double mm = 80.0 * std::sin(at * (0.31 + 0.07 * signal)) + 6.0 * std::sin(at * 5.3) +
                    0.002 * std::sin(at * 1571.0 + signal);
  return std::round(mm * 1e4) / 1e4;
}

struct View {
  double fromS;
  double toS;
};

/// All; into the middle, down to a tenth of a second; along at three zooms.
std::vector<View> viewsOf(double lengthS) {
  std::vector<View> views{{0.0, lengthS}};
  double span = lengthS;
  while (span > 0.1) {
    span *= 0.8;
    views.push_back({0.4 * lengthS - 0.4 * span, 0.4 * lengthS + 0.6 * span});
  }
  for (const double wide : {0.5, 0.05, 0.001}) {
    for (int i = 0; i < 30; ++i) {
      const double from = i / 60.0 * lengthS;
      views.push_back({from, from + wide * lengthS});
    }
  }
  return views;
}

void print(const char* name, double madeMs, std::vector<double> frames, double mb) {
  const double first = frames.front();
  frames.erase(frames.begin());
  std::sort(frames.begin(), frames.end());
  if (frames.empty()) {
    fmt::print("{:12} {:9.0f} {:11.0f} {:>9} {:>9} {:>9} {:9.0f}\n", name, madeMs, first, "-", "-",
               "0", mb);
    return;
  }
  fmt::print("{:12} {:9.0f} {:11.1f} {:9.1f} {:9.1f} {:9} {:9.0f}\n", name, madeMs, first,
             base::median(frames), frames.back(), frames.size(), mb);
}

void measurePanes(int samples, const std::vector<View>& views) {
  const double before = bench::residentMb();
  trace::ShownTrace shown;
  const double madeMs = millisecondsOf([&] {
    for (int signal = 0; signal < kSignals; ++signal) {
      auto envelope = std::make_shared<trace::Envelope>();
      for (int i = 0; i < samples; ++i) {
        envelope->append(base::Instant{std::chrono::milliseconds{i}}, valueOf(signal, i));
      }
      shown.signalSet.add({fmt::format("s{}", signal), "mm", std::move(envelope)});
    }
  });
  const double packedMb = static_cast<double>(shown.signalSet.memoryBytes()) / 1e6;
  widgets::ScopeCurves curves;
  widgets::TimeWindow window;
  widgets::ScopeCursors cursors;
  const std::vector<widgets::StopRow> stops;
  widgets::ScopeView view(&curves, &window, &cursors, &stops);
  view.resize(kWidth, kHeight);
  curves.setTraces({std::make_shared<const trace::ShownTrace>(std::move(shown))});
  window.setLength(samples * kStepS);
  std::vector<QStringList> panes;
  for (int signal = 0; signal < kSignals; ++signal) {
    panes.push_back({QStringLiteral("s%1").arg(signal)});
  }
  std::vector<double> frames;
  for (const View& one : views) {
    frames.push_back(millisecondsOf([&] {
      if (view.panes().empty()) {
        view.setArrangement(panes);
      }
      window.showRange(one.fromS, one.toS);
      view.redrawNow();
      static_cast<void>(view.grab());
    }));
  }
  print("panes", madeMs, frames, bench::residentMb() - before);
  fmt::print("             signals packed in {:.0f} MB, {:.2f} bytes per sample\n", packedMb,
             packedMb * 1e6 / kSignals / samples);
}

/// A run as it is followed: the samples since the last picture, then a picture of what is seen.
void measureLive() {
  std::vector<trace::SignalOffer> offers;
  std::vector<QStringList> panes(kSignals);
  for (int signal = 0; signal < kLiveSignals; ++signal) {
    const std::string name = fmt::format("s{}", signal);
    offers.push_back({trace::SignalGroup::Actual, name, name, "mm"});
    panes[static_cast<std::size_t>(signal % kSignals)].append(QString::fromStdString(name));
  }
  widgets::ScopeCurves curves;
  widgets::TimeWindow window;
  widgets::ScopeCursors cursors;
  const std::vector<widgets::StopRow> stops;
  widgets::ScopeView view(&curves, &window, &cursors, &stops);
  view.resize(kWidth, kHeight);
  curves.startLive(std::move(offers));
  view.setArrangement(panes);
  constexpr int kSamples = static_cast<int>(1.0 / kStepS) / kLiveFramesPerS;
  const double spentMs = millisecondsOf([&] {
    for (int frame = 0; frame < kLiveS * kLiveFramesPerS; ++frame) {
      for (int i = 0; i < kSamples; ++i) {
        const int sample = frame * kSamples + i;
        for (int signal = 0; signal < kLiveSignals; ++signal) {
          curves.appendLive(QStringLiteral("s%1").arg(signal), sample * kStepS,
                            valueOf(signal, sample));
        }
        window.setEnd(sample * kStepS);
      }
      view.redrawNow();
      static_cast<void>(view.grab());
    }
  });
  fmt::print("live: {} signals of 1 kHz in {} panes, {} pictures per second: {:.1f} % of a core\n",
             kLiveSignals, kSignals, kLiveFramesPerS, 100.0 * spentMs / (1e3 * kLiveS));
}

void measureCharts(int samples, const std::vector<View>& views) {
  const double before = bench::residentMb();
  QChart chart;
  auto* timeAxis = new QValueAxis(&chart);
  auto* valueAxis = new QValueAxis(&chart);
  chart.addAxis(timeAxis, Qt::AlignBottom);
  chart.addAxis(valueAxis, Qt::AlignLeft);
  valueAxis->setRange(-90.0, 90.0);
  timeAxis->setRange(0.0, samples * kStepS);
  const double madeMs = millisecondsOf([&] {
    for (int signal = 0; signal < kSignals; ++signal) {
      QList<QPointF> points;
      points.reserve(samples);
      for (int i = 0; i < samples; ++i) {
        points.append({i * kStepS, valueOf(signal, i)});
      }
      auto* series = new QLineSeries(&chart);
      series->replace(points);
      chart.addSeries(series);
      series->attachAxis(timeAxis);
      series->attachAxis(valueAxis);
    }
  });
  QChartView chartView;
  chartView.setChart(&chart);
  chartView.resize(kWidth, kHeight);
  std::vector<double> frames;
  double spentMs = 0.0;
  for (const View& one : views) {
    if (spentMs > 1e3 * kChartsBudgetS) {
      break;
    }
    frames.push_back(millisecondsOf([&] {
      timeAxis->setRange(one.fromS, one.toS);
      static_cast<void>(chartView.grab());
    }));
    spentMs += frames.back();
  }
  print("Qt Charts", madeMs, frames, bench::residentMb() - before);
  chartView.setChart(new QChart);  // the view would delete ours
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication application(argc, argv);
  const int samples = argc > 1 ? std::stoi(argv[1]) : 10'000'000;
  const std::vector<View> views = viewsOf(samples * kStepS);
  fmt::print("{} signals of {} samples, {} x {} px, {} views\n", kSignals, samples, kWidth, kHeight,
             views.size());
  fmt::print("{:12} {:>9} {:>11} {:>9} {:>9} {:>9} {:>9}\n", "", "made, ms", "first, ms", "median",
             "slowest", "frames", "MB");
  measurePanes(samples, views);
  measureLive();
  measureCharts(samples, views);
}
