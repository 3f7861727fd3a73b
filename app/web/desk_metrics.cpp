// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/desk_metrics.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <sys/resource.h>
#include <unistd.h>

#include "app/services/base/build_info.h"

namespace torsio::web {

namespace {

/// Declares a family of metrics.
void declare(std::ostream& out, const char* name, const char* kind, const char* help) {
  out << "# TYPE " << name << " " << kind << "\n# HELP " << name << " " << help << "\n";
}

void gauge(std::ostream& out, const char* name, const char* help, double value) {
  declare(out, name, "gauge", help);
  out << name << " " << value << "\n";
}

double resident_bytes() {
  std::ifstream in("/proc/self/statm");
  double whole = 0.0;
  double resident = 0.0;
  in >> whole >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double processor_s() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

}  // namespace

void DeskMetrics::answered(const std::string& what, int status, std::chrono::nanoseconds took) {
  const double took_s = std::chrono::duration<double>(took).count();
  const auto bound = std::lower_bound(kBounds_s.begin(), kBounds_s.end(), took_s);
  const std::lock_guard lock(mutex_);
  ++answers_[{what, status}];
  Times& times = times_[what];
  ++times.within[static_cast<std::size_t>(bound - kBounds_s.begin())];
  times.sum_s += took_s;
}

std::string DeskMetrics::text(const DeskGauges& now) const {
  std::ostringstream out;
  out.precision(15);
  declare(out, "torsio_build", "info", "Version of the program");
  out << "torsio_build_info{version=\"" << softwareVersion() << "\"} 1\n";
  {
    const std::lock_guard lock(mutex_);
    declare(out, "torsio_answers", "counter", "Answers by route and status");
    for (const auto& [key, count] : answers_) {
      out << "torsio_answers_total{route=\"" << key.first << "\",status=\"" << key.second << "\"} " << count
          << "\n";
    }
    declare(out, "torsio_answer_seconds", "histogram", "Time from a request to its answer, by route");
    for (const auto& [what, times] : times_) {
      const std::string route = "{route=\"" + what + "\"";
      std::uint64_t within = 0;
      for (std::size_t i = 0; i < kBounds_s.size(); ++i) {
        within += times.within[i];
        out << "torsio_answer_seconds_bucket" << route << ",le=\"" << kBounds_s[i] << "\"} " << within
            << "\n";
      }
      within += times.within.back();
      out << "torsio_answer_seconds_bucket" << route << ",le=\"+Inf\"} " << within << "\n"
          << "torsio_answer_seconds_count" << route << "} " << within << "\n"
          << "torsio_answer_seconds_sum" << route << "} " << times.sum_s << "\n";
    }
  }
  gauge(out, "torsio_record_up", "1 if the record answers", now.recordAnswers ? 1.0 : 0.0);
  gauge(out, "torsio_sessions", "People who are signed in", static_cast<double>(now.sessions));
  gauge(out, "torsio_waiting_pages", "Pages that wait for news", static_cast<double>(now.waitingPages));
  gauge(out, "torsio_queued_requests", "Requests that wait for a thread", static_cast<double>(now.queued));
  gauge(out, "torsio_queued_passwords", "Passwords that wait to be checked",
        static_cast<double>(now.passwords));
  gauge(out, "process_resident_memory_bytes", "Memory of the process", resident_bytes());
  declare(out, "process_cpu_seconds", "counter", "Processor time of the process");
  out << "process_cpu_seconds_total " << processor_s() << "\n# EOF\n";
  return out.str();
}

}  // namespace torsio::web
