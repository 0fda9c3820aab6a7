// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace_report/trace_sheet.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>
#include <algorithm>
#include <optional>
#include <vector>

#include "base/method_kind.h"
#include "base/quantile.h"
#include "base/units.h"
#include "trace/analysis/statistics.h"
#include "widgets/common/number_format.h"
#include "widgets/common/trace_text.h"
#include "widgets/runs/run_texts.h"

namespace rivulet::trace_report {

namespace {

using namespace widgets;
using paper::Fact;
using paper::Group;

const QColor kProgrammed(0xa8, 0xb0, 0xb8);
const QColor kMeasured(0x0b, 0x6e, 0x99);
const QColor kLongest(0xd0, 0x8a, 0x3e);
const QColor kFault(0xc0, 0x39, 0x2b);
const QColor kStop(0xf6, 0xc8, 0x9a);
/// Points of one line in a picture.
constexpr std::size_t kPicturePoints = 3000;
constexpr std::size_t kAccessPeriods = 300;
/// Losses that would be shown as zero are not listed.
constexpr double kSecondsMin = 0.05;
/// Stops that are listed; the table says how many there are.
constexpr std::size_t kStopsListed = 12;

QString known(const std::string& text) {
  return text.empty() ? noValue() : QString::fromStdString(text);
}

QString percentText(double share) {
  constexpr double kPercent = 100.0;
  return numberText(kPercent * share, 1) + QStringLiteral("\u00A0%");
}

struct TraceTexts {
  Q_DECLARE_TR_FUNCTIONS(TraceTexts)

 public:
  static QString title(bool isRun) {
    return isRun ? tr("Report of a run") : tr("Report on a motion");
  }
  static QString judgement(streaming::RunFinding finding) {
    switch (finding) {
      case streaming::RunFinding::Faultless:
        return tr("Every point executed once, in order");
      case streaming::RunFinding::Faulty:
        return tr("The motion is not that of the program");
      case streaming::RunFinding::NotJudged:
        break;
    }
    return tr("Not judged");
  }
  static QString notJudged() {
    return tr(
        "Whether each point was executed is not known: the program or a part of the trace is "
        "missing.");
  }
  static QString cut() {
    return tr("The recording was cut off before the end of the run. What it holds is judged here.");
  }
  static QString departure(const trace::PathFault& fault) {
    return tr("The motion leaves the program for good before line %1, at X %2 Y %3 Z %4.")
        .arg(QString::number(fault.line.value), numberText(fault.placeMm.x, 3),
             numberText(fault.placeMm.y, 3), numberText(fault.placeMm.z, 3));
  }
  static QString run() { return tr("Run"); }
  static QString trace() { return tr("Trace"); }
  static QString settings() { return tr("Settings"); }
  static QString result() { return tr("Result"); }
  static QString motion() { return tr("Motion"); }
  static QString timeLost() { return tr("Time"); }
  static QString stream() { return tr("Client and control"); }
  static QString signature() { return tr("Date, name, signature"); }
  static QString fileLine(const TraceFacts& facts) {
    return tr("File %1, SHA-256 %2")
        .arg(QString::fromStdString(facts.file), QString::fromStdString(facts.fileHash));
  }
  static QString versionLine(const TraceFacts& facts) {
    const QString now = QString::fromStdString(facts.appVersion);
    return facts.recording == nullptr || facts.recording->start.toolVersion.empty()
               ? tr("Rivulet %1").arg(now)
               : tr("Rivulet %1; run made with version %2")
                     .arg(now, QString::fromStdString(facts.recording->start.toolVersion));
  }
  static QString path() { return tr("Program grey, motion blue"); }
  static QString noMotion() { return tr("The trace holds no motion."); }
  static QString speed() { return tr("Path speed; stops are orange"); }
  static QString speedBelow(double mmPerMin) {
    return tr("Path speed up to %1 mm/min; stops are orange").arg(numberText(mmPerMin, 0));
  }
  static QString access() { return tr("Duration of requests: median blue, longest orange"); }
  static QString seconds() { return tr("Time, s"); }
  static QString milliseconds() { return tr("ms"); }
  static QString mmPerMin() { return tr("mm/min"); }
  static QString longestStops(std::size_t count) {
    return tr("The longest of %1 stops").arg(countText(count));
  }
  static QStringList stopHeadings() {
    return {tr("At"), tr("Duration"), tr("Place, mm"), tr("Line"), tr("Cause")};
  }

