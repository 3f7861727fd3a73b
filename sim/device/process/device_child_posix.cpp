// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/process/device_child_posix.h"

#include <algorithm>
#include <atomic>
#include <cctype>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "sim/core/deadline.h"
#include "sim/core/error.h"
#include "sim/core/helper_program.h"

extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace torsio {

namespace {

using std::chrono::steady_clock;

std::string outputFile() {
  const char* const named = std::getenv("TORSIO_DEVICE_OUTPUT");
  return named != nullptr && *named != '\0' ? named : "/dev/null";
}

/// kRunVariable of one run, which no other has.
std::string newRun() {
  static std::atomic<int> runs{0};
  return std::string(kRunVariable) + '=' + std::to_string(getpid()) + '-' + std::to_string(deadlineNow_ns()) +
         '-' + std::to_string(++runs);
}

/// A file that is closed with its owner.
struct OpenFile {
  int number = -1;
  explicit OpenFile(int opened) : number(opened) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (number >= 0) {
      ::close(number);
    }
  }
};

/// Processes whose environment has this entry.
std::vector<pid_t> processesWith(const std::string& entry) {
  std::vector<pid_t> found;
  std::error_code failed;
  for (std::filesystem::directory_iterator at("/proc", failed), end; !failed && at != end;
       at.increment(failed)) {
    const std::string name = at->path().filename().string();
    if (!std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c) != 0; })) {
      continue;
    }
    std::ifstream file(at->path() / "environ", std::ios::binary);
    const std::string all{std::istreambuf_iterator<char>(file), {}};
    if (('\0' + all).find('\0' + entry + '\0') != std::string::npos) {
      found.push_back(static_cast<pid_t>(std::strtol(name.c_str(), nullptr, 10)));
    }
  }
  return found;
}

}  // namespace

void refuseDevice(const Text& sentence, const Text& remedy) {
  throw Error(ErrorCode::kDevice, sentence, Text::tr("haptic device"), remedy);
}

DeviceChild::DeviceChild(const ChannelRequest& request) : run_(newRun()) {
  const OpenFile memory(memfd_create("torsio-device", MFD_CLOEXEC));
  std::array<int, 2> ends{-1, -1};
  void* place = MAP_FAILED;
  if (memory.number >= 0 && ftruncate(memory.number, sizeof(DeviceChannel)) == 0) {
    place = mmap(nullptr, sizeof(DeviceChannel), PROT_READ | PROT_WRITE, MAP_SHARED, memory.number, 0);
  }
  if (place == MAP_FAILED || pipe2(ends.data(), O_CLOEXEC) != 0) {
    refuseDevice(Text::tr("the system gives no memory for the device process"),
                 Text::tr("Close other programs and try again"));
  }
  channel_ = new (place) DeviceChannel;
  channel_->request = request;
  const OpenFile theirs(ends[0]);
  ours_ = ends[1];
  start(memory.number, theirs.number);
}

DeviceChild::~DeviceChild() {
  end();
  munmap(channel_, sizeof(DeviceChannel));
  ::close(ours_);
}

void DeviceChild::start(int memory, int parentEnd) {
  const std::string program = helperProgram("TORSIO_DEVICE_PROGRAM", "torsio-device");
  const std::string output = outputFile();
  // Away from the numbers that the child wants them under, which dup2 would otherwise close.
  const OpenFile memoryCopy(fcntl(memory, F_DUPFD_CLOEXEC, 10));
  const OpenFile pipeCopy(fcntl(parentEnd, F_DUPFD_CLOEXEC, 10));
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_APPEND,
                                   0600);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  posix_spawn_file_actions_adddup2(&files, memoryCopy.number, kChannelFile);
  posix_spawn_file_actions_adddup2(&files, pipeCopy.number, kParentFile);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  // A group of its own: a signal of the terminal is for the program, which closes the device in order. No
  // signal is blocked or ignored there that is here.
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  sigset_t all;
  sigfillset(&all);
  posix_spawnattr_setsigdefault(&attributes, &all);
  std::vector<char*> environment;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    environment.push_back(*entry);
  }
  environment.push_back(run_.data());
  environment.push_back(nullptr);
  std::string name = "torsio-device";
  std::array<char*, 2> arguments{name.data(), nullptr};
  const int failed =
      posix_spawn(&process_, program.c_str(), &files, &attributes, arguments.data(), environment.data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (failed != 0) {
    process_ = -1;
    munmap(channel_, sizeof(DeviceChannel));
    ::close(ours_);
    refuseDevice(
        Text::tr("the device process %1 cannot be started: %2", program, std::string(strerror(failed))),
        Text::tr("Install Torsio again; torsio-device belongs beside the program"));
  }
}

bool DeviceChild::gone() noexcept {
  siginfo_t state{};
  // Not taken yet: as long as it lies there, its number and that of its group are nobody else's.
  if (process_ > 0 && waitid(P_PID, static_cast<id_t>(process_), &state, WEXITED | WNOHANG | WNOWAIT) == 0 &&
      state.si_pid == process_) {
    end();
  }
  return process_ <= 0;
}

bool DeviceChild::stopped() noexcept {
  siginfo_t state{};
  return process_ > 0 &&
         waitid(P_PID, static_cast<id_t>(process_), &state, WSTOPPED | WNOHANG | WNOWAIT) == 0 &&
         state.si_pid == process_;
}

void DeviceChild::end() noexcept {
  if (process_ <= 0) {
    return;
  }
  (void)kill(process_, SIGKILL);
  (void)kill(-process_, SIGKILL);
  endOrphans();
  (void)waitpid(process_, nullptr, 0);
  process_ = -1;
}

/// What a library started in a group of its own. It may start more meanwhile.
void DeviceChild::endOrphans() const noexcept {
  constexpr int kRounds = 3;
  try {
    for (int round = 0; round < kRounds; ++round) {
      bool found = false;
      for (const pid_t orphan : processesWith(run_)) {
        found = found || orphan != process_;
        (void)kill(orphan, SIGKILL);
      }
      if (!found) {
        return;
      }
    }
  } catch (const std::exception&) {  // no memory: they stay
  }
}

ChannelStage DeviceChild::leaves(ChannelStage from, std::chrono::microseconds patience,
                                 const std::function<bool()>& cancelled) {
  const auto until = steady_clock::now() + patience;
  for (;;) {
    const bool over = gone();  // before the look: an answer may be its last word
    const ChannelStage stage = channel_->stage.load(std::memory_order_acquire);
    if (stage != from) {
      return stage;
    }
    const Text remedy = Text::tr("Plug the device in again, run the vendor's set-up tool once and try again");
    if (over) {
      refuseDevice(Text::tr("the device process ended before it answered"), remedy);
    }
    if (cancelled && cancelled()) {
      end();
      refuseDevice(Text::tr("stopped before its end"), Text::tr("Try again"));
    }
    if (steady_clock::now() > until) {
      end();
      refuseDevice(Text::tr("the device's driver does not answer"), remedy);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

ChannelReport DeviceChild::report() const {
  const std::size_t length = std::min<std::size_t>(channel_->reportLength, channel_->report.size());
  return unpacked(std::string(channel_->report.data(), length));
}

}  // namespace torsio
