// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/pdf/pdf_outline.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>

#include "app/outputs/pdf/pdf_file.h"

namespace torsio {

namespace {

constexpr double kUpperEdge_mm = 297.0;
constexpr double kPointsPerMm = 72.0 / 25.4;
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

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

/// The text of an entry; the entries have the numbers behind that of the root, `outlines`.
std::string entryText(const PdfBookmark& mark, const Entry& entry, std::uint64_t outlines,
                      const std::vector<std::uint64_t>& pages) {
  const auto line = [outlines](const char* key, std::size_t at) {
    return at == kNone ? std::string() : key + PdfFile::referenceTo(outlines + 1 + at) + "\n";
  };
  const std::uint64_t parent = entry.parent == kNone ? outlines : outlines + 1 + entry.parent;
  char place[64];
  std::snprintf(place, sizeof place, " /XYZ 0 %d 0]\n",
                static_cast<int>((kUpperEdge_mm - mark.top_mm) * kPointsPerMm));
  return "<<\n/Title " + PdfFile::textString(mark.title) + "\n/Parent " + PdfFile::referenceTo(parent) +
         "\n" + line("/Prev ", entry.previous) + line("/Next ", entry.next) + line("/First ", entry.first) +
         line("/Last ", entry.last) +
         (entry.below > 0 ? "/Count -" + std::to_string(entry.below) + "\n" : std::string()) + "/Dest [" +
         PdfFile::referenceTo(pages[std::min(mark.page, pages.size() - 1)]) + place + ">>";
}

}  // namespace

void addBookmarks(PdfFile& pdf, const std::vector<PdfBookmark>& bookmarks) {
  if (bookmarks.empty()) {
    return;
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
  const std::uint64_t outlines = pdf.add("<<>>");
  pdf.replace(outlines, "<<\n/Type /Outlines\n/First " + PdfFile::referenceTo(outlines + 1) + "\n/Last " +
                            PdfFile::referenceTo(outlines + 1 + last) + "\n/Count " +
                            std::to_string(sections) + "\n>>");
  for (std::size_t i = 0; i < entries.size(); ++i) {
    pdf.add(entryText(bookmarks[i], entries[i], outlines, pdf.pages()));
  }
  pdf.addTo(pdf.catalog(), "/Outlines " + PdfFile::referenceTo(outlines) + "\n/PageMode /UseOutlines\n");
}

}  // namespace torsio
