// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <functional>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <vector>

extern char** environ;

namespace torsio {

/// Returns the number of instants for interruptions, from an environment variable if set:
/// TORSIO_KILL_INSTANTS, TORSIO_FULL_DISK_INSTANTS.
inline long instantsOf(const char* variable, long usually) {
  const char* wanted = std::getenv(variable);
  return wanted == nullptr ? usually : std::atol(wanted);
}

/// Starts the built program, or another one, discarding its standard output, with additional environment
/// variables. `errors`: file for its standard error. Negative: it could not be started.
inline pid_t startSilent(const std::vector<std::string>& arguments, const char* program = TORSIO_PROGRAM,
                         const std::vector<std::string>& variables = {},
                         const std::string& errors = "/dev/null") {
  std::vector<char*> words{const_cast<char*>(program)};
  for (const std::string& argument : arguments) {
    words.push_back(const_cast<char*>(argument.c_str()));
  }
  words.push_back(nullptr);
  std::vector<char*> environment;
  for (const std::string& variable : variables) {
    environment.push_back(const_cast<char*>(variable.c_str()));
  }
  for (char** variable = environ; *variable != nullptr; ++variable) {
    environment.push_back(*variable);
  }
  environment.push_back(nullptr);
  posix_spawn_file_actions_t silent{};
  posix_spawn_file_actions_init(&silent);
  posix_spawn_file_actions_addopen(&silent, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&silent, 2, errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  pid_t child = -1;
  if (posix_spawn(&child, program, &silent, nullptr, words.data(), environment.data()) != 0) {
    child = -1;
  }
  posix_spawn_file_actions_destroy(&silent);
  return child;
}

/// How a program ended that ran with tests/support/faults.
struct FaultyRun {
  int code = -1;  ///< exit code; negative: killed, or could not be started
  bool killed = false;
};

/// Runs a program with one variable of tests/support/faults/fault_points.cpp.
inline FaultyRun runWithFault(const std::vector<std::string>& arguments, const std::string& fault,
                              const char* program = TORSIO_PROGRAM, const std::string& errors = "/dev/null") {
  const pid_t child = startSilent(arguments, program, {"LD_PRELOAD=" TORSIO_FAULT_POINTS, fault}, errors);
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) {
    return {};
  }
  const bool exited = WIFEXITED(status);
  return {.code = exited ? WEXITSTATUS(status) : -1,
          .killed = WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL};
}

/// Runs a program that stops at every `every`-th instant, so that `look` can check what a kill would leave.
inline FaultyRun runWithStops(const std::vector<std::string>& arguments, long every,
                              const std::function<void()>& look, const char* program = TORSIO_PROGRAM) {
  const pid_t child =
      startSilent(arguments, program,
                  {"LD_PRELOAD=" TORSIO_FAULT_POINTS, "TORSIO_FAULT_STOP_EVERY=" + std::to_string(every)});
  int status = 0;
  while (child > 0 && waitpid(child, &status, WUNTRACED) == child) {
    if (!WIFSTOPPED(status)) {
      return {.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1, .killed = WIFSIGNALED(status)};
    }
    try {
      look();
    } catch (...) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      throw;
    }
    kill(child, SIGCONT);
  }
  return {};
}

/// Runs a program to its end and counts its instants: calls that change a disk or talk to a server. `code`:
/// its exit code.
inline long countInstants(const std::vector<std::string>& arguments, const std::filesystem::path& scratch,
                          int& code, const char* program = TORSIO_PROGRAM) {
  const std::string file = (scratch / ".instants").string();
  code = runWithFault(arguments, "TORSIO_FAULT_COUNT=" + file, program).code;
  long count = 0;
  std::ifstream(file) >> count;
  std::filesystem::remove(file);
  return count;
}

}  // namespace torsio
