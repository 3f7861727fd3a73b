// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <new>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "sim/core/deadline.h"
#include "sim/core/error.h"
#include "sim/device/hdapi/hdapi_device.h"
#include "sim/device/hdapi/hdapi_library.h"
#include "sim/device/process/device_channel.h"
#include "sim/device/process/device_process.h"

extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace torsio {

namespace {

using std::chrono::steady_clock;

constexpr auto kLookEvery = std::chrono::milliseconds(5);
// Looks in a row without a frame: each takes at least kLookEvery, so that a machine that stalls both does not
// count.
constexpr int kLooksForgiven = static_cast<int>(kChildEnded_us / 5'000);
// A library that calibrates or searches takes seconds; more is a hang.
constexpr auto kOpens = std::chrono::seconds(15);
// A device that was lost because its process was ended, or ended by itself: no driver has such a code.
constexpr std::uint32_t kProcessEnded = 0xffff'ffffU;
constexpr std::int64_t kLostPatience_us = 200'000;
constexpr const char* kStylusDriver = "hdapi";

std::string deviceProgram() {
  if (const char* const named = std::getenv("TORSIO_DEVICE_PROGRAM"); named != nullptr && *named != '\0') {
    return named;
  }
  std::error_code failed;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", failed);
  return (self.parent_path() / "torsio-device").string();
}

[[noreturn]] void refuse(const Text& sentence, const Text& remedy) {
  throw Error(ErrorCode::kDevice, sentence, Text::tr("haptic device"), remedy);
}

template <std::size_t Size>
void copyText(const std::string& from, std::array<char, Size>& to) {
  std::memcpy(to.data(), from.data(), std::min(from.size(), Size - 1));
}

/// A file that is closed with its owner.
struct OpenFile {
  int number = -1;
  OpenFile() = default;
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() { reset(); }
  void reset() {
    if (number >= 0) {
      ::close(number);
    }
    number = -1;
  }
};

/// The device process and the memory shared with it.
class Child {
 public:
  explicit Child(const ChannelRequest& request) {
    OpenFile memory;
    memory.number = memfd_create("torsio-device", MFD_CLOEXEC);
    std::array<int, 2> ends{-1, -1};
    void* place = MAP_FAILED;
    if (memory.number >= 0 && ftruncate(memory.number, sizeof(DeviceChannel)) == 0) {
      place = mmap(nullptr, sizeof(DeviceChannel), PROT_READ | PROT_WRITE, MAP_SHARED, memory.number, 0);
    }
    if (place == MAP_FAILED || pipe2(ends.data(), O_CLOEXEC) != 0) {
      refuse(Text::tr("the system gives no memory for the device process"),
             Text::tr("Close other programs and try again"));
    }
    channel_ = new (place) DeviceChannel;
    channel_->request = request;
    OpenFile theirs;
    theirs.number = ends[0];
    ours_.number = ends[1];
    start(memory.number, theirs.number);
  }
  ~Child() {
    end();
    munmap(channel_, sizeof(DeviceChannel));
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  [[nodiscard]] DeviceChannel& channel() noexcept { return *channel_; }
  /// Tells whether the process is gone; takes its status. One thread at a time.
  [[nodiscard]] bool gone() noexcept {
    if (process_ > 0 && waitpid(process_, nullptr, WNOHANG) == process_) {
      process_ = -1;
    }
    return process_ <= 0;
  }
  /// Ends the process at once.
  void end() noexcept {
    if (!gone()) {
      kill(process_, SIGKILL);
      (void)waitpid(process_, nullptr, 0);
      process_ = -1;
    }
  }

 private:
  void start(int memory, int parentEnd) {
    const std::string program = deviceProgram();
    // Away from the numbers that the child wants them under, which dup2 would otherwise close.
    OpenFile memoryCopy;
    memoryCopy.number = fcntl(memory, F_DUPFD_CLOEXEC, 10);
    OpenFile pipeCopy;
    pipeCopy.number = fcntl(parentEnd, F_DUPFD_CLOEXEC, 10);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, memoryCopy.number, kChannelFile);
    posix_spawn_file_actions_adddup2(&files, pipeCopy.number, kParentFile);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    // A group of its own: a signal of the terminal is for the program, which closes the device in order.
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    std::string name = "torsio-device";
    std::array<char*, 2> arguments{name.data(), nullptr};
    const int failed =
        posix_spawn(&process_, program.c_str(), &files, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    if (failed != 0) {
      process_ = -1;
      munmap(channel_, sizeof(DeviceChannel));
      refuse(Text::tr("the device process %1 cannot be started: %2", program, std::string(strerror(failed))),
             Text::tr("Install Torsio again; torsio-device belongs beside the program"));
    }
  }

  OpenFile ours_;
  DeviceChannel* channel_ = nullptr;
  pid_t process_ = -1;
};

/// A stylus whose driver runs in the device process.
class ProcessDevice final : public HapticDevice {
 public:
  ProcessDevice(std::unique_ptr<Child> child, const ChannelReport& report, std::int64_t patience_us,
                std::function<bool()> cancelled, std::function<Text(std::uint32_t)> lossText)
      : child_(std::move(child)),
        report_(report),
        patience_us_(patience_us),
        cancelled_(std::move(cancelled)),
        lossText_(std::move(lossText)) {
    snapshot_.state = DeviceState::kOpened;
  }
  ~ProcessDevice() override { (void)close(); }

  void serve() override;
  bool close() override;
  void enableForce(bool on) noexcept override { child_->channel().forceWished.store(on); }
  [[nodiscard]] DeviceSnapshot snapshot() noexcept override;
  [[nodiscard]] bool nextEvent(DeviceEvent& event) noexcept override {
    return child_->channel().events.next(taken_, event);
  }
  [[nodiscard]] Text lossText(std::uint32_t code) const override {
    if (code == kProcessEnded) {
      return Text::tr("the device does not answer");
    }
    return lossText_ ? lossText_(code) : HapticDevice::lossText(code);
  }
  [[nodiscard]] const DeviceIdentity& identity() const noexcept override { return report_.identity; }
  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override {
    return report_.capabilities;
  }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override;
  void write(const ForceCommand& command) noexcept override {
    force_ = {command.force_N, force_.number + 1};
    child_->channel().force.publish(force_);
  }
  void dropForce() noexcept override { child_->channel().drops.fetch_add(1); }

 private:
  void watch() noexcept;

  std::unique_ptr<Child> child_;
  ChannelReport report_;
  const std::int64_t patience_us_;
  std::function<bool()> cancelled_;
  std::function<Text(std::uint32_t)> lossText_;  // empty: the usual words
  std::thread supervisor_;
  std::atomic<bool> lost_{false};
  std::atomic<bool> ending_{false};
  bool closed_ = false;
  bool released_ = false;
  DeviceSnapshot snapshot_;
  std::uint64_t taken_ = 0;  // events
  MailedForce force_;
  MailedReading reading_;
  ReadingAge age_{kDeviceStale | kDeviceUncalibrated, kReadingStale_us, kReadingLost_us};
};

/// Waits until the device process leaves `from`; ends it when it takes too long or was cancelled.
ChannelStage answerOf(Child& child, ChannelStage from, const std::function<bool()>& cancelled) {
  const auto until = steady_clock::now() + kOpens;
  for (;;) {
    const bool gone = child.gone();  // before the look: an answer may be its last word
    const ChannelStage stage = child.channel().stage.load(std::memory_order_acquire);
    if (stage != from) {
      return stage;
    }
    const Text remedy = Text::tr("Plug the device in again, run the vendor's set-up tool once and try again");
    if (gone) {
      refuse(Text::tr("the device process ended before it answered"), remedy);
    }
    if (cancelled && cancelled()) {
      child.end();
      refuse(Text::tr("stopped before its end"), Text::tr("Try again"));
    }
    if (steady_clock::now() > until) {
      child.end();
      refuse(Text::tr("the device's driver does not answer"), remedy);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

ChannelReport reportOf(DeviceChannel& channel) {
  const std::size_t length = std::min<std::size_t>(channel.reportLength, channel.report.size());
  return unpacked(std::string(channel.report.data(), length));
}

void ProcessDevice::serve() {
  child_->channel().serveAsked.store(true);
  if (answerOf(*child_, ChannelStage::kOpened, cancelled_) == ChannelStage::kServoRefused) {
    const ChannelReport report = reportOf(child_->channel());
    refuse(report.happened, report.remedy);
  }
  supervisor_ = std::thread([this] { watch(); });
}

void ProcessDevice::watch() noexcept {
  (void)requestRealTime(RealTimeRank::kWatchdog);
  DeviceChannel& channel = child_->channel();
  std::uint64_t frames = 0;
  int still = 0;
  while (!ending_.load()) {
    std::this_thread::sleep_for(kLookEvery);
    const std::uint64_t seen = channel.frames.load(std::memory_order_acquire);
    still = seen != frames || seen == 0 ? 0 : still + 1;
    frames = seen;
    const std::optional<DeviceSnapshot> snapshot = channel.snapshot.latest();
    const bool over = snapshot && snapshot->state == DeviceState::kLost;  // said by the driver itself
    if (child_->gone() || (still >= kLooksForgiven && !over)) {
      lost_.store(true);
      child_->end();
      return;
    }
  }
}

DeviceSnapshot ProcessDevice::snapshot() noexcept {
  if (const std::optional<DeviceSnapshot> newest = child_->channel().snapshot.latest()) {
    snapshot_ = *newest;
  }
  if (lost_.load()) {
    snapshot_.state = DeviceState::kLost;
    snapshot_.lostBecause = snapshot_.lostBecause == 0 ? kProcessEnded : snapshot_.lostBecause;
    snapshot_.forceOn = false;  // its process is gone
  }
  if (closed_) {
    snapshot_.state = DeviceState::kClosed;
    snapshot_.forceOn = snapshot_.forceOn && !released_;
  }
  return snapshot_;
}

DeviceSample ProcessDevice::read(std::int64_t time_us) noexcept {
  reading_ = child_->channel().reading.latest().value_or(reading_);
  DeviceSample sample = age_.marked(reading_, time_us);
  if (lost_.load(std::memory_order_relaxed)) {
    sample.status |= kDeviceLost | kDeviceStale;
  }
  return sample;
}

bool ProcessDevice::close() {
  if (closed_) {
    return released_;
  }
  closed_ = true;
  ending_.store(true);
  if (supervisor_.joinable()) {
    supervisor_.join();
  }
  DeviceChannel& channel = child_->channel();
  channel.closeAsked.store(true);
  // A lost device was released already or is ended anyway: do not wait for its library.
  const std::optional<DeviceSnapshot> last = channel.snapshot.latest();
  const bool lost = lost_.load() || (last && last->state == DeviceState::kLost);
  const auto until =
      steady_clock::now() +
      std::chrono::microseconds(lost ? std::min(patience_us_, kLostPatience_us) : patience_us_);
  while (!child_->gone() && steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  released_ = child_->gone() && !lost_.load() && channel.released.load();
  child_->end();
  return released_;
}

/// What came of a device process; no device when it only looked, or found no library.
struct HostedOpening {
  ChannelReport report;
  std::unique_ptr<HapticDevice> device;
};

HostedOpening openHosted(const ChannelRequest& request, std::int64_t patience_us,
                         const std::function<bool()>& cancelled,
                         const std::function<Text(std::uint32_t)>& lossText) {
  auto child = std::make_unique<Child>(request);
  const ChannelStage stage = answerOf(*child, ChannelStage::kStarting, cancelled);
  HostedOpening opening{reportOf(child->channel()), nullptr};
  if (stage == ChannelStage::kRefused) {
    throw Error(ErrorCode::kDevice, opening.report.happened, Text::tr("haptic device"),
                opening.report.remedy);
  }
  if (stage != ChannelStage::kLooked) {
    opening.device =
        std::make_unique<ProcessDevice>(std::move(child), opening.report, patience_us, cancelled, lossText);
  }
  return opening;
}

}  // namespace

StylusOpening openStylus(const StylusRequest& request) {
  if (request.inThisProcess) {
    StylusOpening opening{loadHdapi(request.library), nullptr};
    if (opening.library.status == HdapiLoadStatus::kLoaded && !request.onlyLibrary) {
      opening.driver = std::make_unique<HdapiDevice>(opening.library.api, request.options);
    }
    return opening;
  }
  ChannelRequest asked;
  copyText(kStylusDriver, asked.driver);
  copyText(request.library, asked.library);
  copyText(request.options.deviceName, asked.deviceName);
  asked.deviceToWorld = request.options.deviceToWorld;
  asked.workspaceCentre_m = request.options.workspaceCentre_m;
  asked.stylusTip_m = request.options.stylusTip_m;
  asked.onlyLook = request.onlyLibrary;
  HostedOpening hosted = openHosted(asked, request.options.patience_us, request.cancelled,
                                    [](std::uint32_t code) { return hdapiErrorText(code); });
  return {hosted.report.library, std::move(hosted.device)};
}

DeviceDriver hosted(const DeviceDriver& driver) {
  const auto asked = [id = driver.id](const DeviceRequest& request, bool onlyLook) {
    ChannelRequest channel;
    copyText(id, channel.driver);
    copyText(request.name, channel.deviceName);
    channel.workspaceCentre_m = request.workspaceCentre_m;
    channel.onlyLook = onlyLook;
    return channel;
  };
  DeviceDriver elsewhere = driver;
  elsewhere.look = [asked, driver](const DeviceRequest& request) -> DriverFinding {
    if (request.inThisProcess) {
      return driver.look(request);
    }
    try {
      return openHosted(asked(request, true), HdapiOptions().patience_us, request.cancelled, {})
          .report.finding;
    } catch (const Error& error) {
      return {false, error.happenedText(), error.remedyText(), {}};
    }
  };
  elsewhere.open = [asked, driver](const DeviceRequest& request) {
    return request.inThisProcess
               ? driver.open(request)
               : openHosted(asked(request, false), HdapiOptions().patience_us, request.cancelled, {}).device;
  };
  return elsewhere;
}

}  // namespace torsio