  static QString limit(const report::StreamQuality& quality) {
    switch (quality.limit) {
      case report::StreamLimit::Client:
        return tr("What limited the run: the client. The machine waited %1 times for its data, %2 "
                  "in all.")
            .arg(countText(quality.lateWindows), secondsText(quality.waitedS, 2));
      case report::StreamLimit::AccessTime:
        return tr("What limited the run: the access time. At %1 the client is slower than the "
                  "machine; up to %2 it keeps up.")
            .arg(feedText(quality.feedMmPerS), feedText(quality.feedMmPerSMax.value_or(0.0)));
      case report::StreamLimit::Stops:
        return tr("What limited the run: the stops between loops or windows, %1 in all.")
            .arg(secondsText(quality.standingS, 2));
      case report::StreamLimit::Machine:
        break;
    }
    return tr("What limited the run: the machine, by braking and accelerating, not the client.");
  }
  static QString advice(const report::StreamAdvice& advice) {
    const QString feed = feedText(advice.feedMmPerSMax);
    switch (advice.change) {
      case report::StreamAdvice::Change::PointsPerLoop:
        return tr("With N = %1, feeds up to %2 would have been possible.")
            .arg(QString::number(advice.pointsPerLoop), feed);
      case report::StreamAdvice::Change::Arrays:
        return tr("With arrays that cost as much as one variable, feeds up to %1 would have been "
                  "possible.")
            .arg(feed);
      case report::StreamAdvice::Change::Feed:
        break;
    }
    return tr("Without another change, %1 is the largest feed at which the machine does not wait.")
        .arg(feed);
  }

