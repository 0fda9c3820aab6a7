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
#include "sources/open_source.h"
#include "templates/feed_cell.h"

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

/// A positive number, or what was there before: a damaged file must not become an order.
double positive(const QVariant& value, double otherwise) {
  bool isNumber = false;
  const double number = value.toDouble(&isNumber);
  return isNumber && number > 0.0 && number < 1e6 ? number : otherwise;
}

constexpr std::array<const char*, 2 * base::kAxisCount> kBoxKeys{
    "live/xFrom", "live/xTo", "live/yFrom", "live/yTo", "live/zFrom", "live/zTo"};

/// All or nothing: half of an agreement is none.
live::Setup loadLive(const QSettings& store) {
  live::Setup setup;
  setup.address = store.value(QStringLiteral("live/address"), QString::fromStdString(setup.address))
                      .toString()
                      .toStdString();
  live::Agreement& agreed = setup.agreement;
  const auto number = [&store](const char* key, double otherwise) {
    bool isNumber = false;
    const double value = store.value(QLatin1String(key)).toDouble(&isNumber);
    return isNumber ? value : otherwise;
  };
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    agreed.lowestMm.set(axis, number(kBoxKeys[2 * axis], agreed.lowestMm[axis]));
    agreed.highestMm.set(axis, number(kBoxKeys[2 * axis + 1], agreed.highestMm[axis]));
  }
  agreed.stepMmMax = number("live/stepMm", agreed.stepMmMax);
  agreed.turnDegMax = number("live/turnDeg", agreed.turnDegMax);
  agreed.feedMmPerMinMax = number("live/feedMmPerMin", agreed.feedMmPerMinMax);
  agreed.distanceMmMin = number("live/mergeMm", agreed.distanceMmMin);
  agreed.startMmMax = number("live/firstMm", agreed.startMmMax);
  live::Limits& limits = setup.limits;
  const auto time = [&number](const char* key, base::Duration otherwise) {
    return base::fromSeconds(std::clamp(number(key, base::toSeconds(otherwise)), 0.0, 1e6));
  };
  limits.fullWithin = time("live/fullWithinS", limits.fullWithin);
  limits.holdAfter = time("live/holdAfterS", limits.holdAfter);
  limits.endAfter = time("live/endAfterS", limits.endAfter);
  return live::requireSound(setup) ? setup : live::Setup{};
}

void saveLive(QSettings& store, const live::Setup& setup) {
  const live::Agreement& agreed = setup.agreement;
  store.setValue(QStringLiteral("live/address"), QString::fromStdString(setup.address));
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    store.setValue(QLatin1String(kBoxKeys[2 * axis]), agreed.lowestMm[axis]);
    store.setValue(QLatin1String(kBoxKeys[2 * axis + 1]), agreed.highestMm[axis]);
  }
  for (const auto& [key, value] : std::initializer_list<std::pair<const char*, double>>{
           {"live/stepMm", agreed.stepMmMax},
           {"live/turnDeg", agreed.turnDegMax},
           {"live/feedMmPerMin", agreed.feedMmPerMinMax},
           {"live/mergeMm", agreed.distanceMmMin},
           {"live/firstMm", agreed.startMmMax},
           {"live/fullWithinS", base::toSeconds(setup.limits.fullWithin)},
           {"live/holdAfterS", base::toSeconds(setup.limits.holdAfter)},
           {"live/endAfterS", base::toSeconds(setup.limits.endAfter)}}) {
    store.setValue(QLatin1String(key), value);
  }
}

/// All or nothing, as above.
void loadFactor(const QSettings& store, streaming::StreamSettings& stream) {
  live::FactorSource source;
  source.address = store.value(QStringLiteral("factor/source")).toString().toStdString();
  const double least = positive(store.value(QStringLiteral("factor/least")), 0.0);
  const double most = positive(store.value(QStringLiteral("factor/most")), 0.0);
  source.silence = base::fromSeconds(
      positive(store.value(QStringLiteral("factor/silenceS")), base::toSeconds(source.silence)));
  source.holdsInSilence = store.value(QStringLiteral("factor/holds"), true).toBool();
  if (sources::isPort(source.address) && templates::areFactorBounds(least, most) &&
      base::fillsWindows(stream.parameters.method)) {
    stream.factor = source;
    stream.parameters.factorLeast = least;
    stream.parameters.factorMost = most;
  }
}

