// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/sheet_area.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <algorithm>
#include <utility>

#include "widgets/common/page.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

struct FileSheetTexts {
  Q_DECLARE_TR_FUNCTIONS(FileSheetTexts)
};

/// Qt's own answers to a file that is not there, or is already there, are windows that take the
/// mouse.
class FileSheet final : public QFileDialog {
 public:
  FileSheet(const FileQuestion& question, FileMode mode) {
    setWindowTitle(question.title);
    setOption(DontUseNativeDialog);
    setOption(DontConfirmOverwrite);
    setOption(ReadOnly);  // nothing is renamed or deleted from here
    setFileMode(mode);
    setAcceptMode(mode == AnyFile ? AcceptSave : AcceptOpen);
    if (!question.filter.isEmpty()) {
      setNameFilters(question.filter.split(QStringLiteral(";;")));
    }
    const QFileInfo start(question.start);
    if (start.isDir()) {
      setDirectory(start.absoluteFilePath());
    } else if (!question.start.isEmpty()) {
      setDefaultSuffix(start.suffix());
      setDirectory(start.absolutePath());
      selectFile(start.fileName());
    }
    for (QPushButton* button : findChildren<QPushButton*>()) {
      button->setMinimumHeight(kTouchHeightPx);
    }
  }

  void accept() override {
    // As the file will be named: else another one would be replaced without a question.
    static const QRegularExpression suffix(QStringLiteral(R"(\*\.(\w+))"));
    if (const auto named = suffix.match(selectedNameFilter());
        acceptMode() == AcceptSave && named.hasMatch()) {
      setDefaultSuffix(named.captured(1));
    }
    const QStringList files = selectedFiles();
    const auto isThere = [](const QString& file) { return QFileInfo::exists(file); };
    if (files.isEmpty() ||
        (acceptMode() == AcceptOpen && !std::all_of(files.begin(), files.end(), isThere))) {
      return;  // the name stays as it was typed
    }
    const QFileInfo file(files.front());
    if (acceptMode() == AcceptOpen || !file.exists() || file.isDir()) {
      QFileDialog::accept();
      return;
    }
    auto* box =
        new QMessageBox(QMessageBox::Warning, windowTitle(),
                        FileSheetTexts::tr("%1 is already there. Replace it?").arg(file.fileName()),
                        QMessageBox::Cancel);
    QPushButton* replace = box->addButton(FileSheetTexts::tr("Replace"), QMessageBox::AcceptRole);
    box->setDefaultButton(QMessageBox::Cancel);
    connect(replace, &QPushButton::clicked, this, [this] { QFileDialog::accept(); });
    openSheet(box, this);
  }
};

void askForFile(QWidget* asker, const FileQuestion& question, QFileDialog::FileMode mode,
                std::function<void(const QStringList&, const QString&)> chosen) {
  auto* sheet = new FileSheet(question, mode);
  QObject::connect(sheet, &QDialog::accepted, asker, [sheet, chosen = std::move(chosen)] {
    chosen(sheet->selectedFiles(), sheet->selectedNameFilter());
  });
  openSheet(sheet, asker);
}

/// As a window of its own would get it.
void focusFirst(QWidget* sheet) {
  QWidget* first = sheet->focusWidget();
  while (first == nullptr || first == sheet || !first->isVisible() ||
         (first->focusPolicy() & Qt::TabFocus) == 0) {
    first = (first != nullptr ? first : sheet)->nextInFocusChain();
    if (!sheet->isAncestorOf(first)) {
      return;  // it has nothing to be pressed or filled in
    }
  }
  first->setFocus();
}

}  // namespace

SheetArea::SheetArea(QWidget* parent) : QStackedWidget(parent) {
  connect(this, &QStackedWidget::currentChanged, this, &SheetArea::takeShown);
}

void SheetArea::open(QDialog* sheet) {
  auto* page = new QWidget;
  QLabel* title = makeHeading(page);
  title->setText(sheet->windowTitle());
  sheet->setParent(page, Qt::Widget);
  sheet->setSizeGripEnabled(false);
  title->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  inColumn({title, {sheet, 1, Qt::AlignTop}}, page);
  m_sheets.push_back({page, sheet});
  connect(sheet, &QDialog::finished, this, [this, page] { close(page); });
  addWidget(page);
  setCurrentWidget(page);
  sheet->show();
  focusFirst(sheet);
  Q_EMIT opened();
}

void SheetArea::close(QWidget* page) {
  m_sheets.erase(std::remove_if(m_sheets.begin(), m_sheets.end(),
                                [page](const Sheet& sheet) { return sheet.page == page; }),
                 m_sheets.end());
  if (currentWidget() == page) {
    setCurrentWidget(m_sheets.empty() ? m_page : m_sheets.back().page);
  }
  removeWidget(page);
  page->deleteLater();
}

bool SheetArea::isSheet(const QWidget* page) const {
  return std::any_of(m_sheets.begin(), m_sheets.end(),
                     [page](const Sheet& sheet) { return sheet.page == page; });
}

void SheetArea::takeShown() {
  if (isSheet(currentWidget())) {
    return;
  }
  m_page = currentWidget();
  while (!m_sheets.empty()) {
    m_sheets.back().dialog->reject();
  }
}

void SheetArea::setPagesEnabled(bool areEnabled) {
  for (int i = 0; i < count(); ++i) {
    if (!isSheet(widget(i))) {
      widget(i)->setEnabled(areEnabled);
    }
  }
}

void openSheet(QDialog* sheet, QWidget* asker) {
  sheet->setAttribute(Qt::WA_DeleteOnClose, false);
  sheet->setLocale(QLocale());  // its fields show and read numbers in the present language
  if (auto* area = asker->window()->findChild<SheetArea*>()) {
    area->open(sheet);
    return;
  }
  sheet->setParent(asker, Qt::Dialog);
  sheet->setAttribute(Qt::WA_DeleteOnClose);
  sheet->setModal(false);
  sheet->show();
}

void askForFile(QWidget* asker, const FileQuestion& question,
                std::function<void(const QString&)> chosen) {
  askForFile(asker, question, QFileDialog::ExistingFile,
             [chosen = std::move(chosen)](const QStringList& files, const QString& /*filter*/) {
               chosen(files.front());
             });
}

void askForFiles(QWidget* asker, const FileQuestion& question,
                 std::function<void(const QStringList&)> chosen) {
  askForFile(asker, question, QFileDialog::ExistingFiles,
             [chosen = std::move(chosen)](const QStringList& files, const QString& /*filter*/) {
               chosen(files);
             });
}

void askWhereToSave(QWidget* asker, const FileQuestion& question,
                    std::function<void(const QString&, const QString&)> chosen) {
  askForFile(asker, question, QFileDialog::AnyFile,
             [chosen = std::move(chosen)](const QStringList& files, const QString& filter) {
               chosen(files.front(), filter);
             });
}

}  // namespace rivulet::widgets
