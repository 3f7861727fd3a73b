// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/pdf/pdf_tags.h"

#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>

#include <QPainter>

#include "app/outputs/pdf/pdf_file.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::uint64_t kMark = 50'000'000;  // device units left of the page: nothing else is drawn there
constexpr char kMarkBegin[] = "\n-";
constexpr char kMarkEnd[] = "0 1 1 re\nf\n";

const char* structureName(PdfRole role) {
  switch (role) {
    case PdfRole::kSection:
      return "H1";
    case PdfRole::kTitle:
      return "H2";
    case PdfRole::kFigure:
      return "Figure";
    case PdfRole::kHeaderCell:
      return "TH";
    case PdfRole::kCell:
      return "TD";
    case PdfRole::kArtifact:
    case PdfRole::kParagraph:
      break;
  }
  return "P";
}

/// A part that was found in the drawing of a page: its number there.
using Found = std::map<std::size_t, std::size_t>;

/// Puts the names of the parts into the drawing of a page, where their marks were.
std::string taggedDrawing(const std::string& drawing, const std::vector<PdfPart>& parts, Found& found) {
  std::string tagged;
  std::size_t from = 0;
  bool open = false;
  std::size_t number = 0;
  for (std::size_t at = drawing.find(kMarkBegin); at != std::string::npos;
       at = drawing.find(kMarkBegin, at + 1)) {
    char* after = nullptr;
    const std::uint64_t place = std::strtoull(drawing.c_str() + at + 2, &after, 10);
    const std::size_t end = drawing.find(kMarkEnd, static_cast<std::size_t>(after - drawing.c_str()));
    if (place < kMark || place - kMark >= parts.size() || end == std::string::npos ||
        end > static_cast<std::size_t>(after - drawing.c_str()) + 1) {
      continue;
    }
    const std::size_t part = place - kMark;
    tagged.append(drawing, from, at + 1 - from).append(open ? "EMC\n" : "");
    if (parts[part].role == PdfRole::kArtifact) {
      tagged += "/Artifact BMC\n";
    } else {
      tagged.append("/").append(structureName(parts[part].role)) +=
          " <</MCID " + std::to_string(number) + ">> BDC\n";
      found[part] = number++;
    }
    open = true;
    from = end + sizeof kMarkEnd - 1;
  }
  tagged.append(drawing, from);
  return open ? tagged + "\nEMC\n" : tagged;
}

/// The tree of what the file holds, while it grows.
class Structure {
 public:
  Structure(PdfFile& pdf, const std::vector<PdfPart>& parts)
      : pdf_(pdf), parts_(parts), root_(pdf.add("<<>>")), document_(pdf.add("<<>>")) {}

  /// Numbers of the elements of a page, by their number in its drawing.
  std::vector<std::uint64_t> addPage(const Found& found, std::uint64_t page) {
    std::vector<std::uint64_t> elements(found.size());
    for (const auto& [part, number] : found) {
      elements[number] = addElement(parts_[part], number, page);
    }
    return elements;
  }

  void finish(const std::string& parents, std::size_t pages) {
    closeTable();
    pdf_.replace(document_, "<<\n/Type /StructElem\n/S /Document\n/P " + PdfFile::referenceTo(root_) +
                                "\n/K [" + kids_ + "]\n>>");
    pdf_.replace(root_, "<<\n/Type /StructTreeRoot\n/K " + PdfFile::referenceTo(document_) +
                            "\n/ParentTree " +
                            PdfFile::referenceTo(pdf_.add("<<\n/Nums [" + parents + "]\n>>")) +
                            "\n/ParentTreeNextKey " + std::to_string(pages) + "\n>>");
    pdf_.addTo(pdf_.catalog(),
               "/MarkInfo <</Marked true>>\n/StructTreeRoot " + PdfFile::referenceTo(root_) + "\n");
  }

 private:
  std::uint64_t addElement(const PdfPart& part, std::size_t number, std::uint64_t page) {
    std::uint64_t parent = document_;
    if (part.table != 0) {
      openRow(part);
      parent = row_;
    } else {
      closeTable();
    }
    std::string text = "<<\n/Type /StructElem\n/S /" + std::string(structureName(part.role)) + "\n/P " +
                       PdfFile::referenceTo(parent) + "\n/Pg " + PdfFile::referenceTo(page) + "\n/K " +
                       std::to_string(number) + "\n";
    if (part.role == PdfRole::kFigure) {
      text += "/Alt " + PdfFile::textString(part.instead) + "\n";
    }
    if (part.role == PdfRole::kHeaderCell) {
      text += "/A <</O /Table /Scope /Column>>\n";
    }
    const std::uint64_t element = pdf_.add(text + ">>");
    (part.table != 0 ? cells_ : kids_) += PdfFile::referenceTo(element) + " ";
    return element;
  }

