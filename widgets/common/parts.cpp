// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/parts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <utility>

#include "base/contract.h"
#include "widgets/common/icons.h"
#include "widgets/common/number_field.h"
#include "widgets/common/page.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

QLabel* Parts::label(const Part& part) {
  return say(new QLabel(m_owner), part);
}

QLabel* Parts::label(const Part& part, QWidget* buddy) {
  QLabel* made = label(part);
  made->setBuddy(buddy);
  return made;
}

QLabel* Parts::heading(const Part& part) {
  return say(makeHeading(m_owner), part);
}

QLabel* Parts::value(const Part& part) {
  return say(makeValueLabel(m_owner), part);
}

StatusLabel* Parts::status(const Part& part) {
  auto* status = new StatusLabel(m_owner);
  status->setWordWrap(part.wraps);
  return say(status, part);
}

QGroupBox* Parts::group(const Part& part) {
  return say(new QGroupBox(m_owner), part);
}

QPushButton* Parts::button(const Part& part) {
  return say(makeTouchButton(m_owner), part);
}

QPushButton* Parts::button(const Part& part, std::function<void()> clicked) {
  QPushButton* made = button(part);
  QObject::connect(made, &QPushButton::clicked, m_owner, std::move(clicked));
  return made;
}

QCheckBox* Parts::checkBox(const Part& part) {
  return say(new QCheckBox(m_owner), part);
}

QComboBox* Parts::list(const Part& part) {
  return say(new QComboBox(m_owner), part);
}

QLineEdit* Parts::lineEdit(const Part& part) {
  return say(new QLineEdit(m_owner), part);
}

NumberField* Parts::number(const Numbers& numbers, const Part& part) {
  auto* field = new NumberField(m_owner);
  field->setDecimals(numbers.decimals);
  field->setRange(numbers.min, numbers.max);
  field->setSingleStep(numbers.step);
  if (numbers.unit != nullptr) {
    field->setSuffix(QChar(0x00A0) + QString::fromUtf8(numbers.unit));
  }
  return say(field, part);
}

WholeNumberField* Parts::whole(int min, int max, const Part& part) {
  auto* field = new WholeNumberField(m_owner);
  field->setRange(min, max);
  return say(field, part);
}

void Parts::onEdit(std::initializer_list<QWidget*> fields, const std::function<void()>& edited) {
  for (QWidget* field : fields) {
    if (auto* list = qobject_cast<QComboBox*>(field)) {
      QObject::connect(list, &QComboBox::currentIndexChanged, m_owner, edited);
    } else if (auto* number = qobject_cast<QDoubleSpinBox*>(field)) {
      QObject::connect(number, &QDoubleSpinBox::valueChanged, m_owner, edited);
    } else if (auto* whole = qobject_cast<QSpinBox*>(field)) {
      QObject::connect(whole, &QSpinBox::valueChanged, m_owner, edited);
    } else if (auto* box = qobject_cast<QAbstractButton*>(field)) {
      QObject::connect(box, &QAbstractButton::toggled, m_owner, edited);
    } else if (auto* group = qobject_cast<QGroupBox*>(field)) {
      QObject::connect(group, &QGroupBox::toggled, m_owner, edited);
    } else if (auto* line = qobject_cast<QLineEdit*>(field)) {
      QObject::connect(line, &QLineEdit::textEdited, m_owner, edited);
    } else {
      RIVULET_ASSERT(false);
    }
  }
}

void Parts::add(QObject* object, const Part& part) {
  if (part.id != nullptr) {
    object->setObjectName(QLatin1String(part.id));
  }
  if (auto* list = qobject_cast<QComboBox*>(object)) {
    for (std::size_t i = 0; i < part.items.size(); ++i) {
      list->addItem(QString());
    }
  }
  auto* widget = qobject_cast<QWidget*>(object);
  if (part.isTouch) {
    widget->setMinimumHeight(kTouchHeightPx);
  }
  if (auto* label = qobject_cast<QLabel*>(object); label != nullptr && part.wraps) {
    label->setWordWrap(true);
  }
  m_said.push_back({object, part, m_owner->metaObject()->className()});
  showTexts(m_said.back());
  showLook(m_said.back());
}

