// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <QString>

#include "assessment/domain/people/consent.h"

namespace torsio::gui {

/// Writes a PDF of consent forms for A4, one form per code, with this version's purposes in `words`, a box
/// for each answer, and space for name, date and signature. An empty code leaves a blank line. Throws
/// Error{kFileUnwritable}.
void writeConsentForms(const ConsentVersion& version, const ConsentWords& words,
                       const std::vector<std::string>& codes, const QString& centre,
                       const std::filesystem::path& file);

}  // namespace torsio::gui
