// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/reading_bar.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/common/icons.h"
#include "widgets/common/number_format.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

using gcode::DiagnosticCode;

/// The argument of the finding with this code; nothing: there is none.
std::optional<QString> argumentOf(const gcode::Program& program, DiagnosticCode code) {
  const gcode::Diagnostic* const found = gcode::findingOf(program, code);
  return found == nullptr ? std::nullopt : std::optional(QString::fromStdString(found->argument));
}

/// "X 10.000, Y 2.000"
QString placeText(const base::Vec3& endMm) {
  QStringList parts;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (std::isfinite(endMm[axis])) {
      parts.push_back(QStringLiteral("%1 %2")
                          .arg(QLatin1Char(base::kAxisNames[axis]))
                          .arg(numberText(endMm[axis], 3)));
    }
  }
  return parts.join(QStringLiteral(", "));
}

}  // namespace

QString controlName(gcode::Dialect dialect) {
  switch (dialect) {
    case gcode::Dialect::Sinumerik:
      return QStringLiteral("SINUMERIK");
    case gcode::Dialect::Fanuc:
      return QStringLiteral("FANUC");
    case gcode::Dialect::Haas:
      return QStringLiteral("Haas");
    case gcode::Dialect::LinuxCnc:
      return QStringLiteral("LinuxCNC");
    case gcode::Dialect::Grbl:
      return QStringLiteral("GRBL");
    case gcode::Dialect::FluidNc:
      return QStringLiteral("FluidNC");
    case gcode::Dialect::Heidenhain:
      break;
  }
  return QStringLiteral("HEIDENHAIN");
}

ReadingBar::ReadingBar(QWidget* parent)
    : Page(parent), m_row(new QHBoxLayout), m_values(new QGridLayout) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 4, 12, 4);
  column->addLayout(m_row);
  column->addLayout(m_values);
  m_values->setColumnStretch(0, 1);
  m_row->addWidget(m_icon);
  m_row->addWidget(m_text, 1);
  hide();
  restyle();
}

void ReadingBar::setProgram(std::shared_ptr<const gcode::Program> program) {
  m_program = std::move(program);
  retranslate();
}

void ReadingBar::setAnswerable(bool answerable) {
  m_isAnswerable = answerable;
  for (QPushButton* answer : m_answers) {
    answer->setEnabled(answerable);
  }
  for (const Value& each : m_fields) {
    each.field->setEnabled(answerable);
  }
}

QString ReadingBar::question() const {
  if (!m_program) {
    return {};
  }
  if (const auto& ambiguity = m_program->ambiguity) {
    QStringList ways;
    for (const gcode::Ambiguity::Reading& reading : ambiguity->readings) {
      const QString name = controlName(reading.dialect);
      ways.push_back(reading.endMm ? tr("a %1 goes to %2 mm").arg(name, placeText(*reading.endMm))
                                   : tr("a %1 does not move").arg(name));
    }
    return tr("Nothing shows for which control this program was made. From line %1 on, %2. Which "
              "is it?")
        .arg(QString::number(ambiguity->line.value), ways.join(QStringLiteral("; ")));
  }
  if (const auto sizes = argumentOf(*m_program, DiagnosticCode::UnitsNotSaid)) {
    return tr("The program does not say whether it is in mm or inch. Its size in mm, or in inch: "
              "%1.")
        .arg(*sizes);
  }
  if (const auto sizes = argumentOf(*m_program, DiagnosticCode::NoDecimalPoint)) {
    return tr("Coordinates have no decimal point. Some controls count them in thousandths. The "
              "size as whole units, or as thousandths: %1.")
        .arg(*sizes);
  }
  if (const gcode::ControlSettings open = gcode::openSettings(*m_program); !open.empty()) {
    return tr(
        "The program leaves values to settings of the control. Enter those of the machine, "
        "or take those of a virtual machine.");
  }
  return {};
}

void ReadingBar::addAnswer(const QString& text, std::function<void()> choose) {
  QPushButton* answer = makeTouchButton(this);
  answer->setText(text);
  answer->setEnabled(m_isAnswerable);
  connect(answer, &QPushButton::clicked, this, std::move(choose));
  m_row->addWidget(answer);
  m_answers.push_back(answer);
}

void ReadingBar::addValue(gcode::ControlSetting setting, double value) {
  const QString title = QCoreApplication::translate(
      "ControlSettings", std::string(gcode::settingTitle(setting)).c_str());
  const int row = static_cast<int>(m_fields.size());
  auto* name = new QLabel(title, this);
  auto* field = new QLineEdit(QString::fromStdString(gcode::valueText(setting, value)), this);
  field->setAccessibleName(title);
  field->setMinimumHeight(kTouchHeightPx);
  field->setEnabled(m_isAnswerable);
  field->setVisible(!gcode::hasOneValue(setting));
  name->setBuddy(field);
  m_values->addWidget(name, row, 0, Qt::AlignRight | Qt::AlignVCenter);
  m_values->addWidget(field, row, 1);
  m_fields.push_back({setting, name, field});
}

/// As they stand in the fields; nothing is taken while one of them is no value of its setting.
void ReadingBar::takeValues() {
  gcode::ControlSettings settings;
  for (const Value& each : m_fields) {
    const std::optional<double> value =
        gcode::settingValueOf(each.setting, each.field->text().trimmed().toStdString());
    if (!value) {
      each.field->setFocus();
      each.field->selectAll();
      return;
    }
    settings[each.setting] = *value;
  }
  Q_EMIT settingsChosen(settings);
}

void ReadingBar::makeAnswers() {
  const auto remove = [](QWidget* widget) {
    widget->hide();
    widget->deleteLater();
  };
  std::for_each(m_answers.begin(), m_answers.end(), remove);
  m_answers.clear();
  for (const Value& each : m_fields) {
    remove(each.name);
    remove(each.field);
  }
  m_fields.clear();
  if (!m_program) {
    return;
  }
  if (const auto& ambiguity = m_program->ambiguity) {
    for (const gcode::Ambiguity::Reading& reading : ambiguity->readings) {
      addAnswer(controlName(reading.dialect),
                [this, dialect = reading.dialect] { Q_EMIT dialectChosen(dialect); });
    }
  } else if (argumentOf(*m_program, DiagnosticCode::UnitsNotSaid)) {
    addAnswer(tr("mm"), [this] { Q_EMIT unitsChosen(gcode::FileUnits::Millimetres); });
    addAnswer(tr("inch"), [this] { Q_EMIT unitsChosen(gcode::FileUnits::Inches); });
  } else if (argumentOf(*m_program, DiagnosticCode::NoDecimalPoint)) {
    addAnswer(tr("Whole units"), [this] { Q_EMIT noPointChosen(gcode::NoPoint::Units); });
    addAnswer(tr("Thousandths"), [this] { Q_EMIT noPointChosen(gcode::NoPoint::Increments); });
  } else if (const gcode::ControlSettings open = gcode::openSettings(*m_program); !open.empty()) {
    for (const auto& [setting, value] : open) {
      addValue(setting, value);
    }
    addAnswer(tr("Take them"), [this] { takeValues(); });
  }
}

void ReadingBar::retranslate() {
  const QString text = question();
  m_text->setText(text);
  makeAnswers();
  setVisible(!text.isEmpty());
}

void ReadingBar::restyle() {
  m_icon->setPixmap(iconPixmap(QStringLiteral("status-attention"), themeColors(palette()).attention,
                               24, devicePixelRatioF()));
}

void ReadingBar::paintEvent(QPaintEvent* /*event*/) {
  paintAttentionBar(*this);
}

}  // namespace rivulet::widgets
