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

UserButton::UserButton(QWidget* parent) : Page(parent), m_button(new QToolButton(this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_button);
  m_button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  m_button->setMinimumHeight(kTouchHeightPx);
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

  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_name);
  layout->addWidget(m_pin);
  layout->addLayout(keys);
  layout->addWidget(m_answer);
  layout->addWidget(m_logIn);
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
      m_state(new QLabel(this)),
      m_table(new QTableView(this)),
      m_form(makeForm()) {
  m_state->setWordWrap(true);
  m_table->setModel(m_model);
  styleTable(m_table);
  m_table->setColumnWidth(UserModel::Name, 220);
  m_table->setColumnWidth(UserModel::RoleColumn, 160);
  m_table->horizontalHeader()->setStretchLastSection(true);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_state);
  layout->addWidget(m_table, 1);
  layout->addWidget(m_form);
  connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& index) {
            if (index.isValid()) {
              const UserRow& user = m_model->row(index.row());
              m_name->setText(user.name);
              m_role->setCurrentIndex(user.role == permission::Role::Operator ? 0 : 1);
            }
          });
  retranslate();
  restyle();
}

QWidget* UsersPage::makeForm() {
  auto* form = new QWidget(this);
  m_nameTitle = new QLabel(form);
  m_roleTitle = new QLabel(form);
  m_pinTitle = new QLabel(form);
  m_idleTitle = new QLabel(form);
  m_name = new QLineEdit(form);
  m_role = new QComboBox(form);
  m_pin = new QLineEdit(form);
  m_put = makeTouchButton(form);
  m_remove = makeTouchButton(form);
  m_idle = new QSpinBox(form);  // the focus goes the way one reads
  m_answer = new QLabel(form);
  m_answer->setWordWrap(true);
  m_role->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  m_pinTitle->setWordWrap(true);
  m_pin->setEchoMode(QLineEdit::Password);
  m_idle->setRange(0, kIdleMinutesMax);
  m_idle->setKeyboardTracking(false);
  auto* grid = new QGridLayout(form);
  grid->setContentsMargins(0, 8, 0, 0);
  grid->setHorizontalSpacing(4);
  grid->addWidget(m_nameTitle, 0, 0);
  grid->addWidget(m_name, 1, 0);
  grid->addWidget(m_roleTitle, 0, 1);
  grid->addWidget(m_role, 1, 1);
  grid->addWidget(m_pinTitle, 0, 2);
  grid->addWidget(m_pin, 1, 2);
  grid->addWidget(m_put, 1, 3);
  grid->addWidget(m_remove, 1, 4);
  grid->addWidget(m_answer, 2, 0, 1, 5);
  grid->addWidget(m_idleTitle, 3, 0, 1, 2);
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
  m_nameTitle->setText(tr("Name"));
  m_roleTitle->setText(tr("Role"));
  m_pinTitle->setText(tr("PIN, at least 4 characters"));
  m_idleTitle->setText(tr("Lock the window if nobody touches it for"));
  m_name->setAccessibleName(tr("Name"));
  m_role->setAccessibleName(tr("Role"));
  m_pin->setAccessibleName(tr("PIN, at least 4 characters"));
  m_idle->setAccessibleName(tr("Lock the window if nobody touches it for"));
  m_idle->setSpecialValueText(tr("never"));
  m_idle->setSuffix(tr(" min"));
  m_put->setText(tr("Add or change"));
  m_remove->setText(tr("Remove"));
  const int chosen = std::max(0, m_role->currentIndex());
  m_role->clear();
  for (const permission::Role role : kRoles) {
    m_role->addItem(roleText(role));
  }
  m_role->setCurrentIndex(chosen);
  m_table->setAccessibleName(tr("Users"));
  m_model->refresh();
  showState();
}

void UsersPage::restyle() {
  for (QLabel* label : {m_nameTitle, m_roleTitle, m_pinTitle}) {
    setMuted(label, palette());
  }
}

}  // namespace rivulet::widgets
