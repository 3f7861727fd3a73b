// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/dicom_files.h"

#include <cmath>
#include <cstdio>
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dcrlerp.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djencode.h>
#include <dcmtk/dcmjpeg/djrplol.h>
#include <dcmtk/dcmjpls/djencode.h>
#include <dcmtk/dcmjpls/djrparam.h>
#include <stdexcept>
#include <vector>

namespace torsio::testing {

namespace {

E_TransferSyntax syntaxNamed(const std::string& name) {
  return name == "deflated"     ? EXS_DeflatedLittleEndianExplicit
         : name == "big-endian" ? EXS_BigEndianExplicit
         : name == "rle"        ? EXS_RLELossless
         : name == "jpeg"       ? EXS_JPEGProcess14SV1
         : name == "jpeg-ls"    ? EXS_JPEGLSLossless
         : name == "implicit"   ? EXS_LittleEndianImplicit
                                : EXS_LittleEndianExplicit;
}

void putNumbers(DcmDataset& data, const DcmTagKey& tag, const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) {
    char one[32];
    std::snprintf(one, sizeof(one), "%s%.10g", text.empty() ? "" : "\\", number);
    text += one;
  }
  data.putAndInsertString(tag, text.c_str());
}

void putPixels(DcmDataset& data, const ScanVolume& scan, std::size_t k, const DicomStyle& style) {
  data.putAndInsertUint16(DCM_Rows, static_cast<Uint16>(scan.count[1]));
  data.putAndInsertUint16(DCM_Columns, static_cast<Uint16>(scan.count[0]));
  data.putAndInsertUint16(DCM_SamplesPerPixel, 1);
  data.putAndInsertString(DCM_PhotometricInterpretation, "MONOCHROME2");
  data.putAndInsertUint16(DCM_BitsAllocated, 16);
  data.putAndInsertUint16(DCM_BitsStored, style.isSigned ? 16 : 12);
  data.putAndInsertUint16(DCM_HighBit, style.isSigned ? 15 : 11);
  data.putAndInsertUint16(DCM_PixelRepresentation, style.isSigned ? 1 : 0);
  putNumbers(data, DCM_RescaleSlope, {style.slope});
  putNumbers(data, DCM_RescaleIntercept, {style.intercept});
  std::vector<Uint16> pixels;
  for (std::size_t n = 0; n < scan.count[0] * scan.count[1]; ++n) {
    const double stored =
        (scan.values[k * scan.count[0] * scan.count[1] + n] - style.intercept) / style.slope;
    pixels.push_back(static_cast<Uint16>(static_cast<std::int16_t>(std::lround(stored))));
  }
  data.putAndInsertUint16Array(DCM_PixelData, pixels.data(), static_cast<unsigned long>(pixels.size()));
}

}  // namespace

void writeDicomSeries(const std::filesystem::path& folder, const ScanVolume& scan, const DicomStyle& style) {
  static const bool kRegistered = [] {
    OFLog::configure(OFLogger::OFF_LOG_LEVEL);
    DcmRLEEncoderRegistration::registerCodecs();
    DJEncoderRegistration::registerCodecs();
    DJLSEncoderRegistration::registerCodecs();
    return true;
  }();
  static_cast<void>(kRegistered);
  std::filesystem::create_directories(folder);
  const E_TransferSyntax syntax = syntaxNamed(style.syntax);
  for (std::size_t k = 0; k < scan.count[2]; ++k) {
    DcmFileFormat format;
    DcmDataset& data = *format.getDataset();
    data.putAndInsertString(DCM_SOPClassUID, UID_CTImageStorage);
    data.putAndInsertString(DCM_SOPInstanceUID, (style.series + "." + std::to_string(k + 1)).c_str());
    data.putAndInsertString(DCM_SeriesInstanceUID, style.series.c_str());
    data.putAndInsertString(DCM_PatientName, "Doe^Jane");
    data.putAndInsertString(DCM_PatientID, "PID4711");
    data.putAndInsertString(DCM_PatientBirthDate, "19670401");
    data.putAndInsertString(DCM_Modality, style.modality.c_str());
    data.putAndInsertString(DCM_ImageType, "ORIGINAL\\PRIMARY\\AXIAL");
    putNumbers(data, DCM_SliceThickness, {99.0});  // wrong, as in real files
    const Vec3 at = scan.place_mm({0, 0, static_cast<double>(k)});
    putNumbers(data, DCM_ImagePositionPatient, {at.x, at.y, at.z});
    const Vec3 row = normalized(scan.step_mm[0]);
    const Vec3 column = normalized(scan.step_mm[1]);
    putNumbers(data, DCM_ImageOrientationPatient, {row.x, row.y, row.z, column.x, column.y, column.z});
    putNumbers(data, DCM_PixelSpacing, {norm(scan.step_mm[1]), norm(scan.step_mm[0])});
    putPixels(data, scan, k, style);
    if (style.change) {
      style.change(data, k);
    }
    const DJ_RPLossless jpeg;
    const DJLSRepresentationParameter jpegLs;
    const DcmRLERepresentationParameter rle;
    const DcmRepresentationParameter* const how = syntax == EXS_JPEGProcess14SV1 ? &jpeg
                                                  : syntax == EXS_JPEGLSLossless ? &jpegLs
                                                  : syntax == EXS_RLELossless
                                                      ? static_cast<const DcmRepresentationParameter*>(&rle)
                                                      : nullptr;
    // The order of files is unrelated to that of slices.
    const std::size_t number = (7 * k + 3) % 1000 + 1000 * (k / 1000);
    const auto file = folder / (style.names + std::to_string(number) + ".dcm");
    if (data.chooseRepresentation(syntax, how).bad() || format.saveFile(file.c_str(), syntax).bad()) {
      throw std::runtime_error("a slice could not be written");
    }
  }
}

}  // namespace torsio::testing
