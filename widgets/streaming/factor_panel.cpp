// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/streaming/factor_panel.h"

#include <QComboBox>
#include <QGroupBox>
#include <array>
#include <utility>

#include "templates/cells.h"
#include "widgets/common/number_field.h"
#include "widgets/common/status_label.h"
#include "widgets/live/live_text.h"

namespace rivulet::widgets {

namespace {

constexpr double kWholePercent = 100.0;
constexpr live::FactorAgreement kUsualFactor;
constexpr int kFactorPort = 4002;
constexpr int kHoldAxes = 0;  ///< place in the list of what acts without a factor
/// In the order of the list; the first is no source.
constexpr std::array<const char*, 3> kSourceKinds{"", "tcp:", "udp:"};

}  // namespace

FactorPanel::FactorPanel(QWidget* parent)
    : Page(parent),
      m_port(whole(1024, 65535, {.id = "factor-port"})),
      m_least(number({.min = kWholePercent * templates::kFactorMin,
                      .max = kWholePercent,
                      .decimals = 0,
                      .step = 5.0,
                      .unit = "%"},
                     {.id = "factor-least"})),
      m_most(number({.min = kWholePercent,
                     .max = kWholePercent * templates::kFactorMax,
                     .decimals = 0,
                     .step = 5.0,
                     .unit = "%"},
                    {.id = "factor-most"})),
      m_silence(
          number({.min = 0.1, .max = 60.0, .decimals = 1, .unit = "s"}, {.id = "factor-silence"})),
      m_form(new Form(this, nullptr, Form::Height::Touch)) {
  setMinimumWidth(330);
  m_form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  m_form->row({.text = QT_TR_NOOP("Source")}, m_source);
  m_form->row({.text = QT_TR_NOOP("Port")}, m_port);
  m_form->row({.text = QT_TR_NOOP("At least"),
               .tip = QT_TR_NOOP("Smallest factor of your override that may act")},
              m_least);
  m_form->row({.text = QT_TR_NOOP("At most"),
               .tip = QT_TR_NOOP("Largest factor that may act; together with your override no more "
                                 "than 120 % of the programmed feed")},
              m_most);
  m_form->row({.text = QT_TR_NOOP("Silent after")}, m_silence);
  m_form->row({.text = QT_TR_NOOP("Without a factor"),
               .tip = QT_TR_NOOP("Before the first one, when the source is silent or closed, and "
                                 "when it sends what was not agreed")},
              m_without);
  m_port->setValue(kFactorPort);
  m_least->setValue(kWholePercent * kUsualFactor.least);
  m_most->setValue(kWholePercent * kUsualFactor.most);
  m_silence->setValue(base::toSeconds(kUsualFactor.silence));
  inColumn({m_form, m_status}, m_group);
  inColumn({m_group}, this);
  onEdit({m_source, m_port, m_least, m_most, m_silence, m_without}, &FactorPanel::takeChoice);
  onLanguage(&FactorPanel::showAll);
}

void FactorPanel::setChoice(const FactorChoice& choice) {
  m_choice = choice;
  showAll();
}

void FactorPanel::setEditable(bool editable) {
  m_editable = editable;
  showAll();
}

void FactorPanel::setFeed(const std::optional<streaming::FeedSeen>& feed) {
  const auto seen = feed ? feed->source : std::nullopt;
  if (seen != m_seen) {
    m_seen = seen;
    showStatus();
  }
}

void FactorPanel::takeChoice() {
  if (m_isShowing) {
    return;
  }
  const auto kind = static_cast<std::size_t>(m_source->currentIndex());
  FactorChoice choice;
  if (kind > 0) {
    choice.source.address = kind < kSourceKinds.size()
                                ? kSourceKinds[kind] + std::to_string(m_port->value())
                                : m_source->currentText().toStdString();
    choice.least = m_least->value() / kWholePercent;
    choice.most = m_most->value() / kWholePercent;
    choice.source.silence = base::fromSeconds(m_silence->value());
    choice.source.holdsInSilence = m_without->currentIndex() == kHoldAxes;
  }
  if (choice != m_choice) {
    m_choice = choice;
    showAll();
    Q_EMIT choiceChanged(m_choice);
  }
}

void FactorPanel::showAll() {
  const bool wasShowing = std::exchange(m_isShowing, true);
  const QString address = QString::fromStdString(m_choice.source.address);
  int kind = address.isEmpty() ? 0 : static_cast<int>(kSourceKinds.size());
  for (int i = 1; i < static_cast<int>(kSourceKinds.size()); ++i) {
    const QString begin = QLatin1String(kSourceKinds[static_cast<std::size_t>(i)]);
    if (address.startsWith(begin)) {
      kind = i;
      m_port->setValue(address.mid(begin.size()).toInt());
    }
  }
  // A run of the command line may have another one.
  while (m_source->count() > static_cast<int>(kSourceKinds.size())) {
    m_source->removeItem(m_source->count() - 1);
  }
  if (kind == m_source->count()) {
    m_source->addItem(address);
  }
  m_source->setCurrentIndex(kind);
  const bool isChosen = kind > 0;
  if (isChosen) {
    m_least->setValue(kWholePercent * m_choice.least);
    m_most->setValue(kWholePercent * m_choice.most);
    m_silence->setValue(base::toSeconds(m_choice.source.silence));
    m_without->setCurrentIndex(m_choice.source.holdsInSilence ? kHoldAxes : kHoldAxes + 1);
  }
  for (QWidget* field :
       std::initializer_list<QWidget*>{m_port, m_least, m_most, m_silence, m_without}) {
    m_form->setRowVisible(
        field, isChosen && (field != m_port || kind < static_cast<int>(kSourceKinds.size())));
    field->setEnabled(m_editable);
  }
  m_source->setEnabled(m_editable);
  m_isShowing = wasShowing;
  showStatus();
}

void FactorPanel::showStatus() {
  if (m_seen) {
    m_status->setStatus(m_seen->why.empty() ? Status::Good : Status::Attention,
                        feedSourceText(*m_seen));
  } else if (m_choice.source.address.empty()) {
    m_status->setStatus(Status::Unknown, tr("Your override acts alone."));
  } else {
    m_status->setStatus(Status::Plain,
                        m_choice.source.holdsInSilence
                            ? tr("It is read from the start on. Nothing moves before its first "
                                 "factor.")
                            : tr("It is read from the start on."));
  }
}

}  // namespace rivulet::widgets
