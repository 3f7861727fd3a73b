// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/progress_line.h"

#include <iostream>

#include "app/cli/terminal.h"

namespace torsio::cli {

namespace {

std::string lineOf(const Progress& progress) {
  std::string line =
      "[" + std::to_string(static_cast<int>(100.0 * progress.fraction)) + " %] " + progress.step;
  if (progress.remaining_s >= 1.0) {
    const int seconds = static_cast<int>(progress.remaining_s + 0.5);
    line += ", about " +
            (seconds >= 90 ? std::to_string((seconds + 30) / 60) + " min" : std::to_string(seconds) + " s") +
            " left";
  }
  return line;
}

}  // namespace

ProgressLine::ProgressLine() : terminal_(standardErrorIsTerminal()) {}

ProgressLine::~ProgressLine() {
  if (terminal_ && lastLength_ > 0) std::cerr << '\n';
}

void ProgressLine::show(const Progress& progress) {
  const std::string line = lineOf(progress);
  if (terminal_) {
    const std::size_t blanks = lastLength_ > line.size() ? lastLength_ - line.size() : 0;
    std::cerr << '\r' << line << std::string(blanks, ' ') << std::flush;
    lastLength_ = line.size();
  } else if (progress.step != lastStep_) {
    std::cerr << line << '\n';
  }
  lastStep_ = progress.step;
}

}  // namespace torsio::cli