void saveFactor(QSettings& store, const streaming::StreamSettings& stream) {
  store.setValue(QStringLiteral("factor/source"), QString::fromStdString(stream.factor.address));
  store.setValue(QStringLiteral("factor/least"), stream.parameters.factorLeast);
  store.setValue(QStringLiteral("factor/most"), stream.parameters.factorMost);
  store.setValue(QStringLiteral("factor/silenceS"), base::toSeconds(stream.factor.silence));
  store.setValue(QStringLiteral("factor/holds"), stream.factor.holdsInSilence);
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
  settings.services = store.value(QStringLiteral("services")).toStringList();
  settings.language = store.value(QStringLiteral("language")).toString();
  settings.theme = widgets::themeFromName(store.value(QStringLiteral("theme")).toString());
  settings.geometry = store.value(QStringLiteral("geometry")).toByteArray();
  streaming::StreamSettings& stream = settings.stream;
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
      base::fillsWindows(stream.parameters.method)) {
    stream.parameters.correctionLimitMm = correctionMm;
  }
  const double liftMm = positive(store.value(QStringLiteral("stream/liftMm")), 0.0);
  if (liftMm <= templates::kLiftMmMax && base::fillsWindows(stream.parameters.method)) {
    stream.parameters.liftMm = liftMm;
  }
  stream.parameters.packed = store.value(QStringLiteral("stream/packed")).toBool() &&
                             base::fillsWindows(stream.parameters.method);
  const double tolerance = positive(store.value(QStringLiteral("stream/tolerance")), 0.0);
  if (tolerance <= gcode::kStreamToleranceMax) {
    stream.tolerance = tolerance;
  }
  loadFactor(store, stream);
  stream.deltaMm = positive(store.value(QStringLiteral("stream/deltaMm")), stream.deltaMm);
  stream.programFeeds =
      store.value(QStringLiteral("stream/feed")).toString() != QLatin1String(kFixedFeed);
  stream.wholeJob = true;  // anything else is chosen for one program
  stream.overrideFactor =
      std::clamp(positive(store.value(QStringLiteral("stream/overridePercent")), 100.0) / 100.0,
                 gcode::kOverrideMin, gcode::kOverrideMax);
  stream.feedMmPerS =
      base::mmPerSFromMmPerMin(positive(store.value(QStringLiteral("stream/feedMmPerMin")),
                                        base::mmPerMinFromMmPerS(stream.feedMmPerS)));
  settings.live = loadLive(store);
  return settings;
}

void saveSettings(const Settings& settings) {
  QSettings store;
  store.setValue(QStringLiteral("endpoint"), settings.endpoint);
  store.setValue(QStringLiteral("recentFiles"), settings.recentFiles);
  store.setValue(QStringLiteral("services"), settings.services);
  store.setValue(QStringLiteral("language"), settings.language);
  store.setValue(QStringLiteral("theme"), widgets::themeName(settings.theme));
  store.setValue(QStringLiteral("geometry"), settings.geometry);
  const streaming::StreamSettings& stream = settings.stream;
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
  store.setValue(QStringLiteral("stream/liftMm"), stream.parameters.liftMm);
  store.setValue(QStringLiteral("stream/packed"), stream.parameters.packed);
  store.setValue(QStringLiteral("stream/tolerance"), stream.tolerance);
  store.setValue(QStringLiteral("stream/feed"),
                 stream.programFeeds ? QStringLiteral("program") : QString::fromLatin1(kFixedFeed));
  store.setValue(QStringLiteral("stream/overridePercent"), 100.0 * stream.overrideFactor);
  store.setValue(QStringLiteral("stream/feedMmPerMin"),
                 base::mmPerMinFromMmPerS(stream.feedMmPerS));
  saveFactor(store, stream);
  saveLive(store, settings.live);
}

}  // namespace rivulet::hmi
