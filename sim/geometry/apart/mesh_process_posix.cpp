// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <optional>
#include <span>
#include <spawn.h>
#include <string>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

#include "sim/base/error.h"
#include "sim/geometry/apart/mesh_mail.h"
#include "sim/geometry/apart/mesh_process.h"

extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace torsio {

namespace {

constexpr auto kLookEvery = std::chrono::milliseconds(2);

std::string meshProgram() {
  if (const char* const named = std::getenv("TORSIO_MESH_PROGRAM"); named != nullptr && *named != '\0') {
    return named;
  }
  std::error_code failed;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", failed);
  return (self.parent_path() / "torsio-mesh").string();
}

[[noreturn]] void refuseReading(const std::string& where, const Text& what, const Text& remedy) {
  throw Error(ErrorCode::kFileUnreadable, what, where, remedy);
}

/// The memory in which the other process leaves its answer.
class AnswerMemory {
 public:
  explicit AnswerMemory(const std::string& where) : number_(memfd_create("torsio-mesh", MFD_CLOEXEC)) {
    if (number_ < 0) {
      refuseReading(where, Text::tr("M05 the system gives no memory to read the file"),
                    Text::tr("Close other programs and try again"));
    }
  }
  ~AnswerMemory() {
    if (place_ != MAP_FAILED) {
      munmap(place_, size_);
    }
    ::close(number_);
  }
  AnswerMemory(const AnswerMemory&) = delete;
  AnswerMemory& operator=(const AnswerMemory&) = delete;

  [[nodiscard]] int number() const noexcept { return number_; }
  /// Returns what was written; empty when nothing was, or too much.
  [[nodiscard]] std::span<const char> bytes() {
    struct stat state {};
    if (fstat(number_, &state) != 0 || state.st_size <= 0 ||
        static_cast<std::uint64_t>(state.st_size) > kMostAnswerBytes) {
      return {};
    }
    size_ = static_cast<std::size_t>(state.st_size);
    place_ = mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, number_, 0);
    return place_ == MAP_FAILED ? std::span<const char>{}
                                : std::span<const char>(static_cast<const char*>(place_), size_);
  }

 private:
  int number_ = -1;
  void* place_ = MAP_FAILED;
  std::size_t size_ = 0;
};

/// Starts the program with the answer's memory as its only file beside the standard three, which lead
/// nowhere.
std::optional<pid_t> started(const std::vector<std::string>& words, int answer) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  // Away from the number that the child wants it under, which dup2 would otherwise leave to be closed.
  const int copy = fcntl(answer, F_DUPFD_CLOEXEC, kMeshAnswerFile + 1);
  posix_spawn_file_actions_adddup2(&files, copy, kMeshAnswerFile);
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&files, number, "/dev/null",
                                     number == STDIN_FILENO ? O_RDONLY : O_WRONLY, 0);
  }
  std::vector<std::string> kept = words;
  std::vector<char*> arguments;
  for (std::string& word : kept) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  pid_t process = -1;
  const int failed = posix_spawn(&process, words.front().c_str(), &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  ::close(copy);
  return failed == 0 ? std::optional(process) : std::nullopt;
}

/// Waits for the end of the process, which is brought about after `wall_s`; empty: it was.
std::optional<int> statusOf(pid_t process, std::uint32_t wall_s) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(wall_s);
  int status = 0;
  while (waitpid(process, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > until) {
      kill(process, SIGKILL);
      (void)waitpid(process, &status, 0);
      return std::nullopt;
    }
    std::this_thread::sleep_for(kLookEvery);
  }
  return status;
}

std::string hexadecimal(double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%a", value);
  return text.data();
}

}  // namespace

RawMesh readMeshApart(const std::filesystem::path& file, double scale_m, const MeshReadLimits& limits) {
  const std::string where = file.string();
  requireMeshFile(file);
  AnswerMemory answer(where);
  const std::string program = meshProgram();
  const std::optional<pid_t> process =
      started({program, where, hexadecimal(scale_m), std::to_string(limits.memory_MB),
               std::to_string(limits.processor_s)},
              answer.number());
  if (!process) {
    refuseReading(where, Text::tr("M05 the program that reads meshes cannot be started: %1", program),
                  Text::tr("Install Torsio again"));
  }
  const std::optional<int> status = statusOf(*process, limits.wall_s);
  if (!status || (WIFSIGNALED(*status) && (WTERMSIG(*status) == SIGXCPU || WTERMSIG(*status) == SIGKILL))) {
    refuseReading(where,
                  Text::tr("M05 the importer did not come to an end with this file within %1 s",
                           std::to_string(status ? limits.processor_s : limits.wall_s)),
                  Text::tr("Export the mesh again, or in another format"));
  }
  if (WIFSIGNALED(*status)) {
    refuseReading(
        where,
        Text::tr("M05 the importer crashed on this file (signal %1)", std::to_string(WTERMSIG(*status))),
        Text::tr("Export the mesh again, or in another format"));
  }
  return meshOfMail(answer.bytes(), where);
}

}  // namespace torsio
