// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <QString>

class QPainter;

namespace torsio {

class PdfFile;

/// What a part of a page is to somebody who cannot see it.
enum class PdfRole {
  kArtifact,  ///< nothing: rules, page numbers, a head that is repeated
  kParagraph,
  kSection,  ///< title of a section
  kTitle,    ///< of a figure or a table
  kFigure,
  kHeaderCell,
  kCell,
};

/// A part of a page.
struct PdfPart {
  PdfRole role = PdfRole::kArtifact;
  QString instead{};      ///< read out in place of a figure
  std::size_t page = 0;   ///< from 0
  std::size_t table = 0;  ///< of a cell: from 1
  std::size_t row = 0;    ///< within the table
};

/// Draws something outside of the page that tells where part number `part` begins in the drawing.
void markPart(QPainter& painter, std::size_t part);

/// Tags the pages: what stands in which order, titles, tables with rows and cells, words in place of figures.
/// `parts`: in the order in which they were drawn, each after its markPart(). Throws Error{kBadData} when the
/// file is none of Qt's form.
void addTags(PdfFile& pdf, const std::vector<PdfPart>& parts);

/// Adds title, author and language ("zh-CN") for readers and catalogues. Throws Error{kBadData}.
void addDescription(PdfFile& pdf, const QString& author, const QString& language);

}  // namespace torsio
