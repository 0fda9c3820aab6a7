// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/log_view.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>

#include "widgets/alarms/alarm_text.h"
#include "widgets/common/diagnostic_text.h"
#include "widgets/common/sheet_area.h"
#include "widgets/common/table_style.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

constexpr std::array kSources{alarm::Source::Control, alarm::Source::Connection, alarm::Source::Run,
                              alarm::Source::Program, alarm::Source::Computer};

QString timeText(const LogLine& line) {
  return line.at.toString(QStringLiteral("yyyy-MM-dd HH:mm:ss.zzz"));
}

/// Sets the texts of a choice without a change of what is chosen.
void setTexts(QComboBox* box, const QStringList& texts) {
  const QSignalBlocker quiet(box);
  const int chosen = std::max(0, box->currentIndex());
  box->clear();
  box->addItems(texts);
  box->setCurrentIndex(chosen);
}

}  // namespace

/// Lines of at least a severity, of one source, that contain the words searched for.
class LogFilter final : public QSortFilterProxyModel {
 public:
  LogFilter(LogModel* model, QObject* parent) : QSortFilterProxyModel(parent), m_model(model) {
    setSourceModel(model);
  }

  void setSeverity(gcode::Severity least) {
    m_least = least;
    invalidateFilter();
  }
  void setSource(std::optional<alarm::Source> source) {
    m_source = source;
    invalidateFilter();
  }
  void setWords(const QString& words) {
    m_words = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    invalidateFilter();
  }
  [[nodiscard]] const LogLine& line(int row) const {
    return m_model->row(mapToSource(index(row, 0)).row());
  }

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& /*parent*/) const override {
    const LogLine& line = m_model->row(row);
    if (line.severity < m_least || (m_source && line.source != *m_source)) {
      return false;
    }
    if (m_words.isEmpty()) {
      return true;
    }
    const QString text = timeText(line) + QLatin1Char(' ') + line.text();
    return std::all_of(m_words.begin(), m_words.end(), [&text](const QString& word) {
      return text.contains(word, Qt::CaseInsensitive);
    });
  }

 private:
  LogModel* m_model;
  gcode::Severity m_least = gcode::Severity::Note;
  std::optional<alarm::Source> m_source;
  QStringList m_words;
};

LogModel::LogModel(QObject* parent)
    : TableModel({{[] { return tr("Time"); }, &timeText},
                  {[] { return tr("Severity"); },
                   [](const LogLine& line) { return severityText(line.severity); }, false,
                   [this](const LogLine& line, int role) {
                     return role == Qt::DecorationRole
                                ? QVariant(severityIcon(line.severity, m_palette))
                                : QVariant();
                   }},
                  {[] { return tr("Source"); },
                   [](const LogLine& line) { return sourceText(line.source); }},
                  {[] { return tr("Message"); }, [](const LogLine& line) { return line.text(); }}},
                 parent, kCapacity) {
}

void LogModel::setColors(const QPalette& palette) {
  m_palette = palette;
  refresh();
}

LogView::LogView(QWidget* parent)
    : Page(parent),
      m_model(new LogModel(this)),
      m_filter(new LogFilter(m_model, this)),
      m_table(say(new QTableView(this), {.name = QT_TR_NOOP("Messages")})) {
  m_table->setModel(m_filter);
  styleTable(m_table);
  m_table->setColumnWidth(LogModel::Time, 210);
  m_table->setColumnWidth(LogModel::SeverityColumn, 120);
  m_table->setColumnWidth(LogModel::SourceColumn, 120);
  m_table->horizontalHeader()->setStretchLastSection(true);
  inColumn({makeFilters(), {m_table, 1}, inRow({m_copy, m_save, spring(), m_count})}, this);
  connectFilters();
  connect(m_copy, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(toText()); });
  connect(m_save, &QPushButton::clicked, this, [this] {
    askWhereToSave(this, {tr("Save the messages"), QStringLiteral("rivulet.log"), {}},
                   [this](const QString& path, auto) { Q_EMIT saveRequested(path); });
  });
  retranslate();
  onTheme([this] { m_model->setColors(palette()); });
}

