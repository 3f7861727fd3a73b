// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <vector>

extern char** environ;

namespace torsio::test {

/// At how many instants a program is killed; TORSIO_KILL_INSTANTS changes it.
inline int killInstants(int usually) {
  const char* wanted = std::getenv("TORSIO_KILL_INSTANTS");
  return wanted == nullptr ? usually : std::atoi(wanted);
}

/// Starts the built program, or another one, with its output thrown away. Below 0: it could not be started.
inline pid_t startSilent(const std::vector<std::string>& arguments, const char* program = TORSIO_PROGRAM) {
  std::vector<char*> words{const_cast<char*>(program)};
  for (const std::string& argument : arguments) {
    words.push_back(const_cast<char*>(argument.c_str()));
  }
  words.push_back(nullptr);
  posix_spawn_file_actions_t silent{};
  posix_spawn_file_actions_init(&silent);
  posix_spawn_file_actions_addopen(&silent, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&silent, 2, "/dev/null", O_WRONLY, 0);
  pid_t child = -1;
  if (posix_spawn(&child, program, &silent, nullptr, words.data(), environ) != 0) {
    child = -1;
  }
  posix_spawn_file_actions_destroy(&silent);
  return child;
}

/// Starts the program and kills it after so long. False: it could not be started.
inline bool runAndKill(const std::vector<std::string>& arguments, std::chrono::microseconds after,
                       const char* program = TORSIO_PROGRAM) {
  const pid_t child = startSilent(arguments, program);
  if (child < 0) {
    return false;
  }
  std::this_thread::sleep_for(after);
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  return true;
}

}  // namespace torsio::test
