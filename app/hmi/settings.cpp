// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/settings.h"

#include <QSettings>
#include <algorithm>
#include <array>
#include <utility>

#include "base/units.h"
#include "gcode/feeds.h"
#include "hmi/users.h"
#include "journal/line_file.h"

namespace rivulet::hmi {

namespace {

QString text(std::string_view view) {
  return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size()));
}

constexpr std::array<std::pair<streaming::AccessPreference, const char*>, 4> kAccessNames{{
    {streaming::AccessPreference::Automatic, "automatic"},
    {streaming::AccessPreference::Array, "array"},
    {streaming::AccessPreference::List, "list"},
    {streaming::AccessPreference::Single, "single"},
}};

constexpr const char* kFixedFeed = "fixed";
constexpr const char* kMotionOnly = "motion";

/// A positive number, or what was there before: a damaged file must not become an order.
double positive(const QVariant& value, double otherwise) {
  bool isNumber = false;
  const double number = value.toDouble(&isNumber);
  return isNumber && number > 0.0 && number < 1e6 ? number : otherwise;
}

}  // namespace

void Settings::addRecentFile(const QString& path) {
  recentFiles.removeAll(path);
  recentFiles.prepend(path);
  while (recentFiles.size() > kRecentFilesMax) {
    recentFiles.removeLast();
  }
}

Settings loadSettings() {
  const QSettings store;
  Settings settings;
  settings.stateFolder = journal::stateFolderOfUser();
  settings.usersFile = Users::fileOfUser();
  settings.endpoint = store.value(QStringLiteral("endpoint"), settings.endpoint).toString();
  settings.recentFiles = store.value(QStringLiteral("recentFiles")).toStringList();
  settings.language = store.value(QStringLiteral("language")).toString();
  settings.theme = widgets::themeFromName(store.value(QStringLiteral("theme")).toString());
  settings.geometry = store.value(QStringLiteral("geometry")).toByteArray();
  widgets::StreamSettings& stream = settings.stream;
  stream.feedMmPerS = base::mmPerSFromMmPerMin(2000.0);
  stream.parameters.method =
      base::methodFromName(store.value(QStringLiteral("stream/method")).toString().toStdString())
          .value_or(stream.parameters.method);
  stream.parameters.layout =
      templates::layoutFromName(
          store.value(QStringLiteral("stream/layout")).toString().toStdString())
          .value_or(stream.parameters.layout);
  const QString access = store.value(QStringLiteral("stream/access")).toString();
  for (const auto& [order, name] : kAccessNames) {
    if (access == QLatin1String(name)) {
      stream.access = order;
    }
  }
  const int points = store.value(QStringLiteral("stream/points")).toInt();
  if (points >= 2) {
    stream.parameters.pointsPerLoop = points;
  }
  const double correctionMm =
      positive(store.value(QStringLiteral("stream/correctionLimitMm")), 0.0);
  if (correctionMm <= templates::kCorrectionLimitMmMax &&
      stream.parameters.method == base::MethodKind::Window) {
    stream.parameters.correctionLimitMm = correctionMm;
  }
  stream.deltaMm = positive(store.value(QStringLiteral("stream/deltaMm")), stream.deltaMm);
  stream.programFeeds =
      store.value(QStringLiteral("stream/feed")).toString() != QLatin1String(kFixedFeed);
  stream.wholeJob =
      store.value(QStringLiteral("stream/job")).toString() != QLatin1String(kMotionOnly);
  stream.overrideFactor =
      std::clamp(positive(store.value(QStringLiteral("stream/overridePercent")), 100.0) / 100.0,
                 gcode::kOverrideMin, gcode::kOverrideMax);
  stream.feedMmPerS =
      base::mmPerSFromMmPerMin(positive(store.value(QStringLiteral("stream/feedMmPerMin")),
                                        base::mmPerMinFromMmPerS(stream.feedMmPerS)));
  return settings;
}

void saveSettings(const Settings& settings) {
  QSettings store;
  store.setValue(QStringLiteral("endpoint"), settings.endpoint);
  store.setValue(QStringLiteral("recentFiles"), settings.recentFiles);
  store.setValue(QStringLiteral("language"), settings.language);
  store.setValue(QStringLiteral("theme"), widgets::themeName(settings.theme));
  store.setValue(QStringLiteral("geometry"), settings.geometry);
  const widgets::StreamSettings& stream = settings.stream;
  store.setValue(QStringLiteral("stream/method"), text(base::methodName(stream.parameters.method)));
  store.setValue(QStringLiteral("stream/layout"),
                 text(templates::layoutName(stream.parameters.layout)));
  for (const auto& [order, name] : kAccessNames) {
    if (stream.access == order) {
      store.setValue(QStringLiteral("stream/access"), QString::fromLatin1(name));
    }
  }
  store.setValue(QStringLiteral("stream/points"), stream.parameters.pointsPerLoop);
  store.setValue(QStringLiteral("stream/deltaMm"), stream.deltaMm);
  store.setValue(QStringLiteral("stream/correctionLimitMm"), stream.parameters.correctionLimitMm);
  store.setValue(QStringLiteral("stream/feed"),
                 stream.programFeeds ? QStringLiteral("program") : QString::fromLatin1(kFixedFeed));
  store.setValue(QStringLiteral("stream/job"),
                 stream.wholeJob ? QStringLiteral("whole") : QString::fromLatin1(kMotionOnly));
  store.setValue(QStringLiteral("stream/overridePercent"), 100.0 * stream.overrideFactor);
  store.setValue(QStringLiteral("stream/feedMmPerMin"),
                 base::mmPerMinFromMmPerS(stream.feedMmPerS));
}

}  // namespace rivulet::hmi
