// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio {

/// Returns the path of a program that works for this one in a process of its own: what `variable` of the
/// environment names, else `name` beside this program (build folder), else in ../libexec/torsio
/// (installation). Any thread.
[[nodiscard]] std::string helperProgram(const char* variable, const std::string& name);

}  // namespace torsio