  void openRow(const PdfPart& part) {
    if (part.table != table_) {
      closeTable();
      table_ = part.table;
      tableElement_ = pdf_.add("<<>>");
      kids_ += PdfFile::referenceTo(tableElement_) + " ";
    } else if (part.row == rowNumber_ && row_ != 0) {
      return;
    }
    closeRow();
    rowNumber_ = part.row;
    row_ = pdf_.add("<<>>");
    rows_ += PdfFile::referenceTo(row_) + " ";
  }

  void closeRow() {
    if (row_ != 0) {
      pdf_.replace(row_, "<<\n/Type /StructElem\n/S /TR\n/P " + PdfFile::referenceTo(tableElement_) +
                             "\n/K [" + cells_ + "]\n>>");
    }
    row_ = 0;
    cells_.clear();
  }

  void closeTable() {
    closeRow();
    if (table_ != 0) {
      pdf_.replace(tableElement_, "<<\n/Type /StructElem\n/S /Table\n/P " + PdfFile::referenceTo(document_) +
                                      "\n/K [" + rows_ + "]\n>>");
    }
    table_ = 0;
    rows_.clear();
  }

  PdfFile& pdf_;
  const std::vector<PdfPart>& parts_;
  std::uint64_t root_;
  std::uint64_t document_;
  std::uint64_t tableElement_ = 0;
  std::uint64_t row_ = 0;  // 0: none is open
  std::size_t table_ = 0;
  std::size_t rowNumber_ = 0;
  std::string kids_;
  std::string rows_;
  std::string cells_;
};

}  // namespace

void markPart(QPainter& painter, std::size_t part) {
  painter.fillRect(QRectF(-static_cast<double>(kMark + part), 0.0, 1.0, 1.0), Qt::black);
}

void addTags(PdfFile& pdf, const std::vector<PdfPart>& parts) {
  Structure structure(pdf, parts);
  std::string parents;
  for (std::size_t p = 0; p < pdf.pages().size(); ++p) {
    const std::uint64_t page = pdf.pages()[p];
    const std::uint64_t contents = pdf.reference(page, "/Contents ");
    Found found;
    pdf.setStream(contents, taggedDrawing(pdf.stream(contents), parts, found));
    pdf.addTo(page, "/StructParents " + std::to_string(p) + "\n");
    parents += std::to_string(p) + " [";
    for (const std::uint64_t element : structure.addPage(found, page)) {
      parents += PdfFile::referenceTo(element) + " ";
    }
    parents += "]\n";
  }
  structure.finish(parents, pdf.pages().size());
}

void addDescription(PdfFile& pdf, const QString& author, const QString& language) {
  pdf.addTo(pdf.catalog(),
            "/Lang (" + language.toStdString() + ")\n/ViewerPreferences <</DisplayDocTitle true>>\n");
  pdf.addTo(pdf.info(), "/Author " + PdfFile::textString(author) + "\n");
  const std::uint64_t metadata = pdf.reference(pdf.catalog(), "/Metadata ");
  std::string xml = pdf.stream(metadata);
  const std::string behind = "</dc:title>";
  const std::size_t at = xml.find(behind);
  if (at == std::string::npos) {
    refuse(Text::tr("the description of the pages has no title"), Text::tr("report"),
           Text::tr("Write the report again"));
  }
  xml.insert(at + behind.size(),
             QStringLiteral("<dc:creator><rdf:Seq><rdf:li>%1</rdf:li></rdf:Seq></dc:creator>"
                            "<dc:language><rdf:Bag><rdf:li>%2</rdf:li></rdf:Bag></dc:language>")
                 .arg(author.toHtmlEscaped(), language.toHtmlEscaped())
                 .toStdString());
  while (!xml.empty() && xml.back() == '\n') {
    xml.pop_back();
  }
  // Uncompressed: whoever cannot read PDF finds it by looking for it.
  pdf.replace(metadata, "<<\n/Type /Metadata /Subtype /XML\n/Length " + std::to_string(xml.size()) +
                            "\n>>\nstream\n" + xml + "\nendstream");
}

}  // namespace torsio
