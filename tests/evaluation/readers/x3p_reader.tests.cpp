#include "evaluation/readers/x3p_reader.h"

#include <zip.h>

#include <catch2/catch.hpp>
#include <map>

#include "tests/support/damaged_files.h"
#include "tests/support/foreign_files.h"
#include "tests/support/temporary_folder.h"

namespace {

using Entries = std::map<std::string, std::string>;

/// The entries of an archive, by libzip itself.
Entries entries_of(const std::string& name) {
  zip_t* const archive = zip_open(foreign_file(name).c_str(), ZIP_RDONLY, nullptr);
  REQUIRE(archive);
  Entries entries;
  for (zip_int64_t i = 0; i < zip_get_num_entries(archive, 0); ++i) {
    zip_stat_t stat;
    zip_stat_index(archive, static_cast<zip_uint64_t>(i), 0, &stat);
    zip_file_t* const file = zip_fopen_index(archive, static_cast<zip_uint64_t>(i), 0);
    std::string& bytes = entries[stat.name];
    bytes.resize(stat.size);
    REQUIRE(zip_fread(file, bytes.data(), stat.size) == static_cast<zip_int64_t>(stat.size));
    zip_fclose(file);
  }
  zip_discard(archive);
  return entries;
}

std::string archive_of(const Entries& entries) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "archive.x3p";
  zip_t* const archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
  REQUIRE(archive);
  for (const auto& [name, bytes] : entries)
    zip_file_add(archive, name.c_str(), zip_source_buffer(archive, bytes.data(), bytes.size(), 0),
                 0);
  REQUIRE(zip_close(archive) == 0);
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void replace(std::string& text, const std::string& from, const std::string& to) {
  REQUIRE(text.find(from) != std::string::npos);
  text.replace(text.find(from), from.size(), to);
}

/// An archive whose main.xml is changed, without the checksum of it.
std::string with_change(const std::string& name, const std::string& from, const std::string& to) {
  Entries entries = entries_of(name);
  entries.erase("md5checksum.hex");
  replace(entries.at("main.xml"), from, to);
  return archive_of(entries);
}

struct Foreign {
  std::string type, format;
  double unit_m;
  bool has_hole;
};

}  // namespace

TEST_CASE("X3P surfaces give every type to the last bit", "[readers][oracle]") {
  for (const Foreign& file : std::vector<Foreign>{{"float64", "64 bit float", 1, true},
                                                  {"float32", "32 bit float", 1, false},
                                                  {"int16", "16 bit signed", 1e-10, true},
                                                  {"int32", "32 bit signed", 1e-16, false}}) {
    INFO(file.type);
    brdf::HeightArray expected = foreign_values(file.type + ".csv");
    if (file.has_hole) expected(4, 2) = no_height;
    const evaluation::RawHeights raw = decoded(foreign_file("zipfile_" + file.type + ".x3p"));
    check_same_bits(raw.values, expected);
    CHECK(raw.format == "X3P, " + file.format);
    CHECK(raw.pixel_x->um() == Approx(0.5).epsilon(1e-14));
    CHECK(raw.pixel_y->um() == Approx(0.25).epsilon(1e-14));
    CHECK(raw.unit->um() == Approx(1e6 * file.unit_m).epsilon(1e-14));
  }
}

TEST_CASE("an offset of heights is added, in their unit", "[readers]") {
  std::string bytes =
      with_change("zipfile_int32.x3p", "<Offset>0</Offset></CZ>", "<Offset>5e-16</Offset></CZ>");
  const brdf::HeightArray difference = decoded_bytes(bytes).values - foreign_values("int32.csv");
  CHECK((difference == 5.0).all());
}

TEST_CASE("an X3P cut after any byte is refused", "[readers]") {
  for (const char* name : {"zipfile_int16.x3p", "zipfile_float32.x3p"})
    check_refused_wherever_cut(foreign_bytes(name));
}

