// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace torsio::testing {

/// Puts a shell script in the place of the program that a variable of the environment names.
class OtherProgram {
 public:
  OtherProgram(const char* variable, const std::filesystem::path& file, const std::string& script)
      : variable_(variable), before_(std::getenv(variable)) {
    std::ofstream(file) << "#!/bin/sh\n" << script << '\n';
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    setenv(variable, file.c_str(), 1);
  }
  ~OtherProgram() { setenv(variable_, before_.c_str(), 1); }
  OtherProgram(const OtherProgram&) = delete;
  OtherProgram& operator=(const OtherProgram&) = delete;

 private:
  const char* variable_;
  std::string before_;
};

}  // namespace torsio::testing
