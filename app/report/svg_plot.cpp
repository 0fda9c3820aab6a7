// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/svg_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <vector>

#include "base/nice_step.h"
#include "report/markup.h"

namespace rivulet::report {

using base::Plot;
using base::Series;
using base::SeriesStyle;

namespace {

constexpr double kWidth = 720.0;
constexpr double kLeft = 76.0;
constexpr double kRight = 20.0;
constexpr double kTop = 40.0;
constexpr double kPlotHeight = 330.0;
constexpr double kBottom = 56.0;
constexpr double kLegendLine = 20.0;
constexpr double kPlotWidth = kWidth - kLeft - kRight;

/// Okabe and Ito's colours, which colour-blind readers can tell apart; the paper's own is black.
constexpr std::array<std::string_view, 6> kColours{"#0072B2", "#D55E00", "#009E73",
                                                   "#CC79A7", "#E69F00", "#56B4E9"};
constexpr std::array<std::string_view, 4> kDashes{"", "7 3", "2 3", "9 3 2 3"};

/// One axis: from data to the picture, with ticks at round values.
class Scale {
 public:
  Scale(double min, double max, int ticks) {
    if (!(min < max)) {
      const double room = min == 0.0 ? 1.0 : 0.1 * std::abs(min);
      min -= room;
      max += room;
    }
    m_step = base::niceStepAbove((max - min) / ticks);
    m_min = m_step * std::floor(min / m_step + 1e-9);
    m_max = m_step * std::ceil(max / m_step - 1e-9);
    m_decimals = base::decimalsOfStep(m_step);
  }

  [[nodiscard]] double share(double value) const { return (value - m_min) / (m_max - m_min); }
  [[nodiscard]] std::vector<double> ticks() const {
    std::vector<double> values;
    const auto count = static_cast<int>(std::lround((m_max - m_min) / m_step));
    for (int i = 0; i <= count; ++i) {
      values.push_back(m_min + i * m_step);
    }
    return values;
  }
  [[nodiscard]] std::string label(double value, char decimalSign) const {
    // A zero without a sign.
    std::string text =
        fmt::format("{:.{}f}", std::abs(value) < 1e-9 * m_step ? 0.0 : value, m_decimals);
    std::replace(text.begin(), text.end(), '.', decimalSign);
    return text;
  }

 private:
  double m_min = 0.0;
  double m_max = 1.0;
  double m_step = 1.0;
  int m_decimals = 0;
};

class Picture {
 public:
  Picture(const Plot& plot, const PlotLook& look)
      : m_plot(plot), m_look(look), m_x(scaleOf(true)), m_y(scaleOf(false)) {}

  std::string draw() {
    const double height =
        kTop + kPlotHeight + kBottom + kLegendLine * static_cast<double>(m_plot.series.size());
    line(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0:g} {1:g}" width="{0:g}" height="{1:g}" font-family="DejaVu Sans, Arial, sans-serif" font-size="13" fill="#222222">)",
        kWidth, height);
    line(R"(<title>{}</title>)", markupText(m_plot.title));
    line(R"(<rect width="{:g}" height="{:g}" fill="#ffffff"/>)", kWidth, height);
    line(R"(<text x="{:g}" y="24" font-size="15" font-weight="bold">{}</text>)", kLeft,
         markupText(m_plot.title));
    axes();
    // Bands are below everything else, the paper's own marks on top.
    const auto drawAll = [this](auto chosen) {
      for (std::size_t i = 0; i < m_plot.series.size(); ++i) {
        if (chosen(m_plot.series[i])) {
          series(i);
        }
      }
    };
    const auto isBand = [](const Series& one) { return one.style == SeriesStyle::Band; };
    drawAll(isBand);
    drawAll([&](const Series& one) { return !isBand(one) && !one.fromPaper; });
    drawAll([&](const Series& one) { return !isBand(one) && one.fromPaper; });
    legend();
    line("</svg>");
    return std::move(m_text);
  }

 private:
  template <class... Arguments>
  void line(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(m_text), text, std::forward<Arguments>(arguments)...);
    m_text += '\n';
  }

  [[nodiscard]] Scale scaleOf(bool horizontal) const {
    double min = 1e300;
    double max = -1e300;
    for (const Series& series : m_plot.series) {
      const auto take = [&](const std::vector<double>& values) {
        for (const double value : values) {
          if (std::isfinite(value)) {
            min = std::min(min, value);
            max = std::max(max, value);
          }
        }
      };
      take(horizontal ? series.x : series.y);
      if (!horizontal) {
        take(series.yUpper);
      }
    }
    if (min > max) {
      min = 0.0;
      max = 1.0;
    }
    if (!horizontal && max - min < m_look.ySpanMin) {
      const double room = (m_look.ySpanMin - (max - min)) / 2.0;
      min -= room;
      max += room;
    }
    // An axis that nearly reaches zero shows it.
    if (min > 0.0 && min < 0.4 * max) {
      min = 0.0;
    }
    return {min, max, horizontal ? 8 : 6};
  }

  [[nodiscard]] double xOf(double value) const { return kLeft + kPlotWidth * m_x.share(value); }
  [[nodiscard]] double yOf(double value) const {
    return kTop + kPlotHeight * (1.0 - m_y.share(value));
  }

