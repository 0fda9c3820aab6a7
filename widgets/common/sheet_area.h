// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Questions are shown in place of the page: a window of their own would cover Stop, or keep the
/// mouse from it. @threadsafety GUI thread.
#pragma once

#include <QStackedWidget>
#include <QString>
#include <QStringList>
#include <functional>
#include <vector>

class QDialog;

namespace rivulet::widgets {

/// Pages, one of which is shown, and questions over it.
class SheetArea final : public QStackedWidget {
  Q_OBJECT

 public:
  explicit SheetArea(QWidget* parent = nullptr);

  /// Shows the question under its title until it is answered; then what was shown before. When a
  /// page is shown instead, the question is rejected. @param sheet  is deleted afterwards
  void open(QDialog* sheet);
  /// The pages, not the questions: in a locked window, the PIN can still be given.
  void setPagesEnabled(bool areEnabled);

 Q_SIGNALS:
  void opened();

 private:
  struct Sheet {
    QWidget* page;
    QDialog* dialog;
  };
  [[nodiscard]] bool isSheet(const QWidget* page) const;
  void close(QWidget* page);
  void takeShown();

  std::vector<Sheet> m_sheets;  ///< the later ones over the earlier
  QWidget* m_page = nullptr;    ///< shown last
};

/// Asks in the `SheetArea` of the asker's window, or, where there is none, in a window that takes
/// the mouse from no other.
void openSheet(QDialog* sheet, QWidget* asker);

/// Which file is asked for.
struct FileQuestion {
  QString title;
  QString start;   ///< folder or file that is proposed; empty: the present folder
  QString filter;  ///< "Traces (*.csv *.rivulet);;All files (*)"; empty: all files
};
/// @param chosen  is called with a file that exists; not at all if the user cancels
void askForFile(QWidget* asker, const FileQuestion& question,
                std::function<void(const QString&)> chosen);
void askForFiles(QWidget* asker, const FileQuestion& question,
                 std::function<void(const QStringList&)> chosen);
/// Asks again before a file is replaced. @param chosen  is called with the file and the filter
void askWhereToSave(QWidget* asker, const FileQuestion& question,
                    std::function<void(const QString&, const QString&)> chosen);

}  // namespace rivulet::widgets
