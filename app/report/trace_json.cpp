// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/trace_json.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace rivulet::report {

using nlohmann::ordered_json;

namespace {

/// Lists of places are cut there: the counts beside them are complete.
constexpr std::size_t kListMax = 1000;

base::Instant originOf(const trace::TraceAnalysis& analysis) {
  return analysis.motion.samples.empty() ? base::Instant{} : analysis.motion.samples.front().at;
}

ordered_json placeJson(base::Vec3 place) {
  return {place.x, place.y, place.z};
}

std::string_view pathFaultName(trace::PathFault::Kind kind) {
  using Kind = trace::PathFault::Kind;
  return kind == Kind::Repeated ? "repeated" : (kind == Kind::Skipped ? "skipped" : "foreign");
}

ordered_json pathFaultJson(const trace::PathFault& fault, base::Instant origin) {
  return {{"kind", pathFaultName(fault.kind)},
          {"point", fault.point.value},
          {"line", fault.line.value},
          {"at_s", base::toSeconds(fault.at - origin)},
          {"place_mm", placeJson(fault.placeMm)}};
}

ordered_json standstillsJson(const std::vector<trace::Standstill>& stops, base::Instant origin) {
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < std::min(stops.size(), kListMax); ++i) {
    const trace::Standstill& stop = stops[i];
    list.push_back({{"start_s", base::toSeconds(stop.start - origin)},
                    {"duration_ms", base::toMilliseconds(stop.duration)},
                    {"uncertainty_ms", base::toMilliseconds(stop.uncertainty)},
                    {"place_mm", placeJson(stop.placeMm)},
                    {"line", stop.line},
                    {"cause", trace::stopCauseName(stop.cause)},
                    {"evidence", stop.evidence}});
  }
  return list;
}

ordered_json pathJson(const trace::PathMatch& path, base::Instant origin) {
  ordered_json faults = ordered_json::array();
  for (const trace::PathFault& fault : path.faults) {
    faults.push_back(pathFaultJson(fault, origin));
  }
  return {{"points", path.points},
          {"executed", path.executed},
          {"undecided", path.undecided},
          {"repeated", path.repeated},
          {"skipped", path.skipped},
          {"foreign", path.foreign},
          {"on_path_share", path.onPathShare},
          {"faults", std::move(faults)},
          {"departure",
           path.departure ? pathFaultJson(*path.departure, origin) : ordered_json(nullptr)}};
}

ordered_json contourJson(const trace::ContourError& error, base::Instant origin) {
  return {{"max_mm", error.maxMm},
          {"rms_mm", error.rmsMm},
          {"p95_mm", error.p95Mm},
          {"left_mm", error.leftMm},
          {"right_mm", error.rightMm},
          {"at_s", base::toSeconds(error.at - origin)},
          {"place_mm", placeJson(error.placeMm)},
          {"line", error.line.value}};
}

ordered_json followingJson(const trace::MotionQuality& quality) {
  ordered_json axes;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const trace::FollowingError& error = quality.following[axis];
    axes[std::string(1, static_cast<char>('x' + axis))] = {
        {"max_mm", error.maxMm},
        {"rms_mm", error.rmsMm},
        {"reversal_mm",
         error.reversalMm ? ordered_json(*error.reversalMm) : ordered_json(nullptr)}};
  }
  return axes;
}

ordered_json cornersJson(const std::vector<trace::CornerRounding>& corners) {
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < std::min(corners.size(), kListMax); ++i) {
    const trace::CornerRounding& corner = corners[i];
    list.push_back({{"line", corner.line.value},
                    {"turn_deg", corner.turnDeg},
                    {"set_mm", corner.setMm},
                    {"actual_mm", corner.actualMm},
                    {"speed_min_mm_per_s", corner.mmPerSMin}});
  }
  return list;
}

ordered_json feedJson(const trace::FeedKept& feed) {
  ordered_json standing;
  for (const trace::TimeLost& lost : feed.standing) {
    standing[std::string(trace::stopCauseName(lost.cause))] = {{"stops", lost.stops},
                                                               {"seconds", lost.seconds}};
  }
  return {{"kept_share", feed.known ? ordered_json(feed.share) : ordered_json(nullptr)},
          {"motion_s", feed.motionS},
          {"programmed_s", feed.known ? ordered_json(feed.programmedS) : ordered_json(nullptr)},
          {"slow_s", feed.known ? ordered_json(feed.slowS) : ordered_json(nullptr)},
          {"standing", std::move(standing)}};
}

