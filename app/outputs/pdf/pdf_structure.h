// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <QString>

class QPainter;

namespace torsio {

/// What a part of a page is to a screen reader.
enum class PdfRole {
  kArtifact,  ///< skipped: rules, page numbers, a repeated table head
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
  QString instead{};      ///< read aloud in place of a figure
  std::size_t page = 0;   ///< from 0
  std::size_t table = 0;  ///< of a cell: from 1
  std::size_t row = 0;    ///< within the table
};

/// An entry of the outline that a reader shows beside the pages.
struct PdfBookmark {
  QString title;
  std::size_t page = 0;  ///< from 0
  double top_mm = 0.0;   ///< below the upper edge of the page
  int level = 0;         ///< 0: a section; 1: below the last section before it
};

/// What Qt does not write into a PDF.
struct PdfStructure {
  QString author;
  QString language;                    ///< "zh-CN"
  std::vector<PdfBookmark> bookmarks;  ///< shown when the file is opened
  std::vector<PdfPart> parts;          ///< in the order in which they were drawn, each after its markPart()
};

/// Draws a mark outside the page, by which withStructure() finds where part number `part` begins.
void markPart(QPainter& painter, std::size_t part);

/// The same PDF with author, language, outline and tags: reading order, titles, tables with rows and cells,
/// alternative text of figures. Throws Error{kBadData} for anything but a file of QPdfWriter. Any thread.
[[nodiscard]] std::string withStructure(const std::string& pdf, const PdfStructure& structure);

}  // namespace torsio
