// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/pdf_outline.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <utility>

#include "sim/base/refusal.h"

namespace torsio {

namespace {

constexpr double kUpperEdge_mm = 297.0;
constexpr double kPointsPerMm = 72.0 / 25.4;
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

[[noreturn]] void refuseForm(const char* missing) {
  refuse(Text::tr("the pages cannot be given bookmarks: %1 is missing", missing), Text::tr("report"),
         Text::tr("Write the report again"));
}

/// The number behind the last `key` of the file.
std::uint64_t lastNumber(const std::string& pdf, const char* key) {
  const std::size_t at = pdf.rfind(key);
  if (at == std::string::npos) {
    refuseForm(key);
  }
  return std::strtoull(pdf.c_str() + at + std::char_traits<char>::length(key), nullptr, 10);
}

/// What stands between "N 0 obj" and "endobj".
std::string objectText(const std::string& pdf, std::uint64_t id) {
  const std::string head = "\n" + std::to_string(id) + " 0 obj";
  const std::size_t at = pdf.rfind(head);
  const std::size_t end = pdf.find("endobj", at == std::string::npos ? 0 : at);
  if (at == std::string::npos || end == std::string::npos) {
    refuseForm("obj");
  }
  return pdf.substr(at + head.size(), end - at - head.size());
}

std::vector<std::uint64_t> pageIds(const std::string& pdf, const std::string& catalog) {
  const std::string pages = objectText(pdf, lastNumber(catalog, "/Pages "));
  std::size_t at = pages.find("/Kids");
  const std::size_t end = pages.find(']', at == std::string::npos ? 0 : at);
  at = pages.find('[', at == std::string::npos ? 0 : at);
  if (at == std::string::npos || end == std::string::npos) {
    refuseForm("/Kids");
  }
  std::vector<std::uint64_t> ids;
  for (const char* next = pages.c_str() + at + 1; next < pages.c_str() + end;) {
    char* after = nullptr;
    const std::uint64_t id = std::strtoull(next, &after, 10);
    const std::size_t reference = pages.find(" 0 R", static_cast<std::size_t>(after - pages.c_str()));
    if (after == next || reference == std::string::npos || reference > end) {
      break;
    }
    ids.push_back(id);
    next = pages.c_str() + reference + 4;
  }
  return ids;
}

/// A text string of a PDF: UTF-16 with a byte order mark, in hexadecimal.
std::string textString(const QString& text) {
  std::string hex = "<FEFF";
  for (const QChar letter : text) {
    char four[8];
    std::snprintf(four, sizeof four, "%04X", static_cast<unsigned>(letter.unicode()));
    hex += four;
  }
  return hex + ">";
}

/// How the entries hang together.
struct Entry {
  std::size_t parent = kNone;  // kNone: the root
  std::size_t first = kNone;
  std::size_t last = kNone;
  std::size_t previous = kNone;
  std::size_t next = kNone;
  std::size_t below = 0;
};

std::vector<Entry> treeOf(const std::vector<PdfBookmark>& bookmarks) {
  std::vector<Entry> entries(bookmarks.size());
  std::size_t section = kNone;
  std::size_t before = kNone;  // the last one of the same parent
  std::size_t sectionBefore = kNone;
  for (std::size_t i = 0; i < bookmarks.size(); ++i) {
    const bool top = bookmarks[i].level == 0 || section == kNone;
    if (top) {
      entries[i].previous = sectionBefore;
      sectionBefore = section = i;
      before = kNone;
    } else {
      entries[i].parent = section;
      entries[i].previous = before;
      entries[section].first = entries[section].first == kNone ? i : entries[section].first;
      entries[section].last = i;
      ++entries[section].below;
      before = i;
    }
    if (entries[i].previous != kNone) {
      entries[entries[i].previous].next = i;
    }
  }
  return entries;
}

/// Appends objects and remembers where each begins.
class Update {
 public:
  explicit Update(std::string pdf) : pdf_(std::move(pdf)) {}

  void object(std::uint64_t id, const std::string& text) {
    offsets_.emplace_back(id, pdf_.size());
    pdf_ += std::to_string(id) + " 0 obj\n" + text + "\nendobj\n";
  }

