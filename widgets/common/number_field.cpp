// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/number_field.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>

#include "widgets/common/number_format.h"

namespace rivulet::widgets {

namespace {

constexpr int kGroupDigits = 3;

bool isSeparator(QChar character) {
  return character == QLatin1Char('.') || character == QLatin1Char(',');
}

QChar decimalPointOf(const QLocale& locale) {
  const QString point = locale.decimalPoint();
  return point.isEmpty() ? QChar(QLatin1Char('.')) : point.front();
}

}  // namespace

TypedNumber parseTyped(const QString& text, QChar decimalPoint) {
  QString number = text.trimmed();
  number.replace(QChar(0x2212), QLatin1Char('-'));
  qsizetype at = -1;
  for (qsizetype i = 0; i < number.size(); ++i) {
    if (isSeparator(number[i])) {
      if (at >= 0) {
        return {0.0, NumberProblem::Grouped};
      }
      at = i;
    }
  }
  if (at >= 0) {
    QString before = number.left(at);
    before.remove(QLatin1Char('-'));
    const bool looksGrouped = number.size() - at - 1 == kGroupDigits && !before.isEmpty() &&
                              before.size() <= kGroupDigits && !before.startsWith(QLatin1Char('0'));
    if (looksGrouped && number[at] != decimalPoint) {
      return {0.0, NumberProblem::Ambiguous};
    }
    number[at] = QLatin1Char('.');
  }
  bool isNumber = false;
  const double value = QLocale::c().toDouble(number, &isNumber);
  return isNumber && !number.contains(QLatin1Char('e'), Qt::CaseInsensitive)
             ? TypedNumber{value, NumberProblem::None}
             : TypedNumber{0.0, NumberProblem::NotANumber};
}

NumberField::NumberField(QWidget* parent) : QDoubleSpinBox(parent) {
  setKeyboardTracking(false);  // half a number is not a value
  setGroupSeparatorShown(false);
  setCorrectionMode(QAbstractSpinBox::CorrectToPreviousValue);
  setFocusPolicy(Qt::StrongFocus);
}

QString NumberField::typed(QString text) const {
  if (!suffix().isEmpty() && text.endsWith(suffix())) {
    text.chop(suffix().size());
  }
  return text.trimmed();
}

QValidator::State NumberField::validate(QString& text, int& /*position*/) const {
  if (!specialValueText().isEmpty() && text == specialValueText()) {
    return QValidator::Acceptable;
  }
  const QString number = typed(text);
  const TypedNumber parsed = parseTyped(number, decimalPointOf(locale()));
  if (parsed.problem == NumberProblem::None && parsed.value >= minimum() &&
      parsed.value <= maximum()) {
    return QValidator::Acceptable;
  }
  for (const QChar character : number) {
    const bool isPart = character.isDigit() || isSeparator(character) ||
                        character == QLatin1Char('-') || character == QChar(0x2212);
    if (!isPart) {
      return QValidator::Invalid;
    }
  }
  return QValidator::Intermediate;  // to be refused with a sentence, not by a dead key
}

double NumberField::valueFromText(const QString& text) const {
  if (!specialValueText().isEmpty() && text == specialValueText()) {
    return minimum();
  }
  return parseTyped(typed(text), decimalPointOf(locale())).value;
}

QString NumberField::textFromValue(double value) const {
  QLocale plain = locale();
  plain.setNumberOptions(QLocale::OmitGroupSeparator);
  return plain.toString(value, 'f', decimals());
}

std::optional<QString> NumberField::refusal() const {
  QString text = lineEdit()->text();
  int position = 0;
  if (validate(text, position) == QValidator::Acceptable) {
    return std::nullopt;
  }
  const QString number = typed(text);
  const TypedNumber parsed = parseTyped(number, decimalPointOf(locale()));
  switch (parsed.problem) {
    case NumberProblem::Ambiguous:
      return tr("%1 can be read in two ways. Type it without a separator between thousands, or "
                "with %2 before the decimals.")
          .arg(number, decimalPointOf(locale()));
    case NumberProblem::Grouped:
      return tr("%1 has more than one separator. Type it without separators between thousands.")
          .arg(number);
    case NumberProblem::NotANumber:
      return number.isEmpty() ? tr("The field was empty.") : tr("%1 is not a number.").arg(number);
    case NumberProblem::None:
      break;
  }
  return tr("%1 is out of range: %2 to %3.")
      .arg(number, textFromValue(minimum()), textFromValue(maximum()));
}

void NumberField::complain() {
  if (const std::optional<QString> reason = refusal()) {
    Q_EMIT refused(tr("%1 The value stays %2.").arg(*reason, textFromValue(value()) + suffix()));
  }
}

void NumberField::focusOutEvent(QFocusEvent* event) {
  complain();
  QDoubleSpinBox::focusOutEvent(event);
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    complain();
  }
  QDoubleSpinBox::keyPressEvent(event);
}

}  // namespace rivulet::widgets
