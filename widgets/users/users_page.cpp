// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/users/users_page.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QToolButton>
#include <array>

#include "widgets/audit/audit_page.h"
#include "widgets/common/icons.h"
#include "widgets/common/table_style.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

constexpr std::array kRoles{permission::Role::Operator, permission::Role::Engineer};
constexpr int kIdleMinutesMax = 480;
constexpr int kKeyPx = 64;

}  // namespace

UserButton::UserButton(QWidget* parent)
    : Page(parent), m_button(say(new QToolButton(this), {.isTouch = true})) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_button);
  m_button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  m_button->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_L));
  connect(m_button, &QToolButton::clicked, this, [this] {
    if (m_view.isLocked) {
      Q_EMIT logInRequested();
    } else {
      Q_EMIT lockRequested();
    }
  });
  retranslate();
  restyle();
}

void UserButton::setUsers(const UsersView& view) {
  m_view = view;
  retranslate();
  restyle();
}

void UserButton::retranslate() {
  setVisible(m_view.isSetUp());
  m_button->setText(m_view.isLocked ? tr("Locked: log in")
                                    : tr("%1, %2").arg(m_view.current, roleText(m_view.role)));
  const QString toolTip = m_view.isLocked
                              ? tr("Only Stop works. Log in with your PIN (Ctrl+L).")
                              : tr("Lock the window, or let somebody else in (Ctrl+L).");
  m_button->setToolTip(toolTip);
  m_button->setAccessibleName(m_button->text());
}

void UserButton::restyle() {
  const ThemeColors& colors = themeColors(palette());
  m_button->setIcon(themedIcon(m_view.isLocked ? QStringLiteral("locked") : QStringLiteral("user"),
                               m_view.isLocked ? colors.attention : colors.text));
}

LogInDialog::LogInDialog(const UsersView& view, QWidget* parent)
    : QDialog(parent),
      m_name(new QComboBox(this)),
      m_pin(new QLineEdit(this)),
      m_answer(new QLabel(this)),
      m_logIn(makeTouchButton(this)) {
  setWindowTitle(tr("Log in"));
  for (const UserRow& user : view.users) {
    m_name->addItem(user.name);
  }
  m_name->setMinimumHeight(kTouchHeightPx);
  m_name->setAccessibleName(tr("User"));
  m_pin->setMinimumHeight(kTouchHeightPx);
  m_pin->setEchoMode(QLineEdit::Password);
  m_pin->setPlaceholderText(tr("PIN"));
  m_pin->setAccessibleName(tr("PIN"));
  m_answer->setWordWrap(true);
  m_logIn->setText(tr("Log in"));
  m_logIn->setDefault(true);

  auto* keys = new QGridLayout;
  const auto addKey = [this, keys](const QString& text, int row, int column) {
    auto* key = new QPushButton(text, this);
    key->setMinimumSize(kKeyPx, kKeyPx);
    key->setAutoDefault(false);
    key->setFocusPolicy(Qt::NoFocus);
    keys->addWidget(key, row, column);
    return key;
  };
  for (int digit = 1; digit <= 10; ++digit) {
    const QString text = QString::number(digit % 10);
    const int row = digit == 10 ? 3 : (digit - 1) / 3;
    const int column = digit == 10 ? 1 : (digit - 1) % 3;
    connect(addKey(text, row, column), &QPushButton::clicked, this,
            [this, text] { m_pin->insert(text); });
  }
  QPushButton* back = addKey(QStringLiteral("⌫"), 3, 2);
  back->setAccessibleName(tr("Delete the last digit"));
  connect(back, &QPushButton::clicked, m_pin, &QLineEdit::backspace);

  inColumn({m_name, m_pin, keys, m_answer, m_logIn}, this);
  connect(m_logIn, &QPushButton::clicked, this, &LogInDialog::tryPin);
  connect(m_name, &QComboBox::currentIndexChanged, m_pin, &QLineEdit::clear);
  m_pin->setFocus();
}

void LogInDialog::tryPin() {
  m_logIn->setEnabled(false);
  m_answer->clear();
  Q_EMIT logInRequested(m_name->currentText(), m_pin->text());
}

void LogInDialog::showFailure(int waitS) {
  m_logIn->setEnabled(true);
  m_pin->clear();
  m_pin->setFocus();
  m_answer->setText(waitS > 0 ? tr("Wrong PIN. Try again in %1 s.").arg(waitS) : tr("Wrong PIN."));
}

UserModel::UserModel(QObject* parent)
    : TableModel(
          {{[] { return tr("Name"); }, [](const UserRow& user) { return user.name; }},
           {[] { return tr("Role"); }, [](const UserRow& user) { return roleText(user.role); }},
           {[] { return tr("PIN"); },
            [](const UserRow& user) {
              return user.hasPin ? tr("set") : tr("none: user of this computer");
            }}},
          parent) {
}

