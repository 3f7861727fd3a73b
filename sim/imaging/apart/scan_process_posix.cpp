// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <filesystem>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/helper_program.h"
#include "sim/imaging/apart/scan_mail.h"
#include "sim/imaging/apart/scan_process.h"

namespace torsio {

namespace {

[[noreturn]] void refuseScan(const Text& what, const std::string& where, const Text& remedy) {
  throw Error(ErrorCode::kFileUnreadable, what, where, remedy);
}

/// Refuses a scan that the other process gave no answer to.
void requireScanEnded(const HelperEnd& end, const std::string& where, const std::string& program) {
  const Text again = Text::tr("Copy or export the scan again");
  switch (end.kind) {
    case HelperEnd::Kind::kEnded:
      return;
    case HelperEnd::Kind::kNotStarted:
      refuseScan(Text::tr("D04 the program that reads scans cannot be started: %1", program), where,
                 Text::tr("Install Torsio again"));
    case HelperEnd::Kind::kOutOfTime:
      refuseScan(Text::tr("D04 the reader did not come to an end with this scan within %1 s",
                          std::to_string(end.limit_s)),
                 where, Text::tr("Crop the scan to the organ"));
    case HelperEnd::Kind::kCrashed:
      break;
  }
  refuseScan(Text::tr("D04 the reader crashed on this scan (signal %1)", std::to_string(end.signal)), where,
             again);
}

/// Forwards the progress of a process to the listener, and asks whether the work is still wanted.
class ScanNews {
 public:
  explicit ScanNews(const ScanProgress& progress) : progress_(progress) {}

  void take(std::span<const char> bytes) {
    left_.append(bytes.begin(), bytes.end());
    while (left_.size() >= 2) {
      const int step = static_cast<unsigned char>(left_[0]);
      if (step <= static_cast<int>(ScanStep::kMeasuring)) {
        step_ = static_cast<ScanStep>(step);
        fraction_ = 0.01 * static_cast<unsigned char>(left_[1]);
        tell();
      }
      left_.erase(0, 2);
    }
    if (std::chrono::steady_clock::now() - told_ > kTellEvery) {
      tell();  // it may want to give up
    }
  }

 private:
  static constexpr auto kTellEvery = std::chrono::milliseconds(200);

  void tell() {
    told_ = std::chrono::steady_clock::now();
    if (progress_) {
      progress_(step_, fraction_);
    }
  }

  const ScanProgress& progress_;
  std::string left_;  // half a piece of news
  ScanStep step_ = ScanStep::kReading;
  double fraction_ = 0.0;
  std::chrono::steady_clock::time_point told_ = std::chrono::steady_clock::now();
};

/// Lets the other process answer a request, whose first word is the scan; returns what it cost.
HelperEnd askedApart(ScanAnswer wanted, std::vector<std::string> request, const ScanProgress& progress,
                     const HelperLimits& limits, HelperAnswer& answer) {
  const std::string where = request.front();
  std::error_code failed;
  if (!std::filesystem::exists(where, failed)) {
    throw Error(ErrorCode::kFileMissing, Text::tr("there is no such file"), where,
                Text::tr("Check the path"));
  }
  if (!answer.valid()) {
    refuseScan(Text::tr("D04 the system gives no memory to read the scan"), where,
               Text::tr("Close other programs and try again"));
  }
  const std::string program = helperProgram("TORSIO_SCAN_PROGRAM", "torsio-scan");
  std::vector<std::string> words{program, std::to_string(limits.memory_MB),
                                 std::to_string(limits.processor_s),
                                 std::to_string(static_cast<int>(wanted))};
  for (std::string& word : request) {
    words.push_back(std::move(word));
  }
  ScanNews news(progress);
  const HelperEnd end =
      runHelper(words, answer, limits, [&news](std::span<const char> bytes) { news.take(bytes); });
  requireScanEnded(end, where, program);
  return end;
}

}  // namespace

ScanApart scanApart(const ScanRequest& request, const ScanProgress& progress, const HelperLimits& limits) {
  requireScanRequest(request);
  HelperAnswer answer;
  const HelperEnd end = askedApart(ScanAnswer::kSurface, wordsOf(request), progress, limits, answer);
  return {scanOfMail(answer.bytes(), request.source.string()), end.processor_s, end.peak_MB};
}

ScanPreview previewApart(const ScanRequest& request, bool find, const ScanProgress& progress,
                         const HelperLimits& limits) {
  requireScanRequest(request);
  HelperAnswer answer;
  askedApart(find ? ScanAnswer::kOrgan : ScanAnswer::kSlices, wordsOf(request), progress, limits, answer);
  return previewOfMail(answer.bytes(), request.source.string());
}

ToolSurface toolApart(const ToolRequest& request, const ScanProgress& progress, const HelperLimits& limits) {
  requireToolRequest(request);
  HelperAnswer answer;
  askedApart(ScanAnswer::kTool, wordsOf(request), progress, limits, answer);
  return toolOfMail(answer.bytes(), request.source.string());
}

}  // namespace torsio
