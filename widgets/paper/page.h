// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One page for a person: facts, pictures, a table and a line to sign. The same page is painted,
/// written as PDF on A4, or as HTML that needs no other file. Its texts are already in the language
/// of the reader. @threadsafety GUI thread.
#pragma once

#include <QList>
#include <QRectF>
#include <QString>
#include <QStringList>
#include <vector>

#include "widgets/paper/picture.h"

namespace rivulet::paper {

enum class Rating { Good, Unknown, Bad };

struct Fact {
  QString name;
  QString value;
};

struct Group {
  QString title;
  QList<Fact> facts;
};

/// Sentences under a title; each begins a line of its own.
struct Section {
  QString title;
  QStringList sentences;
};

struct Table {
  QString title;
  QStringList headings;
  std::vector<double> widths;  ///< of the columns, any unit
  QList<QStringList> rows;     ///< those that do not fit on a sheet of paper are left out there
};

struct Page {
  QString language;  ///< "de"
  QString title;
  QString result;
  Rating rating = Rating::Unknown;
  QStringList sentences;
  std::vector<Group> groups;  ///< two side by side
  std::vector<Section> sections;
  std::vector<Picture> pictures;
  Table table;
  QString signature;
  QStringList footer;  ///< one line each
};

/// Pictures take what room the other parts leave.
/// @param room  in the painter's units, the margins excluded
/// @param millimetre  in the same units
void paintPage(QPainter& painter, const QRectF& room, double millimetre, const Page& page);

/// An A4 page. @return false: the file cannot be written
[[nodiscard]] bool writePdf(const QString& path, const Page& page);

[[nodiscard]] QString pageHtml(const Page& page);

}  // namespace rivulet::paper
