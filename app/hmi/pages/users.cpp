// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Who works at the window and what they did: users, the lock, the audit trail.

#include <QPointer>

#include "hmi/audit.h"
#include "hmi/messages.h"
#include "hmi/pages/pages.h"
#include "hmi/users.h"
#include "widgets/audit/audit_page.h"
#include "widgets/common/error_text.h"
#include "widgets/common/sheet_area.h"
#include "widgets/users/users_page.h"

namespace rivulet::hmi {

using permission::Act;

namespace {

widgets::UsersView viewOf(const Users& users) {
  widgets::UsersView view;
  for (const User& user : users.users()) {
    view.users.push_back({user.name, user.role, user.hasPin()});
  }
  view.current = users.name();
  view.role = users.standing().role;
  view.isLocked = users.isLocked();
  view.idleMinutes = users.idleMinutes();
  view.systemUser = users.systemUser();
  return view;
}

widgets::AuditView viewOf(const journal::AuditContent& content, const std::filesystem::path& file) {
  widgets::AuditView view;
  for (const journal::AuditContent::Line& line : content.lines) {
    const journal::AuditEntry& entry = line.entry;
    QStringList details;
    for (const auto& [name, value] : entry.details) {
      details << QString::fromStdString(name + "=" + value);
    }
    view.rows.push_back({line.number, entry.at, QString::fromStdString(entry.who),
                         QString::fromStdString(entry.role), QString::fromStdString(entry.act),
                         details.join(QStringLiteral("; ")), false});
  }
  for (const journal::AuditFinding& finding : content.findings) {
    view.cutLines += finding.fault == journal::AuditFault::NotALine ? 1 : 0;
    for (widgets::AuditRow& row : view.rows) {
      row.isSuspect = row.isSuspect ||
                      (row.line == finding.line && finding.fault != journal::AuditFault::NotALine);
    }
  }
  view.firstChange = content.firstChange();
  view.lastHash = QString::fromStdString(content.lastHash);
  view.file = QString::fromStdString(file.string());
  return view;
}

void askForPin(Users* users, QWidget* parent) {
  auto* dialog = new widgets::LogInDialog(viewOf(*users), nullptr);
  QObject::connect(dialog, &widgets::LogInDialog::logInRequested, users, &Users::logIn);
  QObject::connect(users, &Users::loggedIn, dialog, &QDialog::accept);
  QObject::connect(users, &Users::logInFailed, dialog,
                   [dialog](const QString&, int waitS) { dialog->showFailure(waitS); });
  widgets::openSheet(dialog, parent);
}

}  // namespace

QWidget* makeUserButton(Users* users, QWidget* parent) {
  auto* button = new widgets::UserButton(parent);
  const auto show = [button, users] { button->setUsers(viewOf(*users)); };
  show();
  QObject::connect(users, &Users::changed, button, show);
  QObject::connect(button, &widgets::UserButton::lockRequested, users, &Users::lock);
  QObject::connect(button, &widgets::UserButton::logInRequested, button,
                   [button, users] { askForPin(users, button); });
  return button;
}

QWidget* makeUsersPage(Messages* messages, Users* users, QWidget* parent) {
  auto* page = new widgets::UsersPage(parent);
  const auto show = [page, users] {
    page->setUsers(viewOf(*users), !users->refusal(Act::SetUpUsers));
  };
  show();
  QObject::connect(users, &Users::changed, page, show);
  const auto answer = [shown = QPointer<widgets::UsersPage>(page), messages](
                          const base::Result<void>& done, const QString& name,
                          const std::string& what) {
    if (shown) {
      shown->showAnswer(done ? QString() : userErrorText(done.error()));
    }
    if (done) {
      messages->didAct(Act::SetUpUsers, {{"user", name.toStdString()}, {"change", what}});
    }
  };
  QObject::connect(page, &widgets::UsersPage::putRequested, page,
                   [answer, users](const QString& name, permission::Role role, const QString& pin) {
                     if (!users->refusal(Act::SetUpUsers)) {
                       users->put(name, role, pin,
                                  [answer, name, role](const base::Result<void>& done) {
                                    answer(done, name, std::string(permission::roleName(role)));
                                  });
                     }
                   });
  QObject::connect(page, &widgets::UsersPage::removeRequested, page,
                   [answer, users](const QString& name) {
                     if (!users->refusal(Act::SetUpUsers)) {
                       answer(users->remove(name), name, "removed");
                     }
                   });
  QObject::connect(
      page, &widgets::UsersPage::idleMinutesRequested, page, [messages, users](int minutes) {
        if (!users->refusal(Act::SetUpUsers)) {
          users->setIdleMinutes(minutes);
          messages->didAct(Act::SetUpUsers, {{"idle_minutes", std::to_string(minutes)}});
        }
      });
  return page;
}

QWidget* makeAuditPage(Messages* messages, Audit* audit, QWidget* parent) {
  auto* page = new widgets::AuditPage(parent);
  QObject::connect(page, &widgets::AuditPage::refreshRequested, audit, &Audit::refresh);
  QObject::connect(audit, &Audit::lineWritten, page, [page, audit] {
    if (page->isVisible()) {
      audit->refresh();
    }
  });
  QObject::connect(audit, &Audit::contentChanged, page,
                   [page, audit] { page->setAudit(viewOf(audit->content(), audit->path())); });
  QObject::connect(page, &widgets::AuditPage::exportRequested, page,
                   [messages, audit](const QString& path) {
                     const journal::AuditContent& content = audit->content();
                     const bool isJson = path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive);
                     saveText(messages, path,
                              QString::fromStdString(isJson ? journal::auditJson(content)
                                                            : journal::auditCsv(content)));
                   });
  return page;
}

}  // namespace rivulet::hmi