TEST_CASE("a damaged X3P is refused by the checksum that it breaks", "[readers]") {
  const std::string name = "zipfile_float32.x3p";
  // The sum of the archive: data stored as they are, one bit changed.
  std::string bytes = foreign_bytes(name);
  const Entries whole = entries_of(name);
  char& byte = bytes[bytes.find(whole.at("bindata/data.bin")) + 7];
  byte = static_cast<char>(byte ^ 1);
  check_names(decoder_refusal(bytes), "bindata/data.bin cannot be read");
  Entries entries = whole;
  entries.at("bindata/data.bin")[7] ^= 1;
  check_names(decoder_refusal(archive_of(entries)), "bindata/data.bin is damaged");
  entries = whole;
  replace(entries.at("main.xml"), "5e-7", "6e-7");
  check_names(decoder_refusal(archive_of(entries)), "main.xml is damaged");
}

TEST_CASE("an X3P of another kind is refused by name", "[readers]") {
  const auto check = [](const std::string& from, const std::string& to, const std::string& part) {
    check_names(decoder_refusal(with_change("zipfile_float64.x3p", from, to)), part);
  };
  check(">SUR<", ">PCL<", "Record1/FeatureType is \"PCL\"");
  check("<CX><AxisType>I<", "<CX><AxisType>A<", "Record1/Axes/CX/AxisType is \"A\"");
  check("<CY><AxisType>I<", "<CY><AxisType>A<", "Record1/Axes/CY/AxisType");
  check("<DataType>D</DataType><Increment>1<", "<DataType>Q</DataType><Increment>1<", "\"Q\"");
  check("<Increment>5e-7<", "<Increment>-5e-7<", "CX/Increment");
  check("<Increment>2.5e-7<", "<Increment>one<", "CY/Increment");
  check("<SizeZ>1<", "<SizeZ>2<", "SizeZ");
  check("<SizeX>17<", "<SizeX>18<", "1496 bytes, main.xml asks for 1584");
  check("<SizeX>17<", "<SizeX>0<", "0 x 11");
  check("<SizeX>17<", "<SizeX>99999999999999999999<", "SizeX");
  check("<SizeX>17<", "<SizeX>1000000000<", "1000000000 x 11");
  check("data.bin", "nowhere.bin", "bindata/nowhere.bin");
  check("DataLink>", "DataList>", "main.xml");
  check("<Record1>", "<Record1", "no sound XML");
  check("ISO5436_2", "ISO5436_3", "main.xml");
  Entries entries = entries_of("zipfile_float64.x3p");
  entries.erase("main.xml");
  check_names(decoder_refusal(archive_of(entries)), "main.xml");
}

TEST_CASE("entities of an X3P are not expanded", "[readers]") {
  // Ten thousand millions of letters, where a parser expands them.
  std::string entities = "<!DOCTYPE x [<!ENTITY a0 \"aaaaaaaaaa\">";
  for (int i = 1; i < 10; ++i) {
    const std::string inner = "&a" + std::to_string(i - 1) + ";";
    entities += "<!ENTITY a" + std::to_string(i) + " \"";
    for (int k = 0; k < 10; ++k) entities += inner;
    entities += "\">";
  }
  Entries entries = entries_of("zipfile_float64.x3p");
  entries.erase("md5checksum.hex");
  replace(entries.at("main.xml"), "<p:ISO5436_2", entities + "]>\n<p:ISO5436_2");
  replace(entries.at("main.xml"), ">SUR<", ">&a9;<");
  check_names(decoder_refusal(archive_of(entries)), "FeatureType is \"&a9;\"");
}

TEST_CASE("a description that is too long is not unpacked", "[readers]") {
  Entries entries = entries_of("zipfile_float64.x3p");
  entries.at("main.xml").append(1 << 20, ' ');
  check_names(decoder_refusal(archive_of(entries)), "at most 1048576");
}
