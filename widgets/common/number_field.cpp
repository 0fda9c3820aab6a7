// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/number_field.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <algorithm>

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

TypedNumber parseTypedWhole(const QString& text, QChar decimalPoint) {
  const TypedNumber number = parseTyped(text, decimalPoint);
  const bool hasSeparator = std::any_of(text.begin(), text.end(), isSeparator);
  // "1.200" of a language with decimal points is 1.2 there and 1200 elsewhere.
  return number.problem == NumberProblem::None && hasSeparator
             ? TypedNumber{0.0, NumberProblem::NotWhole}
             : number;
}

namespace {

using Parse = TypedNumber (*)(const QString& text, QChar decimalPoint);

/// What both kinds of fields do with a text.
struct FieldText {
  Q_DECLARE_TR_FUNCTIONS(rivulet::widgets::NumberField)

 public:
  Parse parse;
  const QAbstractSpinBox& field;
  QString suffix;
  double minimum;
  double maximum;

  [[nodiscard]] QString typed(QString text) const {
    if (!suffix.isEmpty() && text.endsWith(suffix)) {
      text.chop(suffix.size());
    }
    return text.trimmed();
  }
  [[nodiscard]] TypedNumber read(const QString& text) const {
    return parse(typed(text), decimalPointOf(field.locale()));
  }
  [[nodiscard]] bool isSpecial(const QString& text) const {
    return !field.specialValueText().isEmpty() && text == field.specialValueText();
  }
  [[nodiscard]] QValidator::State validate(const QString& text) const {
    const TypedNumber parsed = read(text);
    if (isSpecial(text) || (parsed.problem == NumberProblem::None && parsed.value >= minimum &&
                            parsed.value <= maximum)) {
      return QValidator::Acceptable;
    }
    const QString number = typed(text);
    const bool isNumber = std::all_of(number.begin(), number.end(), [](QChar character) {
      return character.isDigit() || isSeparator(character) || character == QLatin1Char('-') ||
             character == QChar(0x2212);
    });
    // To be refused with a sentence, not by a dead key.
    return isNumber ? QValidator::Intermediate : QValidator::Invalid;
  }
  /// Why the text does not count; nothing: it does. @param show  a value as the field shows it
  template <class Show>
  [[nodiscard]] std::optional<QString> refusal(const QString& text, const Show& show) const {
    if (validate(text) == QValidator::Acceptable) {
      return std::nullopt;
    }
    const QString number = typed(text);
    switch (read(text).problem) {
      case NumberProblem::Ambiguous:
        return tr("%1 can be read in two ways. Type it without a separator between thousands, or "
                  "with %2 before the decimals.")
            .arg(number, decimalPointOf(field.locale()));
      case NumberProblem::Grouped:
        return tr("%1 has more than one separator. Type it without separators between thousands.")
            .arg(number);
      case NumberProblem::NotWhole:
        return tr("%1 is not a whole number. Type it without separators.").arg(number);
      case NumberProblem::NotANumber:
        return number.isEmpty() ? tr("The field was empty.")
                                : tr("%1 is not a number.").arg(number);
      case NumberProblem::None:
        break;
    }
    return tr("%1 is out of range: %2 to %3.").arg(number, show(minimum), show(maximum));
  }
  [[nodiscard]] static QString withValue(const QString& reason, const QString& value) {
    return tr("%1 The value stays %2.").arg(reason, value);
  }
};

void setUpTyping(QAbstractSpinBox& field) {
  field.setKeyboardTracking(false);  // half a number is not a value
  field.setGroupSeparatorShown(false);
  field.setCorrectionMode(QAbstractSpinBox::CorrectToPreviousValue);
  field.setFocusPolicy(Qt::StrongFocus);
}

FieldText textOf(const QDoubleSpinBox& field) {
  return {&parseTyped, field, field.suffix(), field.minimum(), field.maximum()};
}

FieldText textOf(const QSpinBox& field) {
  return {&parseTypedWhole, field, field.suffix(), static_cast<double>(field.minimum()),
          static_cast<double>(field.maximum())};
}

bool isEnter(const QKeyEvent& event) {
  return event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
}

}  // namespace

template <class Box>
TypedSpinBox<Box>::TypedSpinBox(QWidget* parent) : Box(parent) {
  setUpTyping(*this);
}

template <class Box>
QValidator::State TypedSpinBox<Box>::validate(QString& text, int& /*position*/) const {
  return textOf(*this).validate(text);
}

template <class Box>
void TypedSpinBox<Box>::complain() {
  using Value = decltype(this->value());
  const auto show = [this](double value) { return this->textFromValue(static_cast<Value>(value)); };
  if (const auto reason = textOf(*this).refusal(this->lineEdit()->text(), show)) {
    refuse(FieldText::withValue(*reason, this->textFromValue(this->value()) + this->suffix()));
  }
}

template <class Box>
void TypedSpinBox<Box>::focusOutEvent(QFocusEvent* event) {
  complain();
  Box::focusOutEvent(event);
}

template <class Box>
void TypedSpinBox<Box>::keyPressEvent(QKeyEvent* event) {
  if (isEnter(*event)) {
    complain();
  }
  Box::keyPressEvent(event);
}

template class TypedSpinBox<QDoubleSpinBox>;
template class TypedSpinBox<QSpinBox>;

double NumberField::valueFromText(const QString& text) const {
  const FieldText field = textOf(*this);
  return field.isSpecial(text) ? minimum() : field.read(text).value;
}

QString NumberField::textFromValue(double value) const {
  QLocale plain = locale();
  plain.setNumberOptions(QLocale::OmitGroupSeparator);
  return plain.toString(value, 'f', decimals());
}

int WholeNumberField::valueFromText(const QString& text) const {
  const FieldText field = textOf(*this);
  // Also asked for what does not count.
  const double value = std::clamp(field.read(text).value, static_cast<double>(minimum()),
                                  static_cast<double>(maximum()));
  return field.isSpecial(text) ? minimum() : static_cast<int>(value);
}

QString WholeNumberField::textFromValue(int value) const {
  return QString::number(value);
}

}  // namespace rivulet::widgets
