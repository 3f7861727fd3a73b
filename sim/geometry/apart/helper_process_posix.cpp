// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <fcntl.h>
#include <optional>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

#include "sim/core/file_io.h"
#include "sim/geometry/apart/helper_process.h"

extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace torsio {

namespace {

constexpr auto kLookEvery = std::chrono::milliseconds(2);

/// The pipe through which a helper tells how far it is; read without waiting.
class News {
 public:
  explicit News(bool wanted) {
    if (wanted && pipe2(ends_.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
      ends_ = {-1, -1};
    }
  }
  ~News() {
    closeWriter();
    if (ends_[0] >= 0) {
      ::close(ends_[0]);
    }
  }
  News(const News&) = delete;
  News& operator=(const News&) = delete;

  [[nodiscard]] int writer() const noexcept { return ends_[1]; }
  void closeWriter() {
    if (ends_[1] >= 0) {
      ::close(ends_[1]);
      ends_[1] = -1;
    }
  }
  void hand(const std::function<void(std::span<const char>)>& news) const {
    std::array<char, 512> bytes{};
    ssize_t got = 0;
    while (ends_[0] >= 0 && (got = ::read(ends_[0], bytes.data(), bytes.size())) > 0) {
      news({bytes.data(), static_cast<std::size_t>(got)});
    }
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// Starts the program with the answer's memory and the news as its only files beside the standard three.
std::optional<pid_t> started(const std::vector<std::string>& words, int answer, int news) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  // Away from the numbers that the child wants them under, which dup2 would otherwise leave to be closed.
  const int copy = fcntl(answer, F_DUPFD_CLOEXEC, kHelperNewsFile + 1);
  const int newsCopy = news < 0 ? -1 : fcntl(news, F_DUPFD_CLOEXEC, kHelperNewsFile + 1);
  posix_spawn_file_actions_adddup2(&files, copy, kHelperAnswerFile);
  if (newsCopy >= 0) {
    posix_spawn_file_actions_adddup2(&files, newsCopy, kHelperNewsFile);
  }
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
  if (newsCopy >= 0) {
    ::close(newsCopy);
  }
  return failed == 0 ? std::optional(process) : std::nullopt;
}

/// Ends a process unless it is released first: its answer is no longer wanted.
class Leash {
 public:
  explicit Leash(pid_t process) : process_(process) {}
  ~Leash() {
    if (process_ > 0) {
      kill(process_, SIGKILL);
      (void)waitpid(process_, nullptr, 0);
    }
  }
  Leash(const Leash&) = delete;
  Leash& operator=(const Leash&) = delete;
  void letGo() noexcept { process_ = 0; }

 private:
  pid_t process_;
};

double secondsOf(const timeval& time) {
  constexpr double kMicrosecond_s = 1e-6;
  return static_cast<double>(time.tv_sec) + kMicrosecond_s * static_cast<double>(time.tv_usec);
}

#ifdef TORSIO_UNLIMITED_MEMORY  // linked with a sanitizer
constexpr bool kLimitsMemory = false;
#else
constexpr bool kLimitsMemory = true;
#endif

bool limited(int resource, std::uint64_t most) {
  const rlimit limit{most, most};
  return setrlimit(static_cast<__rlimit_resource>(resource), &limit) == 0;
}

}  // namespace

HelperAnswer::HelperAnswer() : number_(memfd_create("torsio-helper", MFD_CLOEXEC)), place_(MAP_FAILED) {}

HelperAnswer::~HelperAnswer() {
  if (place_ != MAP_FAILED) {
    munmap(place_, size_);
  }
  if (number_ >= 0) {
    ::close(number_);
  }
}

std::span<const char> HelperAnswer::bytes() {
  struct stat state {};
  if (fstat(number_, &state) != 0 || state.st_size <= 0 ||
      static_cast<std::uint64_t>(state.st_size) > kMaxAnswerBytes) {
    return {};
  }
  size_ = static_cast<std::size_t>(state.st_size);
  place_ = mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, number_, 0);
  return place_ == MAP_FAILED ? std::span<const char>{}
                              : std::span<const char>(static_cast<const char*>(place_), size_);
}

HelperEnd runHelper(const std::vector<std::string>& words, const HelperAnswer& answer,
                    const HelperLimits& limits, const std::function<void(std::span<const char>)>& news) {
  News pipe(static_cast<bool>(news));
  const std::optional<pid_t> process = started(words, answer.number(), pipe.writer());
  HelperEnd end;
  if (!process) {
    end.kind = HelperEnd::Kind::kNotStarted;
    return end;
  }
  pipe.closeWriter();
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(limits.wall_s);
  int status = 0;
  rusage used{};
  bool late = false;
  Leash leash(*process);
  while (wait4(*process, &status, WNOHANG, &used) == 0) {
    if (news) {
      pipe.hand(news);
      news({});
    }
    if (std::chrono::steady_clock::now() > until) {
      late = true;
      kill(*process, SIGKILL);
      (void)wait4(*process, &status, 0, &used);
      break;
    }
    std::this_thread::sleep_for(kLookEvery);
  }
  leash.letGo();
  if (news) {
    pipe.hand(news);  // what it told after the last look
  }
  constexpr double kKilobyte_MB = 1024e-6;
  end.processor_s = secondsOf(used.ru_utime) + secondsOf(used.ru_stime);
  end.peak_MB = kKilobyte_MB * static_cast<double>(used.ru_maxrss);
  if (late || (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL))) {
    end.kind = HelperEnd::Kind::kOutOfTime;
    end.limit_s = late ? limits.wall_s : limits.processor_s;
  } else if (WIFSIGNALED(status)) {
    end.kind = HelperEnd::Kind::kCrashed;
    end.signal = WTERMSIG(status);
  }
  return end;
}

std::string hexadecimal(double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%a", value);
  return text.data();
}

}  // namespace torsio

namespace torsio {

bool bindHelper(std::uint64_t memory_MB, std::uint64_t processor_s) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  disableCoreDumps();
  std::signal(SIGPIPE, SIG_IGN);  // the program that asked may have gone
  return (!kLimitsMemory || limited(RLIMIT_AS, memory_MB * 1'000'000)) && limited(RLIMIT_CPU, processor_s) &&
         limited(RLIMIT_FSIZE, kMaxAnswerBytes) && limited(RLIMIT_NPROC, 0);
}

bool leaveAnswer(const std::string& answer) {
  std::size_t done = 0;
  while (done < answer.size()) {
    const ssize_t written = ::write(kHelperAnswerFile, answer.data() + done, answer.size() - done);
    if (written <= 0) {
      return false;
    }
    done += static_cast<std::size_t>(written);
  }
  return true;
}

void tellParent(std::span<const char> news) {
  [[maybe_unused]] const ssize_t written = ::write(kHelperNewsFile, news.data(), news.size());
}

}  // namespace torsio