ordered_json vibrationJson(const trace::Vibration& vibration) {
  ordered_json jerk;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    jerk[std::string(1, static_cast<char>('x' + axis))] = vibration.jerkRmsMmPerS3[axis];
  }
  ordered_json peaks = ordered_json::array();
  for (const trace::SpectrumPeak& peak : vibration.peaks) {
    peaks.push_back({{"axis", std::string(1, static_cast<char>('x' + peak.axis))},
                     {"hz", peak.hz},
                     {"amplitude_mm_per_s2", peak.amplitudeMmPerS2}});
  }
  return {{"jerk_rms_mm_per_s3", std::move(jerk)}, {"peaks", std::move(peaks)}};
}

std::string contourText(std::string_view what, const trace::ContourError& error) {
  return fmt::format(
      "  contour error of the {}: max {:.4f} mm in line {}, RMS {:.4f} mm, "
      "95 % {:.4f} mm, left {:.4f}, right {:.4f}\n",
      what, error.maxMm, error.line.value, error.rmsMm, error.p95Mm, error.leftMm, error.rightMm);
}

}  // namespace

void addTraceAnalysis(ordered_json& json, const trace::TraceAnalysis& analysis) {
  const base::Instant origin = originOf(analysis);
  const trace::MotionQuality& quality = analysis.quality;
  json["samples"] = analysis.motion.samples.size();
  json["step_ms"] = base::toMilliseconds(analysis.motion.step);
  json["standstill_count"] = analysis.stops.size();
  json["standstills"] = standstillsJson(analysis.stops, origin);
  json["path"] = analysis.path.judged ? pathJson(analysis.path, origin) : ordered_json(nullptr);
  // The larger of the two is what counts for a rule; the parts say where it comes from.
  const trace::ContourError& worst =
      quality.actualContour.count > 0 ? quality.actualContour : quality.setContour;
  if (worst.count > 0) {
    ordered_json contour = contourJson(worst, origin);
    contour["set"] = quality.setContour.count > 0 ? contourJson(quality.setContour, origin)
                                                  : ordered_json(nullptr);
    json["contour_error"] = std::move(contour);
    json["corners"] = cornersJson(quality.corners);
  }
  if (quality.hasFollowing) {
    json["following_error"] = followingJson(quality);
  }
  json["feed"] = feedJson(quality.feed);
  if (quality.vibration.known) {
    json["vibration"] = vibrationJson(quality.vibration);
  }
}

std::string traceAnalysisText(const trace::TraceAnalysis& analysis) {
  const trace::MotionQuality& quality = analysis.quality;
  std::string text;
  if (analysis.path.judged) {
    const trace::PathMatch& path = analysis.path;
    text += fmt::format(
        "  path: {} of {} points passed, undecided {}, repeated {}, skipped {}, foreign {}; {:.1f} "
        "% "
        "of the motion is on the path\n",
        path.executed, path.points, path.undecided, path.repeated, path.skipped, path.foreign,
        100.0 * path.onPathShare);
    if (path.departure) {
      text += fmt::format(
          "  the motion leaves the program for good before line {}, at X{:.3f} Y{:.3f} Z{:.3f}, "
          "{:.3f} s\n",
          path.departure->line.value, path.departure->placeMm.x, path.departure->placeMm.y,
          path.departure->placeMm.z, base::toSeconds(path.departure->at - originOf(analysis)));
    }
  }
  for (const trace::TimeLost& lost : quality.feed.standing) {
    text += fmt::format("  {} stops, {}: {:.3f} s\n", lost.stops, trace::stopCauseName(lost.cause),
                        lost.seconds);
  }
  if (quality.setContour.count > 0) {
    text += contourText("set point", quality.setContour);
  }
  if (quality.actualContour.count > 0) {
    text += contourText("actual position", quality.actualContour);
  }
  for (std::size_t axis = 0; quality.hasFollowing && axis < base::kAxisCount; ++axis) {
    const trace::FollowingError& error = quality.following[axis];
    text += fmt::format(
        "  following error {}: max {:.4f} mm, RMS {:.4f} mm{}\n", base::kAxisNames[axis],
        error.maxMm, error.rmsMm,
        error.reversalMm ? fmt::format(", reversal {:.4f} mm", *error.reversalMm) : std::string());
  }
  if (quality.feed.known) {
    text += fmt::format(
        "  feed kept on {:.1f} % of the path; {:.3f} s instead of {:.3f} s, of which {:.3f} s "
        "moving "
        "slower\n",
        100.0 * quality.feed.share, quality.feed.motionS, quality.feed.programmedS,
        quality.feed.slowS);
  }
  for (const trace::SpectrumPeak& peak : quality.vibration.peaks) {
    text += fmt::format("  vibration {}: {:.1f} Hz, {:.1f} mm/s²\n", base::kAxisNames[peak.axis],
                        peak.hz, peak.amplitudeMmPerS2);
  }
  return text;
}

}  // namespace rivulet::report
