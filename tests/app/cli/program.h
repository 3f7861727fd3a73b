// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <sys/wait.h>

#include "sim/core/file_io.h"

namespace torsio {

struct ProgramRun {
  int code = -1;
  std::string out;
  std::string err;
};

/// A new empty folder for one test in the system's temporary folder, named with the process id because tests
/// run in parallel processes. Removed when the process ends.
inline std::filesystem::path emptyFolder(const std::string& name) {
  struct Cleaner {
    std::vector<std::filesystem::path> folders;
    Cleaner() = default;
    Cleaner(const Cleaner&) = delete;
    Cleaner& operator=(const Cleaner&) = delete;
    ~Cleaner() {
      std::error_code ignored;
      for (const auto& folder : folders) {
        std::filesystem::remove_all(folder, ignored);
      }
    }
  };
  static Cleaner cleaner;
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("torsio-cli-" + name + "-" + std::to_string(getpid()));
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  cleaner.folders.push_back(folder);
  return folder;
}

/// Runs a program without a display; `under`: a command that wraps it.
inline ProgramRun runProgram(const std::string& program, const std::string& arguments,
                             const std::filesystem::path& scratch, const std::string& under = "") {
  const std::string out = (scratch / ".out").string();
  const std::string err = (scratch / ".err").string();
  const std::string command = "env -u DISPLAY -u WAYLAND_DISPLAY " + under + " " + program + " " + arguments +
                              " >" + out + " 2>" + err + " </dev/null";
  const int status = std::system(command.c_str());
  ProgramRun run{WIFEXITED(status) ? WEXITSTATUS(status) : -1, readFile(out), readFile(err)};
  std::filesystem::remove(out);
  std::filesystem::remove(err);
  return run;
}

/// Runs the built program like a user.
inline ProgramRun runTorsio(const std::string& arguments, const std::filesystem::path& scratch,
                            const std::string& under = "") {
  return runProgram(TORSIO_PROGRAM, arguments, scratch, under);
}

}  // namespace torsio
