// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>
#include <streambuf>
#include <string>

namespace torsio::cli {

// Private to app/cli's .cpp files.

/// As long as it lives, everything that a stream is given arrives as plainText(): nothing that a name from
/// outside holds commands a terminal. One thread.
class PlainOutput : private std::streambuf {
 public:
  /// `returns`: whether "\r" passes when nothing else is written with it, as the line of progress does.
  PlainOutput(std::ostream& stream, bool returns);
  ~PlainOutput() override;
  PlainOutput(const PlainOutput&) = delete;
  PlainOutput& operator=(const PlainOutput&) = delete;

 private:
  int_type overflow(int_type byte) override;
  std::streamsize xsputn(const char* bytes, std::streamsize count) override;
  int sync() override;
  bool pass(bool all);

  std::ostream& stream_;
  std::streambuf* const before_;
  const bool returns_;
  std::string waiting_;  // bytes of a character that is not complete
};

}  // namespace torsio::cli
