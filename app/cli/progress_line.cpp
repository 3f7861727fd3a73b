// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/progress_line.h"

#include <cmath>
#include <iostream>
#include <sstream>

#include "app/cli/terminal.h"

namespace torsio::cli {

namespace {

std::string remainingText(double remaining_s) {
  std::ostringstream text;
  const long seconds = std::lround(remaining_s);
  if (seconds >= 90) {
    text << (seconds + 30) / 60 << " min";
  } else {
    text << seconds << " s";
  }
  return text.str();
}

std::string lineOf(const Progress& progress) {
  std::ostringstream line;
  line << "[" << static_cast<int>(100.0 * progress.fraction) << " %] " << progress.step;
  if (progress.remaining_s >= 1.0) {
    line << ", about " << remainingText(progress.remaining_s) << " left";
  }
  return line.str();
}

}  // namespace

ProgressLine::ProgressLine() : terminal_(standardErrorIsTerminal()) {}

ProgressLine::~ProgressLine() {
  if (terminal_ && lastLength_ > 0) {
    std::cerr << '\n';
  }
}

void ProgressLine::show(const Progress& progress) {
  const std::string line = lineOf(progress);
  if (terminal_) {
    const std::size_t blanks = lastLength_ > line.size() ? lastLength_ - line.size() : 0;
    std::cerr << '\r' << line << std::string(blanks, ' ') << std::flush;
    lastLength_ = line.size();
  } else if (progress.step.str() != lastStep_) {
    std::cerr << line << '\n';
  }
  lastStep_ = progress.step.str();
}

}  // namespace torsio::cli
