// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/streaming/found_run_bar.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QPushButton>

#include "base/units.h"
#include "widgets/common/number_format.h"

namespace rivulet::widgets {

namespace {

struct FoundRunTexts {
  Q_DECLARE_TR_FUNCTIONS(FoundRunTexts)

 public:
  static QString name(const FoundRunView& run) {
    if (run.number == 0) {
      return tr("A program of Rivulet without a run");
    }
    return run.program.isEmpty() ? tr("Run %1").arg(run.number)
                                 : tr("Run %1 of %2").arg(QString::number(run.number), run.program);
  }
  static QString origin(const FoundRunView& run) {
    if (run.user.isEmpty()) {
      return run.number == 0 ? QString() : tr("It is not known who started it.");
    }
    const QDateTime at = QDateTime::fromString(run.startedAtUtc, Qt::ISODate).toLocalTime();
    return tr("Started by %1 on %2 at %3.")
        .arg(run.user, run.computer,
             at.isValid() ? at.toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")) : run.startedAtUtc);
  }
  static QString progress(const FoundRunView& run) {
    return run.total > 0
               ? tr("%1 of %2 points executed").arg(countText(run.executed), countText(run.total))
               : tr("%Ln windows executed", nullptr, static_cast<int>(run.executed));
  }
  static QString state(const FoundRunView& run) {
    switch (run.kind) {
      case FoundRunView::Kind::Unclear:
        return tr("%1. Looking for its client …").arg(progress(run));
      case FoundRunView::Kind::Waiting:
        return run.number == 0
                   ? tr("It waits for its first client.")
                   : tr("%1. Its client is gone: the program waits.").arg(progress(run));
      case FoundRunView::Kind::Served:
        return tr("%1. Its client is at work.").arg(progress(run));
      case FoundRunView::Kind::Left:
        return tr("It was not completed, and its program is no longer active on the control.");
    }
    return {};
  }
  static QString stop(const FoundRunView& run) {
    if (run.isHeld && run.stopConfirmedAfter) {
      return tr("The axes stand (%1 after the order), and stay where they are until the run is "
                "ended or resumed.")
          .arg(secondsText(base::toSeconds(*run.stopConfirmedAfter), 2));
    }
    if (run.stopConfirmedAfter) {
      return tr("Stop confirmed after %1.")
          .arg(secondsText(base::toSeconds(*run.stopConfirmedAfter), 2));
    }
    return run.isStopping ? stopRequestedText(run.ahead) + QLatin1Char('.') : QString();
  }
};

}  // namespace

QString foundRunText(const FoundRunView& run) {
  const QString origin = FoundRunTexts::origin(run);
  return FoundRunTexts::name(run) + QStringLiteral(". ") + origin;
}

QString stopRequestedText(const std::optional<MotionLeft>& ahead) {
  return ahead && ahead->lengthMm > 0.0
             ? FoundRunBar::tr("Stop requested: still moving, at most %1, about %2")
                   .arg(lengthText(ahead->lengthMm, 0), secondsText(ahead->seconds, 0))
             : FoundRunBar::tr("Stop requested, not yet confirmed");
}

FoundRunBar::FoundRunBar(QWidget* parent)
    : NoticeBar(parent),
      m_watch(
          addButton({.text = QT_TR_NOOP("Watch"),
                     .tip = QT_TR_NOOP("Shows program, position and progress. Nothing is changed."),
                     .icon = "live",
                     .id = "found-watch"})),
      m_stop(addButton({.text = QT_TR_NOOP("Stop the run"),
                        .tip = QT_TR_NOOP("The axes stand at once, whoever started the run."),
                        .icon = "stop",
                        .id = "found-stop"})),
      m_end(addButton({.text = QT_TR_NOOP("End here"),
                       .tip = QT_TR_NOOP("The axes go on to the end of the window, or of the block "
                                         "of the control, and the program ends there."),
                       .icon = "stop",
                       .id = "found-end"})),
      m_resume(addButton({.text = QT_TR_NOOP("Resume …"),
                          .tip = QT_TR_NOOP("Loads the program, compares it and asks the control "
                                            "where the run was left. Nothing moves yet."),
                          .icon = "resume",
                          .id = "found-resume"})),
      m_dismiss(
          addButton({.text = QT_TR_NOOP("Not now"), .icon = "dismiss", .id = "found-dismiss"})) {
  m_watch->setCheckable(true);
  connect(m_watch, &QPushButton::clicked, this, &FoundRunBar::watchRequested);
  connect(m_stop, &QPushButton::clicked, this, &FoundRunBar::stopRequested);
  connect(m_end, &QPushButton::clicked, this, &FoundRunBar::endRequested);
  connect(m_resume, &QPushButton::clicked, this, &FoundRunBar::resumeRequested);
  connect(m_dismiss, &QPushButton::clicked, this, &FoundRunBar::dismissed);
  retranslate();
  restyle();
}

void FoundRunBar::setRun(const std::optional<FoundRunView>& run) {
  m_run = run;
  setVisible(run.has_value());
  retranslate();
}

QString FoundRunBar::text() const {
  QStringList sentences{foundRunText(*m_run).trimmed(), FoundRunTexts::state(*m_run),
                        FoundRunTexts::stop(*m_run)};
  if (m_run->kind == FoundRunView::Kind::Waiting && !m_run->isKeptHere && m_run->number != 0) {
    sentences.append(tr("It can be resumed on the computer where it was started."));
  }
  sentences.removeAll(QString());
  return sentences.join(QLatin1Char(' '));
}

void FoundRunBar::retranslate() {
  if (!m_run) {
    return;
  }
  const bool isOnControl = m_run->isOnControl();
  m_watch->setVisible(isOnControl && m_run->number != 0);
  m_watch->setChecked(m_run->isWatched);
  m_stop->setVisible(isOnControl && !m_run->isHeld);
  m_stop->setEnabled(!m_run->isStopping);
  m_end->setVisible(isOnControl && m_run->isHeld);
  m_resume->setVisible(m_run->isKeptHere);
  m_resume->setEnabled(m_run->canResume());
  m_dismiss->setVisible(!isOnControl);
  setNotice(m_run->kind == FoundRunView::Kind::Waiting ? Status::Attention : Status::Busy, text());
}

}  // namespace rivulet::widgets
