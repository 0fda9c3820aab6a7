// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The parts of a page: each is made with what it says and how it looks, and is told again by
/// itself when the language or the theme changes. Texts are those of the sources, marked with
/// QT_TR_NOOP within the class of the page. What depends on a state is not here: the page sets it.
///
///     QPushButton* m_save = button({.text = QT_TR_NOOP("Save"), .icon = "save"}, &MyPage::save);
///
/// @threadsafety GUI thread.
#pragma once

#include <QBoxLayout>
#include <QFormLayout>
#include <QPointer>
#include <QWidget>
#include <functional>
#include <initializer_list>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QGroupBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace rivulet::widgets {

class NumberField;
class StatusLabel;
class WholeNumberField;

struct Part {
  const char* text = nullptr;  ///< of a group: its title
  const char* tip = nullptr;
  const char* name = nullptr;  ///< for a screen reader, where text and label do not say it
  const char* hint = nullptr;  ///< tool tip and name in one
  const char* placeholder = nullptr;
  const char* special = nullptr;        ///< in place of the least number
  const char* suffix = nullptr;         ///< after a number
  std::vector<const char*> items = {};  ///< of a list, or the tabs that are there; in their order
  const char* icon = nullptr;           ///< of resources/icons, in the colour of texts
  const char* id = nullptr;             ///< as an object
  bool isMuted = false;                 ///< secondary text
  bool wraps = false;
  bool isTouch = false;  ///< high enough for a finger; buttons always are
};

/// What a field for numbers takes.
struct Numbers {
  double min = 0.0;
  double max = 0.0;
  int decimals = 3;
  double step = 1.0;
  const char* unit = nullptr;  ///< after a space that does not break
};

class Parts {
 public:
  /// @param owner  parent of what is made, and context of its texts; outlives this
  explicit Parts(QWidget* owner) : m_owner(owner) {}

  QLabel* label(const Part& part = {});
  /// @param buddy  the field that the label belongs to
  QLabel* label(const Part& part, QWidget* buddy);
  /// Bold, over a group.
  QLabel* heading(const Part& part = {});
  /// A value that can be selected and copied.
  QLabel* value(const Part& part = {});
  StatusLabel* status(const Part& part = {});
  QGroupBox* group(const Part& part = {});
  QPushButton* button(const Part& part = {});
  QCheckBox* checkBox(const Part& part = {});
  QComboBox* list(const Part& part = {});
  QLineEdit* lineEdit(const Part& part = {});
  NumberField* number(const Numbers& numbers, const Part& part = {});
  WholeNumberField* whole(int min, int max, const Part& part = {});

  /// A button with what it does. @tparam Page  class of the owner
  template <class Page>
  QPushButton* button(const Part& part, void (Page::*clicked)()) {
    return button(part, [this, clicked] { (static_cast<Page*>(m_owner)->*clicked)(); });
  }
  QPushButton* button(const Part& part, std::function<void()> clicked);
  /// Calls a function when one of these fields, lists, boxes or lines of text is edited.
  template <class Page>
  void onEdit(std::initializer_list<QWidget*> fields, void (Page::*edited)()) {
    onEdit(fields, [this, edited] { (static_cast<Page*>(m_owner)->*edited)(); });
  }
  void onEdit(std::initializer_list<QWidget*> fields, const std::function<void()>& edited);

  /// Gives a widget, action or menu that exists what it says. @return the same
  template <class Object>
  Object* say(Object* object, const Part& part) {
    add(object, part);
    return object;
  }

  /// Says everything again, in the present language.
  void retranslateParts();
  /// Takes the colours of the owner's palette again.
  void restyleParts();

 private:
  struct Said {
    QPointer<QObject> object;
    Part part;
    const char* context;
  };

  void add(QObject* object, const Part& part);
  static void showTexts(const Said& said);
  void showLook(const Said& said) const;

  QWidget* m_owner;
  std::vector<Said> m_said;
};

/// Widgets and layouts side by side, or one above the other.
struct InBox {
  // NOLINTBEGIN(google-explicit-constructor): a list of parts reads as the layout
  InBox(QWidget* part, int share = 0, Qt::Alignment where = {})
      : widget(part), stretch(share), alignment(where) {}
  InBox(QLayout* part, int share = 0) : layout(part), stretch(share) {}
  // NOLINTEND(google-explicit-constructor)

  QWidget* widget = nullptr;
  QLayout* layout = nullptr;
  int stretch = 0;
  Qt::Alignment alignment;
  int gapPx = 0;
};
/// Takes the room that is left.
[[nodiscard]] InBox spring(int share = 0);
[[nodiscard]] InBox gap(int widthPx);

/// @param parent  gets the layout; null: it is put into another one
/// @param margins  nothing: those of the style
QHBoxLayout* inRow(std::initializer_list<InBox> parts, QWidget* parent = nullptr,
                   std::optional<QMargins> margins = std::nullopt);
QVBoxLayout* inColumn(std::initializer_list<InBox> parts, QWidget* parent = nullptr,
                      std::optional<QMargins> margins = std::nullopt);

/// Rows of labels and fields. The form owns the labels: each is the buddy of its field and has its
/// tool tip.
class Form final : public QFormLayout {
 public:
  enum class Height { Text, Touch };  ///< of a label

  /// @param parent  null: the form is put into another layout
  Form(Parts* parts, QWidget* parent, Height height = Height::Text);

  /// @param label  its tip is that of the field, too
  void row(Part label, QWidget* field);
  /// The label of a field, for what depends on a state.
  [[nodiscard]] QLabel* label(QWidget* field) const;
  /// Tool tip of a field and its label.
  void setTip(QWidget* field, const QString& tip);

 private:
  Parts* m_parts;
  Height m_height;
};

}  // namespace rivulet::widgets
