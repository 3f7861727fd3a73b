// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include <QPageLayout>
#include <QString>

#include "app/services/study/paper_sheets.h"

namespace torsio::gui {

/// PDF to print on A4, in the typeface of the reports. Throws Error{kFileUnwritable}.
void printHtml(const QString& html, const QString& title, QPageLayout::Orientation orientation,
               const std::filesystem::path& file);

/// One line of a call list: who is to be called for what; written on by hand.
struct CallLine {
  QString trainee;
  QString group;
  QString now;       ///< where the trainee stands
  QString occasion;  ///< that is due
  int missing = 0;   ///< sheets
};

/// PDF to print on A4, for administrators: the trainees in the order of the board with room for time and
/// remarks. Throws Error{kFileUnwritable}.
void writeCallList(const std::vector<CallLine>& lines, const QString& cohort, const QString& room,
                   const std::filesystem::path& file);
/// PDF to print on A4, for the raters: a page a sheet with the rows, scales and anchors of the rubric;
/// nothing says who is scored, of which group, at which stage. Throws Error{kFileUnwritable}.
void writePaperSheets(const std::vector<PaperSheet>& sheets, const QString& centre,
                      const std::filesystem::path& file);

}  // namespace torsio::gui
