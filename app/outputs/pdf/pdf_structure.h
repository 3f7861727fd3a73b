// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <QString>

class QPainter;

namespace torsio {

/// Role of a part of a page for screen readers.
enum class PdfRole {
  kArtifact,  ///< skipped: rules, page numbers, repeated table headers
  kParagraph,
  kSection,  ///< section title
  kTitle,    ///< title of a figure or table
  kFigure,
  kHeaderCell,
  kCell,
};

/// A part of a page.
struct PdfPart {
  PdfRole role = PdfRole::kArtifact;
  QString instead{};      ///< alternative text of a figure
  std::size_t page = 0;   ///< from 0
  std::size_t table = 0;  ///< of a cell; from 1
  std::size_t row = 0;    ///< within the table
};

/// An outline entry, shown next to the pages.
struct PdfBookmark {
  QString title;
  std::size_t page = 0;  ///< from 0
  double top_mm = 0.0;   ///< from the upper edge of the page
  int level = 0;         ///< 0: a section; 1: below the previous section
};

/// Parts of a PDF that Qt does not write.
struct PdfStructure {
  QString author;
  QString language;                    ///< "zh-CN"
  std::vector<PdfBookmark> bookmarks;  ///< shown when the file is opened
  std::vector<PdfPart> parts;          ///< in drawing order, each after its markPart()
};

/// Draws a marker outside the page that tells withStructure() where part number `part` begins.
void markPart(QPainter& painter, std::size_t part);

/// Adds author, language, outline and tags to a PDF: reading order, titles, tables with rows and cells,
/// alternative texts of figures; Chinese characters are found by a search. Throws Error{kBadData} unless the
/// file is by QPdfWriter. Any thread.
[[nodiscard]] std::string withStructure(const std::string& pdf, const PdfStructure& structure);

/// Makes the Chinese characters of a plain PDF by QPdfWriter findable. Throws Error{kBadData}. Any thread.
[[nodiscard]] std::string searchablePdf(const std::string& pdf);

}  // namespace torsio
