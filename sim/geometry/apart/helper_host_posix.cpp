// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <cstddef>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "sim/core/file_io.h"
#include "sim/geometry/apart/helper_host.h"
#include "sim/geometry/apart/helper_process.h"

namespace torsio {

namespace {

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
