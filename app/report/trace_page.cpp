// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/trace_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/nice_step.h"
#include "base/units.h"
#include "report/markup.h"

namespace rivulet::report {

namespace {

/// Points of one line in a picture.
constexpr std::size_t kPicturePointsMax = 4000;
constexpr double kPictureWidth = 700.0;
constexpr double kPictureHeight = 240.0;
/// Stops that are listed; the rest is counted.
constexpr std::size_t kStopsListed = 12;

/// A range of values onto a range of the picture.
struct PictureScale {
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();

  void take(double value) {
    min = std::min(min, value);
    max = std::max(max, value);
  }
  [[nodiscard]] double span() const { return max > min ? max - min : 1.0; }
};

std::string polyline(const std::vector<std::pair<double, double>>& points, const char* colour,
                     double width) {
  std::string out = fmt::format(
      "<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" points=\"", colour, width);
  for (const auto& [x, y] : points) {
    out += fmt::format("{:.1f},{:.1f} ", x, y);
  }
  return out + "\"/>\n";
}

/// The path seen from above: programmed, and as it was.
std::string pathPicture(const trace::TraceAnalysis& analysis) {
  const trace::Motion& motion = analysis.motion;
  PictureScale x;
  PictureScale y;
  for (const trace::MotionSample& sample : motion.samples) {
    const base::Vec3 at = motion.placeMm(sample);
    x.take(at.x);
    y.take(at.y);
  }
  const double scale =
      std::min((kPictureWidth - 20.0) / x.span(), (kPictureHeight - 20.0) / y.span());
  const auto place = [&](base::Vec3 at) {
    return std::pair(10.0 + scale * (at.x - x.min), kPictureHeight - 10.0 - scale * (at.y - y.min));
  };
  std::vector<std::pair<double, double>> programmed;
  if (analysis.programPath) {
    const auto& points = analysis.programPath->points();
    const std::size_t stride = 1 + points.size() / kPicturePointsMax;
    for (std::size_t i = 0; i < points.size(); i += stride) {
      programmed.push_back(place(points[i].positionMm));
    }
  }
  std::vector<std::pair<double, double>> moved;
  const std::size_t stride = 1 + motion.samples.size() / kPicturePointsMax;
  for (std::size_t i = 0; i < motion.samples.size(); i += stride) {
    moved.push_back(place(motion.hasActual ? motion.samples[i].actualMm : motion.samples[i].setMm));
  }
  std::string out = polyline(programmed, "#b0b8c0", 3.0) + polyline(moved, "#0b6e99", 1.0);
  for (const trace::PathFault& fault : analysis.path.faults) {
    const auto [faultX, faultY] = place(fault.placeMm);
    out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"#c0392b\"/>\n", faultX,
                       faultY);
  }
  return out;
}

/// Path speed over time: the largest and smallest of each column, and the stops.
std::string speedPicture(const trace::TraceAnalysis& analysis) {
  const std::vector<trace::MotionSample>& samples = analysis.motion.samples;
  const double seconds = std::max(1e-9, base::toSeconds(samples.back().at - samples.front().at));
  double fastest = 1e-9;
  for (const trace::MotionSample& sample : samples) {
    fastest = std::max(fastest, sample.pathMmPerS);
  }
  const auto xAt = [&](base::Instant at) {
    return 40.0 + (kPictureWidth - 50.0) * base::toSeconds(at - samples.front().at) / seconds;
  };
  const auto yAt = [&](double speed) {
    return kPictureHeight - 25.0 - (kPictureHeight - 40.0) * speed / fastest;
  };
  std::string out;
  for (const trace::Standstill& stop : analysis.stops) {
    out += fmt::format(
        "<rect x=\"{:.1f}\" y=\"10\" width=\"{:.1f}\" height=\"{:.1f}\" "
        "fill=\"#e67e22\" fill-opacity=\"0.35\"/>\n",
        xAt(stop.start), std::max(0.6, xAt(stop.start + stop.duration) - xAt(stop.start)),
        kPictureHeight - 35.0);
  }
  std::vector<std::pair<double, double>> line;
  const std::size_t stride = 1 + samples.size() / (kPicturePointsMax / 2);
  for (std::size_t begin = 0; begin < samples.size(); begin += stride) {
    const auto end =
        samples.begin() + static_cast<std::ptrdiff_t>(std::min(samples.size(), begin + stride));
    const auto [low, high] =
        std::minmax_element(samples.begin() + static_cast<std::ptrdiff_t>(begin), end,
                            [](const trace::MotionSample& a, const trace::MotionSample& b) {
                              return a.pathMmPerS < b.pathMmPerS;
                            });
    line.emplace_back(xAt(low->at), yAt(low->pathMmPerS));
    line.emplace_back(xAt(high->at), yAt(high->pathMmPerS));
  }
  out += polyline(line, "#0b6e99", 0.8);
  const double step = base::niceStepAbove(seconds / 8.0);
  for (double at = 0.0; at <= seconds; at += step) {
    const double x = 40.0 + (kPictureWidth - 50.0) * at / seconds;
    out += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{:g} s</text>\n", x,
                       kPictureHeight - 8.0, at);
  }
  return out +
         fmt::format("<text x=\"4\" y=\"20\">{:.0f}</text><text x=\"4\" y=\"34\">mm/min</text>\n",
                     base::mmPerMinFromMmPerS(fastest));
}