  std::string finish(std::uint64_t size, const std::string& references) {
    const std::uint64_t before = lastNumber(pdf_, "startxref\n");
    const std::size_t at = pdf_.size();
    std::sort(offsets_.begin(), offsets_.end());
    pdf_ += "xref\n";
    for (std::size_t i = 0; i < offsets_.size();) {
      std::size_t end = i + 1;
      while (end < offsets_.size() && offsets_[end].first == offsets_[end - 1].first + 1) {
        ++end;
      }
      pdf_ += std::to_string(offsets_[i].first) + " " + std::to_string(end - i) + "\n";
      for (; i < end; ++i) {
        char line[32];
        std::snprintf(line, sizeof line, "%010llu 00000 n \n",
                      static_cast<unsigned long long>(offsets_[i].second));
        pdf_ += line;
      }
    }
    pdf_ += "trailer\n<<\n/Size " + std::to_string(size) + "\n/Prev " + std::to_string(before) + "\n" +
            references + ">>\nstartxref\n" + std::to_string(at) + "\n%%EOF\n";
    return std::move(pdf_);
  }

 private:
  std::string pdf_;
  std::vector<std::pair<std::uint64_t, std::size_t>> offsets_;
};

std::string entryText(const PdfBookmark& mark, const Entry& entry, std::uint64_t root,
                      const std::vector<std::uint64_t>& pages) {
  const auto reference = [root](const char* key, std::size_t index) {
    return index == kNone ? std::string() : std::string(key) + std::to_string(root + 1 + index) + " 0 R\n";
  };
  const std::uint64_t parent = entry.parent == kNone ? root : root + 1 + entry.parent;
  char place[64];
  std::snprintf(place, sizeof place, " 0 R /XYZ 0 %d 0]\n",
                static_cast<int>((kUpperEdge_mm - mark.top_mm) * kPointsPerMm));
  return "<<\n/Title " + textString(mark.title) + "\n/Parent " + std::to_string(parent) + " 0 R\n" +
         reference("/Prev ", entry.previous) + reference("/Next ", entry.next) +
         reference("/First ", entry.first) + reference("/Last ", entry.last) +
         (entry.below > 0 ? "/Count -" + std::to_string(entry.below) + "\n" : std::string()) + "/Dest [" +
         std::to_string(pages[std::min(mark.page, pages.size() - 1)]) + place + ">>";
}

/// Entries of the trailer that an update repeats.
std::string trailerReferences(const std::string& pdf) {
  std::string lines = "/Root " + std::to_string(lastNumber(pdf, "/Root ")) + " 0 R\n";
  const std::size_t trailer = pdf.rfind("trailer");
  if (pdf.find("/Info ", trailer) != std::string::npos) {
    lines += "/Info " + std::to_string(lastNumber(pdf, "/Info ")) + " 0 R\n";
  }
  if (const std::size_t id = pdf.find("/ID", trailer); id != std::string::npos) {
    lines += pdf.substr(id, pdf.find(']', id) + 1 - id) + "\n";
  }
  return lines;
}

}  // namespace

std::string withBookmarks(std::string pdf, const std::vector<PdfBookmark>& bookmarks,
                          const std::string& language) {
  const std::uint64_t catalogId = lastNumber(pdf, "/Root ");
  const std::uint64_t outlines = lastNumber(pdf, "/Size ");
  std::string catalog = objectText(pdf, catalogId);
  const std::vector<std::uint64_t> pages = pageIds(pdf, catalog);
  const std::size_t close = catalog.rfind(">>");
  if (pages.empty() || close == std::string::npos) {
    refuseForm("/Catalog");
  }
  std::string more = "/Lang (" + language + ")\n";
  if (!bookmarks.empty()) {
    more += "/Outlines " + std::to_string(outlines) + " 0 R\n/PageMode /UseOutlines\n";
  }
  catalog.insert(close, more);
  const std::string references = trailerReferences(pdf);
  Update update(std::move(pdf));
  update.object(catalogId, catalog.substr(catalog.find("<<")));
  if (bookmarks.empty()) {
    return update.finish(outlines, references);
  }
  const std::vector<Entry> entries = treeOf(bookmarks);
  std::size_t last = 0;
  std::size_t sections = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].parent == kNone) {
      last = i;
      ++sections;
    }
  }
  update.object(outlines, "<<\n/Type /Outlines\n/First " + std::to_string(outlines + 1) + " 0 R\n/Last " +
                              std::to_string(outlines + 1 + last) + " 0 R\n/Count " +
                              std::to_string(sections) + "\n>>");
  for (std::size_t i = 0; i < entries.size(); ++i) {
    update.object(outlines + 1 + i, entryText(bookmarks[i], entries[i], outlines, pages));
  }
  return update.finish(outlines + 1 + entries.size(), references);
}

}  // namespace torsio
