// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Fields for numbers that are typed. Point and comma are both decimal separators, in every
/// language; there are no group separators. What could be read in two ways is refused, with a
/// sentence, and so is what is out of range: nothing is silently made into another number. A value
/// counts when Enter is pressed or the field is left.
/// @threadsafety GUI thread.
#pragma once

#include <QDoubleSpinBox>
#include <QSpinBox>
#include <functional>
#include <optional>

namespace rivulet::widgets {

enum class NumberProblem {
  None,
  NotANumber,
  NotWhole,   ///< decimals where a whole number is wanted
  Ambiguous,  ///< "1,200" where the decimal separator is a point: 1.2 or 1200
  Grouped,    ///< more than one separator
};

struct TypedNumber {
  double value = 0.0;  ///< if there is no problem
  NumberProblem problem = NumberProblem::None;
};

/// @param decimalPoint  of the language: its own separator is never ambiguous
[[nodiscard]] TypedNumber parseTyped(const QString& text, QChar decimalPoint);
/// The same for a whole number: it has no separators, and one with decimals is NotWhole.
[[nodiscard]] TypedNumber parseTypedWhole(const QString& text, QChar decimalPoint);

/// What the two fields have in common. @tparam Box  QDoubleSpinBox or QSpinBox
template <class Box>
class TypedSpinBox : public Box {
 public:
  explicit TypedSpinBox(QWidget* parent = nullptr);

  [[nodiscard]] QValidator::State validate(QString& text, int& position) const override;
  /// Does not repair what was typed: the base class would take separators out.
  void fixup(QString& /*text*/) const override {}

 protected:
  void focusOutEvent(QFocusEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void complain();
  /// What was typed does not count; the field has its former value. @param reason  a sentence
  virtual void refuse(const QString& reason) = 0;
};

class NumberField final : public TypedSpinBox<QDoubleSpinBox> {
  Q_OBJECT

 public:
  using TypedSpinBox::TypedSpinBox;

  [[nodiscard]] double valueFromText(const QString& text) const override;
  [[nodiscard]] QString textFromValue(double value) const override;

 Q_SIGNALS:
  /// See `TypedSpinBox::refuse`.
  void refused(const QString& reason);

 private:
  void refuse(const QString& reason) override { Q_EMIT refused(reason); }
};

/// The same for whole numbers.
class WholeNumberField final : public TypedSpinBox<QSpinBox> {
  Q_OBJECT

 public:
  using TypedSpinBox::TypedSpinBox;

  [[nodiscard]] int valueFromText(const QString& text) const override;
  [[nodiscard]] QString textFromValue(int value) const override;

 Q_SIGNALS:
  void refused(const QString& reason);

 private:
  void refuse(const QString& reason) override { Q_EMIT refused(reason); }
};

}  // namespace rivulet::widgets
