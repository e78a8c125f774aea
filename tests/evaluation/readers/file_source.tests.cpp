#include "evaluation/readers/file_source.h"

#include <sys/stat.h>

#include "tests/support/damaged_files.h"
#include "tests/support/is_error.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using brdf::Errc;
using evaluation::FileSource;

}  // namespace

TEST_CASE("a file's size and head are known before the rest is read", "[source]") {
  const TemporaryFolder folder;
  std::string bytes(3 * FileSource::head_bytes, 'x');
  bytes.back() = 'y';
  const FileSource source(folder.write("large", bytes));
  CHECK(source.size() == bytes.size());
  CHECK(source.head() == bytes.substr(0, FileSource::head_bytes));
  CHECK(source.bytes() == bytes);
  CHECK(source.head().size() == FileSource::head_bytes);
}

TEST_CASE("bytes in memory are a file of that name", "[source]") {
  const FileSource source("a name", "the bytes");
  CHECK(source.name() == "a name");
  CHECK(source.size() == 9);
  CHECK(source.head() == "the bytes");
  CHECK(source.bytes() == "the bytes");
  CHECK_ERROR(FileSource("a name", ""), Errc::bad_input, "a name: file is empty");
}

TEST_CASE("what is no file with bytes is refused by name", "[source]") {
  const TemporaryFolder folder;
  CHECK_ERROR(FileSource(folder / "none"), Errc::bad_input, "no such file");
  CHECK_ERROR(FileSource(folder.path()), Errc::bad_input, "is not a regular file");
  CHECK_ERROR(FileSource(folder.write("empty", "")), Errc::bad_input, "file is empty");
  const fs::path pipe = folder / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_ERROR(FileSource(pipe), Errc::bad_input, "is not a regular file");
}

TEST_CASE("a file that becomes shorter while it is read is refused", "[source]") {
  const TemporaryFolder folder;
  const fs::path path = folder.write("file", std::string(2 * FileSource::head_bytes, 'x'));
  const FileSource source(path);
  fs::resize_file(path, FileSource::head_bytes + 5);
  CHECK_ERROR(source.bytes(), Errc::bad_input, "shorter");
}

TEST_CASE("a header is known without the memory for what follows", "[source]") {
  const TemporaryFolder folder;
  const fs::path path = folder.write("huge", "Gwyddion");
  fs::resize_file(path, std::uintmax_t{1} << 40);  // holes: it takes no room on the disk
  check_cheap([&] { CHECK(FileSource(path).head().starts_with("Gwyddion")); });
}