QWidget* LogView::makeFilters() {
  auto* filters = new QWidget(this);
  for (QWidget* field : std::initializer_list<QWidget*>{m_severity, m_source, m_search}) {
    field->setMinimumHeight(kTouchHeightPx);
  }
  for (QComboBox* box : {m_severity, m_source}) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  }
  m_search->setClearButtonEnabled(true);
  inRow({m_severity, m_source, {m_search, 1}, m_wrap}, filters, QMargins(0, 0, 0, 0));
  return filters;
}

void LogView::connectFilters() {
  connect(m_severity, &QComboBox::currentIndexChanged, this, [this](int index) {
    m_filter->setSeverity(static_cast<gcode::Severity>(std::max(0, index)));
  });
  connect(m_source, &QComboBox::currentIndexChanged, this, [this](int index) {
    m_filter->setSource(index > 0 ? std::optional(kSources[static_cast<std::size_t>(index - 1)])
                                  : std::nullopt);
  });
  connect(m_search, &QLineEdit::textChanged, m_filter, &LogFilter::setWords);
  connect(m_wrap, &QCheckBox::toggled, this, &LogView::wrapRows);
  constexpr int kRestMs = 150;
  m_wrapTimer.setSingleShot(true);
  m_wrapTimer.setInterval(kRestMs);
  connect(&m_wrapTimer, &QTimer::timeout, this, &LogView::wrapRows);
  connect(m_table->horizontalHeader(), &QHeaderView::sectionResized, this, [this] {
    if (m_wrap->isChecked()) {
      m_wrapTimer.start();
    }
  });
  for (const auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved}) {
    connect(m_filter, signal, this, &LogView::showCount);
  }
}

void LogView::append(const LogLine& line) {
  // Follow the end only while the operator looks at it.
  const QScrollBar* bar = m_table->verticalScrollBar();
  const bool atEnd = bar->value() >= bar->maximum();
  const int rows = m_filter->rowCount();
  m_model->append(line);
  if (m_wrap->isChecked() && m_filter->rowCount() > rows) {
    m_table->resizeRowToContents(m_filter->rowCount() - 1);
  }
  if (atEnd) {
    m_table->scrollToBottom();
  }
}

QString LogView::toText() const {
  QString text;
  for (int row = 0; row < m_filter->rowCount(); ++row) {
    const LogLine& line = m_filter->line(row);
    text += QStringLiteral("%1\t%2\t%3\t%4\n")
                .arg(line.at.toOffsetFromUtc(line.at.offsetFromUtc()).toString(Qt::ISODateWithMs),
                     severityText(line.severity), sourceText(line.source), line.text());
  }
  return text;
}

void LogView::wrapRows() {
  const bool wraps = m_wrap->isChecked();
  m_table->setWordWrap(wraps);
  if (wraps) {
    m_table->resizeRowsToContents();
  } else {
    QHeaderView* rows = m_table->verticalHeader();
    rows->setDefaultSectionSize(rows->defaultSectionSize());  // of every row
  }
}

void LogView::showCount() {
  const int shown = m_filter->rowCount();
  const int all = m_model->rowCount();
  m_count->setText(shown == all ? tr("%Ln messages", nullptr, all)
                                : tr("%1 of %2 messages").arg(shown).arg(all));
}

void LogView::retranslate() {
  setTexts(m_severity, {tr("All messages"), tr("Warnings and errors"), tr("Errors only")});
  QStringList sources{tr("All sources")};
  for (const alarm::Source source : kSources) {
    sources << sourceText(source);
  }
  setTexts(m_source, sources);
  m_model->refresh();
  showCount();
}

}  // namespace rivulet::widgets
