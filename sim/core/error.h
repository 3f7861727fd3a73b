// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

#include "sim/core/text.h"

namespace torsio {

/// Why something was refused. The value is the exit code of the command line (docs/cli.md).
enum class ErrorCode : int {
  kUsage = 2,           ///< unknown option, missing argument
  kFileMissing = 3,     ///< no such file or folder
  kFileUnreadable = 4,  ///< exists, but cannot be read, or is not what its name says
  kFileUnwritable = 5,  ///< read-only folder, full disk
  kBadMesh = 6,         ///< empty, open, non-manifold, NaN vertices, wrong unit
  kBadParameter = 7,    ///< a number outside its stated range
  kBadData = 8,         ///< a table, trial or configuration that breaks its rules
  kDatabase = 9,        ///< the database refused an operation
  kNewerSchema = 10,    ///< the database was written by a newer version
  kPermission = 11,     ///< the role may not do this
  kDevice = 12,         ///< the haptic device refused or was lost
  kVerifyFailed = 13,   ///< a replay or an integrity check found a difference
  kFolded = 14,         ///< the organ would have to fold, tear or swell to look like this
  kInternal = 70,       ///< our own bug (ContractError)
};

/// A refusal of input: what happened, where, and what the user can do.
class Error : public std::runtime_error {
 public:
  /// `what`: one sentence without a full stop. `where`: file, line, vertex, column or "".
  /// `remedy`: one imperative sentence or "". What varies is an argument: `Text::tr("no trial has the
  /// id %1", id)`.
  Error(ErrorCode code, Text what, Text where, Text remedy);

  [[nodiscard]] ErrorCode code() const noexcept { return code_; }
  /// Returns in English what happened.
  [[nodiscard]] const std::string& happened() const noexcept { return happened_; }
  /// Returns in English where it happened, or "".
  [[nodiscard]] const std::string& where() const noexcept { return where_; }
  /// Returns in English what the user can do, or "".
  [[nodiscard]] const std::string& remedy() const noexcept { return remedy_; }

  /// Returns what happened as a text, which can be said in another language.
  [[nodiscard]] const Text& happenedText() const noexcept { return happenedText_; }
  /// Returns where it happened as a text.
  [[nodiscard]] const Text& whereText() const noexcept { return whereText_; }
  /// Returns what the user can do as a text.
  [[nodiscard]] const Text& remedyText() const noexcept { return remedyText_; }

 private:
  ErrorCode code_;
  Text happenedText_;
  Text whereText_;
  Text remedyText_;
  std::string happened_;
  std::string where_;
  std::string remedy_;
};

/// Thrown when a promise between two parts of Torsio was broken: a bug of Torsio, never the user's input.
class ContractError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Refuses data that break one of their rules: throws Error{kBadData}. `what`: one sentence without a full
/// stop; `where`: which record, file or line, or ""; `remedy`: one imperative sentence or "". Any thread.
[[noreturn]] inline void refuse(const Text& what, const Text& where, const Text& remedy) {
  throw Error(ErrorCode::kBadData, what, where, remedy);
}

/// Refuses a value outside what is allowed: throws Error{kBadParameter}; otherwise as refuse().
[[noreturn]] inline void refuseParameter(const Text& what, const Text& where, const Text& remedy) {
  throw Error(ErrorCode::kBadParameter, what, where, remedy);
}

}  // namespace torsio
