// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <QString>

#include "assessment/domain/people/consent.h"

namespace torsio::gui {

/// PDF to print on A4 and to sign: a form a code, with the purposes of this version in `words`, a box for
/// each answer, and room for name, day and signature. An empty code leaves a line to write on. Throws
/// Error{kFileUnwritable}.
void writeConsentForms(const ConsentVersion& version, const ConsentWords& words,
                       const std::vector<std::string>& codes, const QString& centre,
                       const std::filesystem::path& file);

}  // namespace torsio::gui
