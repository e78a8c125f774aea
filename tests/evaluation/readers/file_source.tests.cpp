#include "evaluation/readers/file_source.h"

#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "tests/support/damaged_files.h"
#include "tests/support/is_error.h"

namespace {

namespace fs = std::filesystem;
using brdf::Errc;
using evaluation::FileSource;

class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "shedlight-source-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp");
    path_ = name;
  }
  ~Folder() { fs::remove_all(path_); }
  fs::path file(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return path_ / name;
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

TEST_CASE("a file's size and head are known before the rest is read", "[source]") {
  const Folder folder;
  std::string bytes(3 * FileSource::head_bytes, 'x');
  bytes.back() = 'y';
  const FileSource source(folder.file("large", bytes));
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
  const Folder folder;
  CHECK_ERROR(FileSource(folder.path() / "none"), Errc::bad_input, "no such file");
  CHECK_ERROR(FileSource(folder.path()), Errc::bad_input, "is not a regular file");
  CHECK_ERROR(FileSource(folder.file("empty", "")), Errc::bad_input, "file is empty");
  const fs::path pipe = folder.path() / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_ERROR(FileSource(pipe), Errc::bad_input, "is not a regular file");
}

TEST_CASE("a file that becomes shorter while it is read is refused", "[source]") {
  const Folder folder;
  const fs::path path = folder.file("file", std::string(2 * FileSource::head_bytes, 'x'));
  const FileSource source(path);
  fs::resize_file(path, FileSource::head_bytes + 5);
  CHECK_ERROR(source.bytes(), Errc::bad_input, "shorter");
}

TEST_CASE("a header is known without the memory for what follows", "[source]") {
  const Folder folder;
  const fs::path path = folder.file("huge", "Gwyddion");
  fs::resize_file(path, std::uintmax_t{1} << 40);  // holes: it takes no room on the disk
  check_cheap([&] { CHECK(FileSource(path).head().starts_with("Gwyddion")); });
}