  static Group runGroup(const TraceFacts& facts) {
    if (facts.recording == nullptr) {
      const trace::Motion& motion = facts.analysis->motion;
      return {
          trace(),
          {{tr("Program"), facts.programFile.empty()
                               ? noValue()
                               : QFileInfo(QString::fromStdString(facts.programFile)).fileName()},
           {tr("File"), QFileInfo(QString::fromStdString(facts.file)).fileName()},
           {tr("Kind of file"), known(facts.format)},
           {tr("Samples"), countText(motion.samples.size())},
           {tr("Time between two samples"), millisecondsText(motion.step, 2)},
           {tr("Duration"), motionDuration(facts)}}};
    }
    const trace::RunStart& start = facts.recording->start;
    streaming::RunSummary run;
    run.endpoint = start.endpoint;
    run.origin.startedAtUtc = start.startedAtUtc;
    run.origin.user = start.user;
    run.origin.computer = start.computer;
    return {
        TraceTexts::run(),
        {{tr("Program"), known(start.programName)},
         {tr("Version (hash)"), known(start.programHash)},
         {tr("Machine"), machineText(run)},
         {tr("Start"), startText(run)},
         {tr("Started by"), originText(run.origin)},
         {tr("Run number"), start.runNumber == 0 ? noValue() : QString::number(start.runNumber)}}};
  }
  static Group settingGroup(const trace::RunStart& start) {
    const auto method = base::methodFromName(start.method);
    streaming::RunSummary run;
    run.feedMmPerS = start.feedMmPerS;
    if (start.feedOverride > 0.0) {
      run.overrideFactor = start.feedOverride;
    }
    return {settings(),
            {{tr("Method"), method ? methodText(*method) : known(start.method)},
             {QStringLiteral("N"), QString::number(start.pointsPerLoop)},
             {QStringLiteral("δ"),
              method && base::usesDelta(*method) ? lengthText(start.deltaMm) : noValue()},
             {tr("Feed"), feedsText(run)},
             {tr("Axes"), start.axes.empty() ? QStringLiteral("XYZ") : known(start.axes)},
             {tr("Layout"), known(start.layout)}}};
  }
  /// From the blocks that the control executed, or else from the positions.
  static Group resultGroup(const TraceFacts& facts) {
    const trace::Integrity& blocks = facts.analysis->blocks;
    const trace::PathMatch& path = facts.analysis->path;
    Group group{result(), {}};
    const auto add = [&](bool isKnown, std::size_t executed, std::size_t total,
                         std::size_t repeated, std::size_t skipped, std::size_t foreign) {
      const auto count = [isKnown](std::size_t value) {
        return isKnown ? countText(value) : tr("not judged");
      };
      group.facts = {
          {tr("Executed"),
           isKnown ? tr("%1 of %2").arg(countText(executed), countText(total)) : tr("not judged")},
          {tr("Repeated"), count(repeated)},
          {tr("Skipped"), count(skipped)},
          {tr("Off the program"), count(foreign)}};
    };
    if (blocks.judged) {
      const std::size_t total =
          facts.recording != nullptr ? facts.recording->points.points.size() : path.points;
      add(true, blocks.executed, total, blocks.repeated, blocks.skipped, blocks.foreign);
      group.facts.append({tr("Out of order"), countText(blocks.outOfOrder)});
    } else {
      add(path.judged, path.executed, path.points, path.repeated, path.skipped, path.foreign);
      group.facts.append({tr("Not decided by the samples"),
                          path.judged ? countText(path.undecided) : tr("not judged")});
    }
    if (facts.recording != nullptr) {
      group.facts.append({tr("Duration"), motionDuration(facts)});
    }
    return group;
  }
  static Group motionGroup(const trace::MotionQuality& quality) {
    const auto contour = [](const trace::ContourError& error) {
      return error.count == 0
                 ? noValue()
                 : tr("%1 in line %2")
                       .arg(lengthText(error.maxMm, 4), QString::number(error.line.value));
    };
    QString following = noValue();
    QString reversal = noValue();
    if (quality.hasFollowing) {
      QStringList errors;
      QStringList reversals;
      for (const trace::FollowingError& error : quality.following) {
        errors.append(numberText(error.maxMm, 3));
        reversals.append(error.reversalMm ? numberText(*error.reversalMm, 4) : noValue());
      }
      const QString slash = QStringLiteral(" / ");
      const QString mm = QStringLiteral("\u00A0mm");
      following = errors.join(slash) + mm;
      reversal = reversals.join(slash) + mm;
    }
    QString vibration = noValue();
    if (!quality.vibration.peaks.empty()) {
      const trace::SpectrumPeak& peak = quality.vibration.peaks.front();
      vibration = QStringLiteral("%1: %2\u00A0Hz")
                      .arg(QLatin1Char(base::kAxisNames[peak.axis]))
                      .arg(numberText(peak.hz, 1));
    }
    return {motion(),
            {{tr("Contour error, set point"), contour(quality.setContour)},
             {tr("Contour error, actual"), contour(quality.actualContour)},
             {tr("Following error XYZ"), following},
             {tr("Reversal error XYZ"), reversal},
             {tr("Strongest vibration"), vibration}}};
  }
  /// Where the time went, the largest loss first.
  static Group timeGroup(const trace::TraceAnalysis& analysis) {
    const trace::FeedKept& feed = analysis.quality.feed;
    Group group{
        timeLost(),
        {{tr("Programmed feed kept"), feed.known ? percentText(feed.share) : noValue()},
         {tr("At the programmed feed"), feed.known ? durationText(feed.programmedS) : noValue()}}};
    std::vector<std::pair<double, QString>> losses;
    if (feed.known) {
      losses.emplace_back(feed.slowS, tr("Lost by moving slower"));
    }
    for (const trace::TimeLost& lost : feed.standing) {
      losses.emplace_back(lost.seconds,
                          tr("%1 × %2").arg(countText(lost.stops), stopCauseText(lost.cause)));
    }
    losses.erase(std::remove_if(losses.begin(), losses.end(),
                                [](const auto& loss) { return loss.first < kSecondsMin; }),
                 losses.end());
    std::stable_sort(losses.begin(), losses.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    constexpr std::size_t kLossesListed = 4;
    losses.resize(std::min(losses.size(), kLossesListed));
    for (const auto& [seconds, name] : losses) {
      group.facts.append({name, durationText(seconds)});
    }
    return group;
  }
  static Group streamGroup(const TraceFacts& facts) {
    std::vector<base::Duration> all;
    for (const trace::Access& access : facts.recording->accesses) {
      all.push_back(access.took);
    }
    const trace::DurationStatistics times = trace::durationStatistics(std::move(all));
    const report::StreamQuality& quality = *facts.stream;
    return {
        stream(),
        {{tr("Requests"), countText(times.count)},
         {tr("Median, 99 %, longest"),
          QStringLiteral("%1 / %2 / %3")
              .arg(numberText(base::toMilliseconds(times.p50), 1),
                   numberText(base::toMilliseconds(times.p99), 1), millisecondsText(times.max, 1))},
         {tr("Requests made again"), countText(quality.lostRequests + quality.refusedRequests)},
         {tr("Machine waited for the client"),
          tr("%1 times, %2").arg(countText(quality.lateWindows), secondsText(quality.waitedS, 2))},
         {tr("Margin; of the slowest 1 %"),
          quality.margin && quality.marginOfSlowest
              ? QStringLiteral("%1; %2").arg(factorText(*quality.margin),
                                             factorText(*quality.marginOfSlowest))
              : noValue()},
         {tr("Largest feed without waiting"),
          quality.feedMmPerSMax ? feedText(*quality.feedMmPerSMax) : noValue()}}};
  }

 private:
  static QString motionDuration(const TraceFacts& facts) {
    if (facts.recording != nullptr && facts.recording->end) {
      return durationText(base::toSeconds(facts.recording->end->duration));
    }
    const auto& samples = facts.analysis->motion.samples;
    return samples.empty() ? noValue()
                           : durationText(base::toSeconds(samples.back().at - samples.front().at));
  }
};

QPointF fromAbove(base::Vec3 place) {
  return {place.x, place.y};
}

paper::Picture pathPicture(const trace::TraceAnalysis& analysis) {
  const trace::Motion& motion = analysis.motion;
  paper::Picture picture;
  picture.caption = TraceTexts::path();
  picture.note = TraceTexts::noMotion();
  picture.isMap = true;
  if (analysis.programPath) {
    const auto& points = analysis.programPath->points();
    paper::Line line{{}, kProgrammed, 0.7};
    for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / kPicturePoints) {
      line.points.append(fromAbove(points[i].positionMm));
    }
    picture.lines.push_back(line);
  }
  if (!motion.samples.empty()) {
    paper::Line line{{}, kMeasured, 0.25};
    for (std::size_t i = 0; i < motion.samples.size();
         i += 1 + motion.samples.size() / kPicturePoints) {
      const trace::MotionSample sample = motion.samples[i];
      line.points.append(fromAbove(motion.hasActual ? sample.actualMm : sample.setMm));
    }
    picture.lines.push_back(line);
  }
  for (const trace::PathFault& fault : analysis.path.faults) {
    picture.marks.push_back({fromAbove(fault.placeMm), kFault});
  }
  return picture;
}

/// Up to which speed is shown, mm/s: some rapids must not flatten the feed of all other moves.
/// @return nothing: all of it
std::optional<double> speedShown(const trace::MotionSamples& samples) {
  constexpr double kOutlier = 4.0;
  constexpr double kRoom = 1.5;
  std::vector<double> speeds;
  const trace::PackedValues all = samples.valuesOf(trace::MotionColumn::Speed);
  trace::PackedReader<trace::PackedValues> reader(all);
  for (std::size_t i = 0; i < reader.size(); ++i) {
    if (reader[i] > 0.0) {
      speeds.push_back(reader[i]);
    }
  }
  if (speeds.empty()) {
    return std::nullopt;
  }
  std::sort(speeds.begin(), speeds.end());
  const double usual = base::quantile(speeds, 950);
  return speeds.back() > kOutlier * usual ? std::optional(kRoom * usual) : std::nullopt;
}

/// The lowest and the highest speed of each column of the picture, and the stops.
paper::Picture speedPicture(const trace::TraceAnalysis& analysis) {
  const trace::MotionSamples& samples = analysis.motion.samples;
  paper::Picture picture;
  picture.caption = TraceTexts::speed();
  picture.note = TraceTexts::noMotion();
  picture.xTitle = TraceTexts::seconds();
  picture.yTitle = TraceTexts::mmPerMin();
  if (samples.empty()) {
    return picture;
  }
  const base::Instant origin = samples.front().at;
  for (const trace::Standstill& stop : analysis.stops) {
    const double from = base::toSeconds(stop.start - origin);
    picture.bands.push_back({from, from + base::toSeconds(stop.duration), kStop});
  }
  const std::optional<double> shown = speedShown(samples);
  if (shown) {
    picture.caption = TraceTexts::speedBelow(base::mmPerMinFromMmPerS(*shown));
  }
  paper::Line line{{}, kMeasured, 0.2};
  const auto add = [&](const trace::MotionSample& sample) {
    const double speed = shown ? std::min(*shown, sample.pathMmPerS) : sample.pathMmPerS;
    line.points.append({base::toSeconds(sample.at - origin), base::mmPerMinFromMmPerS(speed)});
  };
  const std::size_t stride = 1 + samples.size() / (kPicturePoints / 2);
  trace::MotionReader reader(samples);
  for (std::size_t begin = 0; begin < samples.size(); begin += stride) {
    trace::MotionSample low = reader[begin];
    trace::MotionSample high = low;
    for (std::size_t i = begin + 1; i < std::min(samples.size(), begin + stride); ++i) {
      const trace::MotionSample& sample = reader[i];
      low = sample.pathMmPerS < low.pathMmPerS ? sample : low;
      high = sample.pathMmPerS < high.pathMmPerS ? high : sample;
    }
    add(low.at < high.at ? low : high);
    add(low.at < high.at ? high : low);
  }
  picture.lines.push_back(line);
  return picture;
}

/// The median and the longest request of each part of the run.
paper::Picture accessPicture(const trace::Recording& recording) {
  paper::Picture picture;
  picture.caption = TraceTexts::access();
  picture.xTitle = TraceTexts::seconds();
  picture.yTitle = TraceTexts::milliseconds();
  const std::vector<report::AccessPeriod> periods =
      report::accessPeriods(recording, kAccessPeriods);
  paper::Line median{{}, kMeasured, 0.3};
  paper::Line longest{{}, kLongest, 0.2};
  for (const report::AccessPeriod& period : periods) {
    if (period.times.count > 0) {
      const double at = base::toSeconds(period.from);
      median.points.append({at, base::toMilliseconds(period.times.p50)});
      longest.points.append({at, base::toMilliseconds(period.times.max)});
    }
  }
  picture.lines = {longest, median};
  return picture;
}

paper::Table stopTable(const trace::TraceAnalysis& analysis) {
  std::vector<trace::Standstill> stops = analysis.stops;
  std::stable_sort(stops.begin(), stops.end(),
                   [](const trace::Standstill& a, const trace::Standstill& b) {
                     return a.duration > b.duration;
                   });
  paper::Table table{TraceTexts::longestStops(stops.size()),
                     TraceTexts::stopHeadings(),
                     {2.0, 2.0, 6.0, 1.5, 5.0},
                     {}};
  stops.resize(std::min(stops.size(), kStopsListed));
  for (const trace::Standstill& stop : stops) {
    table.rows.append(
        {secondsText(base::toSeconds(stop.start - analysis.motion.samples.front().at), 3),
         millisecondsText(stop.duration, 0),
         QStringLiteral("X %1  Y %2  Z %3")
             .arg(numberText(stop.placeMm.x, 3), numberText(stop.placeMm.y, 3),
                  numberText(stop.placeMm.z, 3)),
         stop.line == 0 ? noValue() : QString::number(stop.line), stopCauseText(stop.cause)});
  }
  return table;
}

}  // namespace

paper::Page tracePage(const TraceFacts& facts) {
  const trace::TraceAnalysis& analysis = *facts.analysis;
  paper::Page page;
  page.language = QLocale().bcp47Name();
  page.title = TraceTexts::title(facts.recording != nullptr);
  const bool isFaulty = facts.finding == streaming::RunFinding::Faulty;
  page.rating = isFaulty || facts.outcome == streaming::Outcome::Failed ? paper::Rating::Bad
                : facts.finding == streaming::RunFinding::Faultless     ? paper::Rating::Good
                                                                        : paper::Rating::Unknown;
  page.result = facts.recording != nullptr && facts.recording->complete
                    ? resultText(facts.outcome, facts.finding)
                    : TraceTexts::judgement(facts.finding);
  if (facts.recording != nullptr && !facts.recording->complete) {
    page.sentences.append(TraceTexts::cut());
  }
  if (facts.finding == streaming::RunFinding::NotJudged) {
    page.sentences.append(TraceTexts::notJudged());
  }
  if (analysis.path.departure) {
    page.sentences.append(TraceTexts::departure(*analysis.path.departure));
  }
  if (facts.stream != nullptr) {
    page.sentences.append(TraceTexts::limit(*facts.stream));
    if (!facts.stream->advice.empty()) {
      page.sentences.append(TraceTexts::advice(facts.stream->advice.front()));
    }
  }
  page.groups.push_back(TraceTexts::runGroup(facts));
  if (facts.recording != nullptr) {
    page.groups.push_back(TraceTexts::settingGroup(facts.recording->start));
  }
  page.groups.push_back(TraceTexts::resultGroup(facts));
  page.groups.push_back(TraceTexts::motionGroup(analysis.quality));
  page.groups.push_back(TraceTexts::timeGroup(analysis));
  if (facts.stream != nullptr) {
    page.groups.push_back(TraceTexts::streamGroup(facts));
  }
  page.pictures = {pathPicture(analysis), speedPicture(analysis)};
  if (facts.stream != nullptr) {
    page.pictures.push_back(accessPicture(*facts.recording));
  }
  if (!analysis.stops.empty()) {
    page.table = stopTable(analysis);
  }
  page.signature = TraceTexts::signature();
  page.footer = {TraceTexts::fileLine(facts), TraceTexts::versionLine(facts)};
  return page;
}

}  // namespace rivulet::trace_report