UsersPage::UsersPage(QWidget* parent)
    : Page(parent),
      m_model(new UserModel(this)),
      m_table(say(new QTableView(this), {.name = QT_TR_NOOP("Users")})),
      m_form(makeForm()) {
  m_table->setModel(m_model);
  styleTable(m_table);
  m_table->setColumnWidth(UserModel::Name, 220);
  m_table->setColumnWidth(UserModel::RoleColumn, 160);
  m_table->horizontalHeader()->setStretchLastSection(true);
  inColumn({m_state, {m_table, 1}, m_form}, this);
  connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& index) {
            if (index.isValid()) {
              const UserRow& user = m_model->row(index.row());
              m_name->setText(user.name);
              m_role->setCurrentIndex(user.role == permission::Role::Operator ? 0 : 1);
            }
          });
  retranslate();
}

QWidget* UsersPage::makeForm() {
  auto* form = new QWidget(this);
  m_name = lineEdit({.name = QT_TR_NOOP("Name")});
  m_role = list({.name = QT_TR_NOOP("Role")});
  m_pin = lineEdit({.name = QT_TR_NOOP("PIN, at least 4 characters")});
  m_put = button({.text = QT_TR_NOOP("Add or change")});
  m_remove = button({.text = QT_TR_NOOP("Remove")});
  m_idle =
      say(new QSpinBox(form), {.name = QT_TR_NOOP("Lock the window if nobody touches it for"),
                               .special = QT_TR_NOOP("never"),
                               .suffix = QT_TR_NOOP(" min")});  // the focus goes the way one reads
  m_answer = label({.wraps = true});
  m_role->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  m_pin->setEchoMode(QLineEdit::Password);
  m_idle->setRange(0, kIdleMinutesMax);
  m_idle->setKeyboardTracking(false);
  auto* grid = new QGridLayout(form);
  grid->setContentsMargins(0, 8, 0, 0);
  grid->setHorizontalSpacing(4);
  grid->addWidget(label({.text = QT_TR_NOOP("Name"), .isMuted = true}), 0, 0);
  grid->addWidget(m_name, 1, 0);
  grid->addWidget(label({.text = QT_TR_NOOP("Role"), .isMuted = true}), 0, 1);
  grid->addWidget(m_role, 1, 1);
  grid->addWidget(
      label({.text = QT_TR_NOOP("PIN, at least 4 characters"), .isMuted = true, .wraps = true}), 0,
      2);
  grid->addWidget(m_pin, 1, 2);
  grid->addWidget(m_put, 1, 3);
  grid->addWidget(m_remove, 1, 4);
  grid->addWidget(m_answer, 2, 0, 1, 5);
  grid->addWidget(label({.text = QT_TR_NOOP("Lock the window if nobody touches it for")}), 3, 0, 1,
                  2);
  grid->addWidget(m_idle, 3, 2);
  grid->setColumnStretch(0, 2);
  grid->setColumnStretch(2, 1);
  for (QWidget* field : std::initializer_list<QWidget*>{m_name, m_role, m_pin, m_idle}) {
    field->setMinimumHeight(kTouchHeightPx);
  }
  connect(m_put, &QPushButton::clicked, this, [this] {
    Q_EMIT putRequested(m_name->text(),
                        kRoles[static_cast<std::size_t>(std::max(0, m_role->currentIndex()))],
                        m_pin->text());
  });
  connect(m_remove, &QPushButton::clicked, this,
          [this] { Q_EMIT removeRequested(m_name->text()); });
  connect(m_idle, &QSpinBox::valueChanged, this, &UsersPage::idleMinutesRequested);
  return form;
}

void UsersPage::setUsers(const UsersView& view, bool mayChange) {
  m_view = view;
  m_mayChange = mayChange;
  m_model->setRows(view.users);
  const QSignalBlocker quiet(m_idle);
  m_idle->setValue(view.idleMinutes);
  showState();
}

void UsersPage::showAnswer(const QString& text) {
  m_answer->setText(text);
  m_pin->clear();
}

void UsersPage::showState() {
  m_form->setEnabled(m_mayChange);
  m_remove->setEnabled(m_view.isSetUp());
  m_role->setEnabled(m_view.isSetUp());
  if (!m_view.isSetUp()) {
    m_role->setCurrentIndex(1);
    m_state->setText(tr(
        "No users are set up: everybody at this window may do everything. To let operators start "
        "only what is released, add an engineer (name and PIN), then the operators."));
  } else {
    m_state->setText(
        tr("An operator starts what an engineer has released in the preflight, holds, stops and "
           "acknowledges. An engineer may do everything. In a locked window only Stop works. The "
           "user of this computer (%1) needs no PIN.")
            .arg(m_view.systemUser));
  }
}

void UsersPage::retranslate() {
  const int chosen = std::max(0, m_role->currentIndex());
  m_role->clear();
  for (const permission::Role role : kRoles) {
    m_role->addItem(roleText(role));
  }
  m_role->setCurrentIndex(chosen);
  m_model->refresh();
  showState();
}

}  // namespace rivulet::widgets
