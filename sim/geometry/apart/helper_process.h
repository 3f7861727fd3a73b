// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace torsio {

// Not on Windows, where files of users are read in the program itself.

/// What a process that reads a file of a user may cost.
struct HelperLimits {
  std::uint64_t memory_MB = 6'000;  ///< address space
  std::uint32_t processor_s = 60;
  std::uint32_t wall_s = 180;
};

/// File numbers under which such a process finds the memory for its answer, and the way to tell how far it
/// is.
inline constexpr int kHelperAnswerFile = 3;
inline constexpr int kHelperNewsFile = 4;
/// Most bytes of an answer: two million triangles with corners of their own.
inline constexpr std::uint64_t kMaxAnswerBytes = 600'000'000;

/// Memory in which another process leaves its answer.
class HelperAnswer {
 public:
  /// Asks the system for it; valid() says whether it gave any.
  HelperAnswer();
  ~HelperAnswer();
  HelperAnswer(const HelperAnswer&) = delete;
  HelperAnswer& operator=(const HelperAnswer&) = delete;

  [[nodiscard]] bool valid() const noexcept { return number_ >= 0; }
  [[nodiscard]] int number() const noexcept { return number_; }
  /// Returns what was written; empty when nothing was, or too much.
  [[nodiscard]] std::span<const char> bytes();

 private:
  int number_ = -1;
  void* place_;
  std::size_t size_ = 0;
};

/// How such a process came to its end.
struct HelperEnd {
  enum class Kind { kEnded, kNotStarted, kOutOfTime, kCrashed };
  Kind kind = Kind::kEnded;
  int signal = 0;             ///< of kCrashed
  std::uint32_t limit_s = 0;  ///< of kOutOfTime: the one that was passed
  double processor_s = 0.0;
  double peak_MB = 0.0;
};

/// Runs a helper, whose first word is its path, to its end or to that of its time. It has no files but its
/// answer, the pipe of news and the standard three, which lead nowhere. `news`, if any, is called with the
/// bytes that it writes there, from this thread, and every few milliseconds with none; when it throws, the
/// helper is ended. It sets its own limits of memory and processor time (bindHelper).
[[nodiscard]] HelperEnd runHelper(const std::vector<std::string>& words, const HelperAnswer& answer,
                                  const HelperLimits& limits,
                                  const std::function<void(std::span<const char>)>& news = {});

/// Writes a number so that it is read back with the same bits.
[[nodiscard]] std::string hexadecimal(double value);

// For the programs that runHelper() starts.

/// Gives up what reading a file does not need: memory and processor time beyond a limit, files
/// larger than an answer, processes of its own, life after its parent. False when the system refuses.
[[nodiscard]] bool bindHelper(std::uint64_t memory_MB, std::uint64_t processor_s);

/// Leaves the answer where the parent looks for it; false when it cannot be written.
[[nodiscard]] bool leaveAnswer(const std::string& answer);

/// Tells the parent how far it is; lost when it does not listen.
void tellParent(std::span<const char> news);

}  // namespace torsio
