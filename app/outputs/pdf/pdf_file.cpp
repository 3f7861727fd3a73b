// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/pdf/pdf_file.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include <QByteArray>

#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::size_t kCrossReference_bytes = 20;  // of an entry
constexpr std::size_t kSizeField_bytes = 4;        // with which qCompress() begins

[[noreturn]] void refuseForm(const std::string& missing) {
  refuse(Text::tr("the pages cannot be given bookmarks: %1 is missing", missing), Text::tr("report"),
         Text::tr("Write the report again"));
}

/// The number behind `key`, which stands at or behind `from`.
std::uint64_t numberBehind(const std::string& text, const std::string& key, std::size_t from = 0) {
  const std::size_t at = text.find(key, from);
  if (at == std::string::npos) {
    refuseForm(key);
  }
  return std::strtoull(text.c_str() + at + key.size(), nullptr, 10);
}

}  // namespace

PdfFile::PdfFile(const std::string& pdf) {
  const std::size_t start = pdf.rfind("startxref\n");
  if (start == std::string::npos) {
    refuseForm("startxref");
  }
  const std::size_t table = numberBehind(pdf, "startxref\n", start);
  const std::size_t trailer = pdf.find("trailer", table);
  if (table >= start || pdf.compare(table, 5, "xref\n") != 0 || trailer == std::string::npos) {
    refuseForm("xref");
  }
  const std::size_t count = numberBehind(pdf, "/Size ", trailer);
  const std::size_t entries = pdf.find('\n', table + 5) + 1;  // behind "0 420"
  if (entries + count * kCrossReference_bytes > trailer) {
    refuseForm("xref");
  }
  std::vector<std::pair<std::size_t, std::size_t>> places;  // offset, number
  for (std::size_t id = 1; id < count; ++id) {
    const char* entry = pdf.c_str() + entries + id * kCrossReference_bytes;
    if (entry[17] == 'n') {
      places.emplace_back(std::strtoull(entry, nullptr, 10), id);
    }
  }
  std::sort(places.begin(), places.end());
  objects_.resize(count);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto [at, id] = places[i];
    const std::string begin = std::to_string(id) + " 0 obj";
    const std::size_t next = i + 1 < places.size() ? places[i + 1].first : table;
    const std::size_t end = pdf.rfind("endobj", next);
    if (next > table || pdf.compare(at, begin.size(), begin) != 0 || end == std::string::npos || end < at) {
      refuseForm(begin);
    }
    objects_[id] = pdf.substr(at + begin.size(), end - at - begin.size());
  }
  if (places.empty()) {
    refuseForm("obj");
  }
  head_ = pdf.substr(0, places.front().first);
  catalog_ = numberBehind(pdf, "/Root ", trailer);
  if (pdf.find("/Info ", trailer) != std::string::npos) {
    info_ = numberBehind(pdf, "/Info ", trailer);
  }
  if (const std::size_t id = pdf.find("/ID", trailer); id != std::string::npos) {
    id_ = pdf.substr(id, pdf.find(']', id) + 1 - id) + "\n";
  }
  readPages();
}

void PdfFile::readPages() {
  const std::string& tree = object(reference(catalog_, "/Pages "));
  const std::size_t begin = tree.find('[', std::min(tree.find("/Kids"), tree.size()));
  const std::size_t end = tree.find(']', std::min(begin, tree.size()));
  if (begin == std::string::npos || end == std::string::npos) {
    refuseForm("/Kids");
  }
  for (const char* next = tree.c_str() + begin + 1; next < tree.c_str() + end;) {
    char* after = nullptr;
    const std::uint64_t id = std::strtoull(next, &after, 10);
    const std::size_t behind = tree.find(" 0 R", static_cast<std::size_t>(after - tree.c_str()));
    if (after == next || behind == std::string::npos || behind > end) {
      break;
    }
    pages_.push_back(id);
    next = tree.c_str() + behind + 4;
  }
  if (pages_.empty()) {
    refuseForm("/Kids");
  }
}

const std::string& PdfFile::object(std::uint64_t id) const {
  if (id >= objects_.size() || objects_[id].empty()) {
    refuseForm(std::to_string(id) + " 0 obj");
  }
  return objects_[id];
}

void PdfFile::replace(std::uint64_t id, std::string text) {
  (void)object(id);
  objects_[id] = "\n" + std::move(text) + "\n";
}

std::uint64_t PdfFile::add(std::string text) {
  objects_.push_back("\n" + std::move(text) + "\n");
  return objects_.size() - 1;
}

void PdfFile::addTo(std::uint64_t id, const std::string& lines) {
  const std::size_t close = object(id).rfind(">>");
  if (close == std::string::npos) {
    refuseForm(">>");
  }
  objects_[id].insert(close, lines);
}

std::uint64_t PdfFile::reference(std::uint64_t id, const std::string& key) const {
  return numberBehind(object(id), key);
}

std::string PdfFile::stream(std::uint64_t id) const {
  const std::string& text = object(id);
  const std::size_t begin = text.find("stream\n");
  const std::size_t end = text.rfind("endstream");
  if (begin == std::string::npos || end == std::string::npos || end < begin + 7) {
    refuseForm("stream");
  }
  const std::string content = text.substr(begin + 7, end - begin - 7);
  if (text.find("/FlateDecode") > begin) {
    return content;
  }
  QByteArray packed(static_cast<qsizetype>(kSizeField_bytes), '\0');  // what is expected: grows by itself
  packed.append(content.data(), static_cast<qsizetype>(content.size()));
  return qUncompress(packed).toStdString();
}

void PdfFile::setStream(std::uint64_t id, const std::string& content) {
  const QByteArray packed =
      qCompress(QByteArray::fromRawData(content.data(), static_cast<qsizetype>(content.size())));
  const std::string bytes = packed.mid(static_cast<qsizetype>(kSizeField_bytes)).toStdString();
  replace(id, "<<\n/Length " + std::to_string(bytes.size()) + "\n/Filter /FlateDecode\n>>\nstream\n" + bytes +
                  "\nendstream");
}

std::string PdfFile::written() const {
  std::string pdf = head_;
  std::string table = "xref\n0 " + std::to_string(objects_.size()) + "\n0000000000 65535 f \n";
  for (std::size_t id = 1; id < objects_.size(); ++id) {
    char line[32];
    std::snprintf(line, sizeof line, "%010zu %s \n", objects_[id].empty() ? std::size_t{0} : pdf.size(),
                  objects_[id].empty() ? "65535 f" : "00000 n");
    table += line;
    if (!objects_[id].empty()) {
      pdf += std::to_string(id) + " 0 obj" + objects_[id] + "endobj\n";
    }
  }
  const std::size_t at = pdf.size();
  pdf += table + "trailer\n<<\n/Size " + std::to_string(objects_.size()) + "\n/Root " +
         referenceTo(catalog_) + "\n";
  if (info_ != 0) {
    pdf += "/Info " + referenceTo(info_) + "\n";
  }
  return pdf + id_ + ">>\nstartxref\n" + std::to_string(at) + "\n%%EOF\n";
}

std::string PdfFile::textString(const QString& text) {
  std::string hex = "<FEFF";
  for (const QChar letter : text) {
    char four[8];
    std::snprintf(four, sizeof four, "%04X", static_cast<unsigned>(letter.unicode()));
    hex += four;
  }
  return hex + ">";
}

std::string PdfFile::referenceTo(std::uint64_t id) {
  return std::to_string(id) + " 0 R";
}

}  // namespace torsio
