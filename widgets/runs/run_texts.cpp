// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/runs/run_texts.h"

#include <QCoreApplication>
#include <optional>

#include "widgets/common/number_format.h"

namespace rivulet::widgets {

namespace {

struct RunTexts {
  Q_DECLARE_TR_FUNCTIONS(RunTexts)

 public:
  static QString onComputer(const QString& user, const QString& computer) {
    return tr("%1 on %2").arg(user, computer);
  }
  static QString jobTimes(const streaming::JobTimes& times) {
    const auto text = [](base::Duration duration) {
      return durationText(base::toSeconds(duration));
    };
    return tr("%1 streamed, %2 pauses, %3 tool changes, %4 other blocks of the control, %5 changes "
              "between both; %6 in all")
        .arg(text(times.streamed), text(times.pauses), text(times.toolChange), text(times.native),
             text(times.handover), text(times.total()));
  }
  static QString tool(const trace::ToolUse& use) {
    const QString name = QString::fromStdString(use.name);
    if (use.number.value_or(0) > 0) {
      const QString number = QStringLiteral("T%1").arg(*use.number);
      return name.isEmpty() ? number : QStringLiteral("%1 %2").arg(number, name);
    }
    return !name.isEmpty() ? name : use.number ? tr("No tool") : tr("Before the first tool change");
  }
  static QString toolUse(const trace::ToolUse& use) {
    const auto time = [](base::Duration duration) {
      return durationText(base::toSeconds(duration));
    };
    QStringList parts{tr("%1 in the spindle").arg(time(use.inSpindle))};
    if (use.change > base::Duration{}) {
      parts.append(tr("%1 change").arg(time(use.change)));
    }
    if (const QString perMin = perMinText(use); !perMin.isEmpty()) {
      parts.append(tr("%1 at %2 1/min").arg(time(use.turning), perMin));
    }
    if (use.cooling > base::Duration{}) {
      parts.append(tr("%1 coolant").arg(time(use.cooling)));
    }
    for (const int offset : use.workOffsets) {
      parts.append(QStringLiteral("G%1").arg(offset));
    }
    return QStringLiteral("%1: %2").arg(tool(use), parts.join(QStringLiteral(", ")));
  }
  static QString result(streaming::Outcome outcome, streaming::RunFinding finding) {
    if (outcome == streaming::Outcome::Failed) {
      return tr("Failed");
    }
    const bool isStopped = outcome == streaming::Outcome::Stopped;
    switch (finding) {
      case streaming::RunFinding::Faultless:
        return isStopped ? tr("Stopped") : tr("Completed");
      case streaming::RunFinding::NotJudged:
        return isStopped ? tr("Stopped, not judged") : tr("Completed, not judged");
      case streaming::RunFinding::Faulty:
        break;
    }
    return isStopped ? tr("Stopped, with wrong motion") : tr("Completed with wrong motion");
  }
  static QString method(base::MethodKind method) {
    switch (method) {
      case base::MethodKind::Position:
        return tr("Position");
      case base::MethodKind::Signal:
        return tr("Signal");
      case base::MethodKind::Credit:
        return tr("Credit (experimental)");
      case base::MethodKind::File:
        return tr("File");
      case base::MethodKind::Window:
        return tr("Window");
    }
    const std::string_view name = base::methodName(method);
    return QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
  }
  static QString programFeeds(const QString& percent) { return tr("program, %1 %").arg(percent); }
};

/// @param overrideFactor  on the feeds of the program; nothing: all moves had one feed
QString feeds(std::optional<double> overrideFactor, double feedMmPerS) {
  constexpr double kPercent = 100.0;
  return overrideFactor
             ? RunTexts::programFeeds(QString::number(qRound(*overrideFactor * kPercent)))
             : feedText(feedMmPerS);
}

}  // namespace

QString resultText(streaming::Outcome outcome, streaming::RunFinding finding) {
  return RunTexts::result(outcome, finding);
}

QString methodText(base::MethodKind method) {
  return RunTexts::method(method);
}

QDateTime startOf(const streaming::RunSummary& run) {
  return QDateTime::fromString(QString::fromStdString(run.origin.startedAtUtc), Qt::ISODate)
      .toLocalTime();
}

QString startText(const streaming::RunSummary& run) {
  const QDateTime start = startOf(run);
  return start.isValid() ? start.toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")) : noValue();
}

QString feedsText(const streaming::RunSummary& run) {
  return feeds(run.overrideFactor, run.feedMmPerS);
}

QString feedsText(const streaming::RunSettings& settings) {
  return feeds(
      settings.programFeeds ? std::optional(settings.programFeeds->overrideFactor) : std::nullopt,
      settings.feedMmPerS);
}

QString jobTimesText(const streaming::JobTimes& times) {
  return RunTexts::jobTimes(times);
}

QString toolText(const trace::ToolUse& use) {
  return RunTexts::tool(use);
}

QString toolUseText(const trace::ToolUse& use) {
  return RunTexts::toolUse(use);
}

QString perMinText(const trace::ToolUse& use) {
  if (use.perMinMost <= 0.0) {
    return {};
  }
  const QString most = numberText(use.perMinMost, 0);
  return use.perMinLeast < use.perMinMost
             ? QStringLiteral("%1 – %2").arg(numberText(use.perMinLeast, 0), most)
             : most;
}

QString machineText(const streaming::RunSummary& run) {
  QString machine = QString::fromStdString(run.endpoint);
  if (machine.startsWith(QLatin1String("opc.tcp://"))) {
    machine.remove(0, 10);
  }
  return machine.isEmpty() ? noValue() : machine;
}

QString originText(const streaming::RunOrigin& origin) {
  const QString user = QString::fromStdString(origin.user);
  const QString computer = QString::fromStdString(origin.computer);
  if (user.isEmpty()) {
    return computer.isEmpty() ? noValue() : computer;
  }
  return computer.isEmpty() ? user : RunTexts::onComputer(user, computer);
}

}  // namespace rivulet::widgets
