// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include <QTemporaryDir>

namespace torsio::testing {

/// A folder removed with its owner.
class OwnFolder {
 public:
  [[nodiscard]] std::filesystem::path path() const { return folder_.path().toStdString(); }

 private:
  QTemporaryDir folder_;
};

/// Returns whether a program is available on this machine.
[[nodiscard]] bool hasProgram(const std::string& name);
/// Runs a shell command; returns its output, or its error output if it failed.
[[nodiscard]] std::string outputOf(const std::string& command, const std::filesystem::path& folder);

/// The paper's study with content that causes problems in other programs: text that looks like a formula,
/// Chinese, line feeds, numbers with many digits.
[[nodiscard]] CohortInputs awkwardCohort();

}  // namespace torsio::testing