void Parts::showTexts(const Said& said) {
  QObject& object = *said.object;
  const auto set = [&](const char* property, const char* source) {
    if (source != nullptr) {
      const bool isThere =
          object.setProperty(property, QCoreApplication::translate(said.context, source));
      RIVULET_ASSERT(isThere);
    }
  };
  const bool hasTitle = object.metaObject()->indexOfProperty("title") >= 0;
  set(hasTitle ? "title" : "text", said.part.text);
  set("toolTip", said.part.tip);
  set("accessibleName", said.part.name);
  set("toolTip", said.part.hint);
  set("accessibleName", said.part.hint);
  set("placeholderText", said.part.placeholder);
  set("specialValueText", said.part.special);
  set("suffix", said.part.suffix);
  for (std::size_t i = 0; i < said.part.items.size(); ++i) {
    const int at = static_cast<int>(i);
    const QString item = QCoreApplication::translate(said.context, said.part.items[i]);
    if (auto* list = qobject_cast<QComboBox*>(&object)) {
      list->setItemText(at, item);
    } else if (auto* tabs = qobject_cast<QTabWidget*>(&object)) {
      tabs->setTabText(at, item);
    }
  }
}

void Parts::showLook(const Said& said) const {
  if (said.part.icon != nullptr) {
    const QIcon icon =
        themedIcon(QLatin1String(said.part.icon), themeColors(m_owner->palette()).text);
    said.object->setProperty("icon", icon);
  }
  if (said.part.isMuted) {
    setMuted(qobject_cast<QWidget*>(said.object), m_owner->palette());
  }
}

void Parts::retranslateParts() {
  for (const Said& said : m_said) {
    if (said.object) {
      showTexts(said);
    }
  }
}

void Parts::restyleParts() {
  for (const Said& said : m_said) {
    if (said.object) {
      showLook(said);
    }
  }
}

namespace {

template <class Layout>
Layout* boxOf(std::initializer_list<InBox> parts, QWidget* parent,
              std::optional<QMargins> margins) {
  auto* layout = new Layout(parent);
  if (margins) {
    layout->setContentsMargins(*margins);
  }
  for (const InBox& part : parts) {
    if (part.widget != nullptr) {
      layout->addWidget(part.widget, part.stretch, part.alignment);
    } else if (part.layout != nullptr) {
      layout->addLayout(part.layout, part.stretch);
    } else if (part.gapPx > 0) {
      layout->addSpacing(part.gapPx);
    } else {
      layout->addStretch(part.stretch);
    }
  }
  return layout;
}

}  // namespace

InBox spring(int share) {
  return {static_cast<QWidget*>(nullptr), share};
}

InBox gap(int widthPx) {
  InBox box = spring();
  box.gapPx = widthPx;
  return box;
}

QHBoxLayout* inRow(std::initializer_list<InBox> parts, QWidget* parent,
                   std::optional<QMargins> margins) {
  return boxOf<QHBoxLayout>(parts, parent, margins);
}

QVBoxLayout* inColumn(std::initializer_list<InBox> parts, QWidget* parent,
                      std::optional<QMargins> margins) {
  return boxOf<QVBoxLayout>(parts, parent, margins);
}

Form::Form(Parts* parts, QWidget* parent, Height height)
    : QFormLayout(parent), m_parts(parts), m_height(height) {
  setLabelAlignment(Qt::AlignLeft);
  setHorizontalSpacing(16);
  setRowWrapPolicy(QFormLayout::WrapLongRows);
}

void Form::row(Part label, QWidget* field) {
  label.isTouch = m_height == Height::Touch;
  if (label.tip != nullptr) {
    m_parts->say(field, {.tip = label.tip});
  }
  addRow(m_parts->label(label, field), field);
}

QLabel* Form::label(QWidget* field) const {
  return static_cast<QLabel*>(labelForField(field));
}

void Form::setTip(QWidget* field, const QString& tip) {
  field->setToolTip(tip);
  label(field)->setToolTip(tip);
}

}  // namespace rivulet::widgets
