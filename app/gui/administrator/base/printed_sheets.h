// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <QPageLayout>
#include <QString>

#include "app/services/study/paper_sheets.h"
#include "assessment/domain/people/consent.h"

namespace torsio::gui {

/// Writes a PDF for A4, in the typeface of the reports. Throws Error{kFileUnwritable}.
void printHtml(const QString& html, const QString& title, QPageLayout::Orientation orientation,
               const std::filesystem::path& file);

/// One line of a call list to be filled in by hand: the trainee and the occasion.
struct CallLine {
  QString trainee;
  QString group;
  QString now;       ///< the trainee's present activity
  QString occasion;  ///< the occasion that is due
  int missing = 0;   ///< missing sheets
};

/// Writes the administrators' call list as a PDF for A4: the trainees in the order of the board, with space
/// for time and remarks. Throws Error{kFileUnwritable}.
void writeCallList(const std::vector<CallLine>& lines, const QString& cohort, const QString& room,
                   const std::filesystem::path& file);
/// Writes the raters' sheets as a PDF for A4, one page per sheet with rows, scales and anchors of the rubric.
/// Blinded: shows no name, group or stage. Throws Error{kFileUnwritable}.
void writePaperSheets(const std::vector<PaperSheet>& sheets, const QString& centre,
                      const std::filesystem::path& file);

/// Writes a PDF of consent forms for A4, one form per code, with this version's purposes in `words`, a box
/// for each answer, and space for name, date and signature. An empty code leaves a blank line. Throws
/// Error{kFileUnwritable}.
void writeConsentForms(const ConsentVersion& version, const ConsentWords& words,
                       const std::vector<std::string>& codes, const QString& centre,
                       const std::filesystem::path& file);

}  // namespace torsio::gui