  void axes() {
    for (const double tick : m_x.ticks()) {
      line(R"(<path d="M{0:.2f} {1:g}V{2:g}" stroke="#e3e3e3"/>)", xOf(tick), kTop,
           kTop + kPlotHeight);
      line(R"(<text x="{:.2f}" y="{:g}" text-anchor="middle">{}</text>)", xOf(tick),
           kTop + kPlotHeight + 19.0, m_x.label(tick, m_look.decimalSign));
    }
    for (const double tick : m_y.ticks()) {
      line(R"(<path d="M{0:g} {1:.2f}H{2:g}" stroke="#e3e3e3"/>)", kLeft, yOf(tick),
           kLeft + kPlotWidth);
      line(R"(<text x="{:g}" y="{:.2f}" text-anchor="end">{}</text>)", kLeft - 8.0, yOf(tick) + 4.5,
           m_y.label(tick, m_look.decimalSign));
    }
    line(R"(<path d="M{0:g} {1:g}V{2:g}H{3:g}" fill="none" stroke="#222222"/>)", kLeft, kTop,
         kTop + kPlotHeight, kLeft + kPlotWidth);
    line(R"(<text x="{:g}" y="{:g}" text-anchor="middle">{}</text>)", kLeft + 0.5 * kPlotWidth,
         kTop + kPlotHeight + 42.0, markupText(m_plot.xLabel));
    line(R"x(<text transform="translate(18 {:g}) rotate(-90)" text-anchor="middle">{}</text>)x",
         kTop + 0.5 * kPlotHeight, markupText(m_plot.yLabel));
  }

  [[nodiscard]] std::string_view colour(std::size_t index) const {
    return m_plot.series[index].fromPaper ? std::string_view("#000000")
                                          : kColours[colourNumber(index) % kColours.size()];
  }
  [[nodiscard]] std::size_t colourNumber(std::size_t index) const {
    return index < m_look.colours.size() ? m_look.colours[index] : index;
  }

  void marker(std::size_t index, double x, double y) {
    if (m_plot.series[index].fromPaper) {
      line(
          R"(<path d="M{0:.2f} {2:.2f}L{1:.2f} {3:.2f}M{0:.2f} {3:.2f}L{1:.2f} {2:.2f}" stroke="#000000" stroke-width="2.2"/>)",
          x - 5.0, x + 5.0, y - 5.0, y + 5.0);
      return;
    }
    switch (index % 3) {
      case 0:
        line(R"(<circle cx="{:.2f}" cy="{:.2f}" r="4" fill="{}"/>)", x, y, colour(index));
        break;
      case 1:
        line(R"(<rect x="{:.2f}" y="{:.2f}" width="7" height="7" fill="{}"/>)", x - 3.5, y - 3.5,
             colour(index));
        break;
      default:
        line(R"(<path d="M{0:.2f} {1:.2f}l4.8 8h-9.6z" fill="{2}"/>)", x, y - 5.0, colour(index));
    }
  }

  void series(std::size_t index) {
    const Series& series = m_plot.series[index];
    std::string path;
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (series.style == SeriesStyle::Points) {
        marker(index, xOf(series.x[i]), yOf(series.y[i]));
      } else if (series.style == SeriesStyle::Steps && i > 0) {
        path += fmt::format("H{:.2f}V{:.2f}", xOf(series.x[i]), yOf(series.y[i]));
      } else {
        path +=
            fmt::format("{}{:.2f} {:.2f}", i == 0 ? "M" : "L", xOf(series.x[i]), yOf(series.y[i]));
      }
    }
    if (series.style == SeriesStyle::Band) {
      for (std::size_t i = series.x.size(); i-- > 0;) {
        path += fmt::format("L{:.2f} {:.2f}", xOf(series.x[i]), yOf(series.yUpper[i]));
      }
      line(R"(<path d="{}Z" fill="{}" fill-opacity="0.18" stroke="{}" stroke-opacity="0.6"/>)",
           path, colour(index), colour(index));
    } else if (!path.empty()) {
      line(R"(<path d="{}" fill="none" stroke="{}" stroke-width="1.8" stroke-dasharray="{}"/>)",
           path, colour(index), dash(index));
    }
  }

  [[nodiscard]] static std::string_view dash(std::size_t index) {
    return kDashes[index % kDashes.size()].empty() ? std::string_view("none")
                                                   : kDashes[index % kDashes.size()];
  }

  void legend() {
    for (std::size_t i = 0; i < m_plot.series.size(); ++i) {
      const double y = kTop + kPlotHeight + kBottom + kLegendLine * static_cast<double>(i);
      switch (m_plot.series[i].style) {
        case SeriesStyle::Band:
          line(
              R"(<rect x="{:g}" y="{:g}" width="24" height="11" fill="{}" fill-opacity="0.25" stroke="{}"/>)",
              kLeft, y - 5.5, colour(i), colour(i));
          break;
        case SeriesStyle::Points:
          marker(i, kLeft + 12.0, y);
          break;
        default:
          line(R"(<path d="M{:g} {:g}h24" stroke="{}" stroke-width="1.8" stroke-dasharray="{}"/>)",
               kLeft, y, colour(i), dash(i));
      }
      line(R"(<text x="{:g}" y="{:g}">{}</text>)", kLeft + 32.0, y + 4.5,
           markupText(m_plot.series[i].name));
    }
  }

  const Plot& m_plot;
  const PlotLook& m_look;
  Scale m_x;
  Scale m_y;
  std::string m_text;
};

}  // namespace

std::string svgPlot(const Plot& plot, const PlotLook& look) {
  return Picture(plot, look).draw();
}

}  // namespace rivulet::report
