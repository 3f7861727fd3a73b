// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/base/progress.h"

namespace torsio::cli {

/// Progress on standard error: one line updated in place on a terminal, one line per step otherwise.
class ProgressLine {
 public:
  ProgressLine();
  /// Ends the line on a terminal.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows the step and its progress.
  void show(const Progress& progress);

 private:
  bool terminal_;
  std::string lastStep_;
  std::size_t lastLength_ = 0;
};

}  // namespace torsio::cli
