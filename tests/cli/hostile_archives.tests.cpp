#include <zlib.h>

#include <stdexcept>

#include "tests/cli/hostile_files.h"

namespace {

/// An entry of a zip archive, and what its directory says of its length.
struct Entry {
  std::string name, bytes;
  std::uint64_t declared;
  std::string packed;
};

std::string deflated(const std::string& bytes) {
  std::string packed(compressBound(bytes.size()), '\0');
  z_stream stream{};
  if (deflateInit2(&stream, 9, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("zlib");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  if (deflate(&stream, Z_FINISH) != Z_STREAM_END) throw std::runtime_error("zlib");
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

Entry entry(const std::string& name, const std::string& bytes) {
  return {name, bytes, bytes.size(), deflated(bytes)};
}

/// What the local and the central header of an entry share.
std::string common_header(const Entry& entry) {
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(entry.bytes.data()),
                         static_cast<uInt>(entry.bytes.size()));
  constexpr int version = 20, flags = 0, method_deflate = 8;
  return little_endian(version, 2) + little_endian(flags, 2) + little_endian(method_deflate, 2) +
         std::string(4, '\0') + little_endian(sum, 4) + little_endian(entry.packed.size(), 4) +
         little_endian(entry.declared, 4) + little_endian(entry.name.size(), 2) +
         little_endian(0, 2);
}

std::string zip(const std::vector<Entry>& entries) {
  std::string bytes, directory;
  for (const Entry& entry : entries) {
    directory += "PK\1\2" + little_endian(20, 2) + common_header(entry) + std::string(10, '\0') +
                 little_endian(bytes.size(), 4) + entry.name;
    bytes += "PK\3\4" + common_header(entry) + entry.name + entry.packed;
  }
  return bytes + directory + "PK\5\6" + std::string(4, '\0') + little_endian(entries.size(), 2) +
         little_endian(entries.size(), 2) + little_endian(directory.size(), 4) +
         little_endian(bytes.size(), 4) + little_endian(0, 2);
}

std::string description(const std::string& cols, const std::string& rows,
                        const std::string& more = "") {
  return "<p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\"><Record1>"
         "<FeatureType>SUR</FeatureType><Axes>"
         "<CX><AxisType>I</AxisType><Increment>1e-6</Increment></CX>"
         "<CY><AxisType>I</AxisType><Increment>1e-6</Increment></CY>"
         "<CZ><AxisType>A</AxisType><DataType>F</DataType></CZ></Axes></Record1>"
         "<Record3><MatrixDimension><SizeX>" +
         cols + "</SizeX><SizeY>" + rows +
         "</SizeY><SizeZ>1</SizeZ></MatrixDimension><DataLink>"
         "<PointDataLink>bindata/data.bin</PointDataLink></DataLink></Record3>" +
         more + "</p:ISO5436_2>";
}

void check(const std::vector<Entry>& entries) {
  const Scratch folder;
  folder.write("bomb.x3p", zip(entries));
  check_cheaply_refused(folder, "bomb.x3p");
}

}  // namespace

TEST_CASE("the archives of these tests are read where they are sound", "[cli][hostile]") {
  const Scratch folder;
  folder.write("sound.x3p", zip({entry("main.xml", description("4", "2")),
                                 entry("bindata/data.bin", std::string(32, '\0'))}));
  const Outcome outcome = folder.shedlight("info sound.x3p");
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
}

TEST_CASE("an X3P whose data unpack to more than they should is not unpacked", "[cli][hostile]") {
  const std::string zeros(std::size_t{1} << 28, '\0');
  const Entry bomb = entry("bindata/data.bin", zeros);
  // The directory tells the truth, main.xml asks for less.
  check({entry("main.xml", description("4", "2")), bomb});
  // The directory says what main.xml asks for, the data go on.
  check({entry("main.xml", description("4", "2")), {bomb.name, bomb.bytes, 32, bomb.packed}});
  // main.xml itself.
  check({{"main.xml", zeros, zeros.size(), bomb.packed}});
  check({{"main.xml", zeros, 500, bomb.packed}});
}

TEST_CASE("an X3P that declares more than it holds is refused at once", "[cli][hostile]") {
  const Entry little = entry("bindata/data.bin", std::string(32, '\0'));
  check({entry("main.xml", description("1000000000", "1000000000")), little});
  check({entry("main.xml", description("18446744073709551615", "2")), little});
  check({entry("main.xml", description("16384", "16384")), little});
  check({entry("main.xml", description("16384", "16384")),
         {little.name, little.bytes, std::uint64_t{1} << 30, little.packed}});
}

TEST_CASE("an X3P full of empty elements takes little memory", "[cli][hostile]") {
  std::string elements;
  while (elements.size() < 1000000) elements += "<a/>";
  check({entry("main.xml", description("1000000000", "2", elements))});
}

TEST_CASE("a large file that begins as an archive is not read whole to be refused",
          "[cli][hostile]") {
  const Scratch folder;
  folder.write("long.x3p", zip({entry("main.xml", description("4", "2"))}));
  stretch(folder, "long.x3p");
  check_cheaply_refused(folder, "long.x3p");
}
