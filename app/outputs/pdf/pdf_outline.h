// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <QString>

namespace torsio {

class PdfFile;

/// A place in a PDF that a reader finds in the list beside the pages.
struct PdfBookmark {
  QString title;
  std::size_t page = 0;  ///< from 0
  double top_mm = 0.0;   ///< below the upper edge of the page
  int level = 0;         ///< 0: of a section; 1: below the last of level 0 before it
};

/// Adds bookmarks, shown when the file is opened. Throws Error{kBadData} when the file is none of Qt's form.
void addBookmarks(PdfFile& pdf, const std::vector<PdfBookmark>& bookmarks);

}  // namespace torsio