std::string picture(std::string_view caption, const std::string& content) {
  return fmt::format(
      "<figure><svg viewBox=\"0 0 {} {}\">{}</svg><figcaption>{}</figcaption></figure>\n",
      kPictureWidth, kPictureHeight, content, caption);
}

std::string stopsTable(const trace::TraceAnalysis& analysis) {
  std::vector<trace::Standstill> stops = analysis.stops;
  std::stable_sort(stops.begin(), stops.end(),
                   [](const trace::Standstill& a, const trace::Standstill& b) {
                     return a.duration > b.duration;
                   });
  if (stops.empty()) {
    return "<p>The axes never stopped between the first and the last motion.</p>\n";
  }
  std::string out = fmt::format(
      "<h2>The longest of {} stops</h2>\n<table><tr><th>at</th><th>duration"
      "</th><th>place</th><th>line</th><th>cause</th></tr>\n",
      stops.size());
  for (std::size_t i = 0; i < std::min(stops.size(), kStopsListed); ++i) {
    const trace::Standstill& stop = stops[i];
    out += fmt::format(
        "<tr><td>{:.3f} s</td><td>{:.0f} ms</td><td>X{:.3f} Y{:.3f} Z{:.3f}</td>"
        "<td>{}</td><td>{}{}</td></tr>\n",
        base::toSeconds(stop.start - analysis.motion.samples.front().at),
        base::toMilliseconds(stop.duration), stop.placeMm.x, stop.placeMm.y, stop.placeMm.z,
        stop.line, trace::stopCauseName(stop.cause),
        stop.evidence.empty() ? "" : ": " + markupText(stop.evidence));
  }
  return out + "</table>\n";
}

constexpr std::string_view kStyle =
    "@page{size:A4;margin:12mm}body{font:13px/1.35 sans-serif;color:#1c2430;max-width:720px;"
    "margin:16px auto;padding:0 8px}h1{font-size:20px;margin:0 0 4px}h2{font-size:14px;margin:10px "
    "0 4px}table{border-collapse:collapse;width:100%}td,th{text-align:left;padding:1px 10px 1px 0;"
    "vertical-align:top}figure{margin:6px 0}svg{width:100%;border:1px solid #d5dbe1;font:11px "
    "sans-serif}figcaption{color:#5a6572}.result{font-weight:bold;padding:6px 10px;margin:6px 0}"
    ".good{background:#e3f4e6}.bad{background:#fbe3e0}.facts{columns:2}.facts div{break-inside:"
    "avoid}.facts b{font-weight:normal;color:#5a6572}.sign{margin-top:18px;border-top:1px solid "
    "#1c2430;width:45%;color:#5a6572}";

}  // namespace

std::string tracePageHtml(const TracePage& page, const trace::TraceAnalysis& analysis) {
  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta "
      "charset=\"utf-8\"><title>{0}</title><style>{1}"
      "</style></head><body>\n<h1>{0}</h1>\n<div class=\"result {2}\">{3}</div>\n",
      markupText(page.title), kStyle, page.isWrong ? "bad" : "good", markupText(page.result));
  out += "<div class=\"facts\">\n";
  for (const auto& [name, value] : page.facts) {
    out += fmt::format("<div><b>{}</b> {}</div>\n", markupText(name), markupText(value));
  }
  out += "</div>\n";
  if (!page.limitedBy.empty()) {
    out += fmt::format("<p>What limited the run: {}</p>\n", markupText(page.limitedBy));
  }
  if (!analysis.motion.samples.empty()) {
    out += picture("XY: programmed (grey), actual (blue), faults (red)", pathPicture(analysis));
    out += picture("Path speed over time, stops in orange", speedPicture(analysis));
    out += stopsTable(analysis);
  }
  return out + "<div class=\"sign\">Date, signature</div>\n</body></html>\n";
}

}  // namespace rivulet::report
