// A file given to the wrong reader is told what it is and which command takes it.

#include "specs/file_kind.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>

#include "specs/generator_spec.hpp"
#include "specs/linkages/linkage_file.hpp"
#include "specs/measurements.hpp"
#include "specs/spec_reader.hpp"

namespace kempe {
namespace {

namespace fs = std::filesystem;

const fs::path examples_folder = fs::path(KEMPE_SOURCE_DIR) / "specs/examples";

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::multimap<FileKind, fs::path> shipped() {
  std::multimap<FileKind, fs::path> files;
  for (const auto& [folder, kind] : std::map<std::string, FileKind>{
           {".", FileKind::spec}, {"linkages", FileKind::linkage}, {"calibration", FileKind::measurements}})
    for (const auto& entry : fs::directory_iterator(examples_folder / folder))
      if (entry.path().extension() == ".toml") files.emplace(kind, entry.path());
  for (const char* name : {"logarithm.toml", "table.toml"})
    files.emplace(FileKind::function, examples_folder / "generators" / name);
  for (const char* name : {"copy-camera.toml", "enlarger.toml"})
    files.emplace(FileKind::inversor, examples_folder / "generators" / name);
  for (const char* name : {"loop.toml", "straight-line.toml", "five-poses.toml"})
    files.emplace(FileKind::path, examples_folder / "generators" / name);
  files.emplace(FileKind::design, examples_folder / "calibration/drawing-pantograph.json");
  files.emplace(FileKind::drawing, fs::path(KEMPE_SOURCE_DIR) / "docs/pictures/letter.svg");
  return files;
}

/// What a reader of this kind says of a text; nothing if it takes it.
std::optional<InputError> said_by(FileKind reader, const std::string& text) {
  const auto error = [](const auto& read) {
    return read ? std::optional<InputError>() : std::optional(read.error());
  };
  switch (reader) {
    case FileKind::linkage: return error(parse_linkage_file(text, "f"));
    case FileKind::measurements: return error(read_measurements(text, "f"));
    case FileKind::function: return error(read_function_spec(text, "f"));
    case FileKind::inversor: return error(read_inversor_spec(text, "f"));
    case FileKind::path: return error(read_path_spec(text, "f"));
    default: return error(read_spec(text, "f", examples_folder));
  }
}

TEST(FileKind, OfEveryShippedFileIsRecognised) {
  const auto files = shipped();
  EXPECT_GT(files.size(), 30u);
  for (const auto& [kind, file] : files) EXPECT_EQ(recognised_kind(text_of(file)), kind) << file;
}

TEST(FileKind, OfAnotherFileIsToldByEveryReaderAsTheOneFault) {
  constexpr FileKind readers[] = {FileKind::spec,     FileKind::linkage,  FileKind::measurements,
                                  FileKind::function, FileKind::inversor, FileKind::path};
  for (const auto& [kind, file] : shipped())
    for (const FileKind reader : readers) {
      const auto said = said_by(reader, text_of(file));
      if (kind == reader) {
        EXPECT_FALSE(said) << file << said->message();
        continue;
      }
      ASSERT_TRUE(said) << file;
      EXPECT_TRUE(said->others.empty()) << said->messages();
      EXPECT_NE(said->allowed.find("; kempe "), std::string::npos) << said->message();
    }
}

TEST(FileKind, OfOtherFormsIsRecognised) {
  EXPECT_EQ(recognised_kind("\xEF\xBB\xBF\n{\"copy\": {\"scale\": 2}, \"region\": {}}"), FileKind::json_spec);
  EXPECT_EQ(recognised_kind("{\"spec\": {}, \"axes\": []}"), FileKind::sweep);
  EXPECT_EQ(recognised_kind("{\"type\": \"FeatureCollection\", \"features\": []}"), FileKind::drawing);
  EXPECT_EQ(recognised_kind("{\"format\": \"kempe-design/1\", \"copy\": {}}"), FileKind::design);
  EXPECT_EQ(recognised_kind("  0\r\nSECTION\r\n  2\r\nENTITIES\r\n"), FileKind::drawing);
}

TEST(FileKind, OfNoiseIsNone) {
  for (const char* text :
       {"", " ", "{", "{}", "[]", "null", "<", "<html></html>", "0", "a = 1", "a = ", "\x80\xFF"})
    EXPECT_FALSE(recognised_kind(text)) << text;
  const InputError fault{"f", 3, "key", "found", "allowed"};
  EXPECT_EQ(or_other_kind(fault, "a = 1", FileKind::spec).line, 3);
  EXPECT_EQ(or_other_kind(fault, "[copy]\nscale = 0", FileKind::spec).line, 3);
}

}  // namespace
}  // namespace kempe
