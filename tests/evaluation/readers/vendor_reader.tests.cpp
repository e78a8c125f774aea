#include "evaluation/readers/vendor_reader.h"

#include <cstdlib>

#include "tests/support/damaged_files.h"
#include "tests/support/foreign_files.h"
#include "tests/support/is_error.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using brdf::Errc;

/// A folder that is the whole PATH while the test runs.
class OnlyPath {
 public:
  OnlyPath() {
    const char* path = std::getenv("PATH");
    before_ = path ? path : "";
    setenv("PATH", folder_.path().c_str(), 1);
  }
  ~OnlyPath() { setenv("PATH", before_.c_str(), 1); }
  /// A script in the place of Gwyddion; $1 is the option with the output, $2 the file.
  void gwyddion(const std::string& script) const {
    fs::permissions(folder_.write("gwyddion", "#!/bin/sh\n" + script), fs::perms::owner_all);
  }
  fs::path file(const std::string& name) const {
    return folder_.write(name, "neither numbers nor a magic");
  }
  const fs::path& folder() const { return folder_.path(); }

 private:
  std::string before_;
  TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("names of microscopes are told from others", "[vendor]") {
  using evaluation::detail::is_vendor_name;
  for (const char* name : {"a.spm", "a.NID", "a.ibw", "a.jpk", "a.sxm", "a.mtrx", "a.plu", "a.al3d",
                           "a.opd", "a.sur", "a.vk4", "a.dat", "a.000", "a.b.017"})
    CHECK(is_vendor_name(name));
  for (const char* name :
       {"a.png", "a.gsf", "spm", ".spm", "a", "a.00", "a.0000", "a.00x", "a.csv"})
    CHECK(!is_vendor_name(name));
}

TEST_CASE("an Igor wave is read through Gwyddion to the last bit of float", "[vendor][golden]") {
  if (std::system("command -v gwyddion >/dev/null") != 0) {
    WARN("skipped: gwyddion is not installed");
    return;
  }
  const std::vector<double> written = foreign_numbers("heights.csv");
  const auto read = evaluation::read_heights(foreign_file("gwyddion.ibw"), {});
  REQUIRE(read.field.cols() == 7);
  REQUIRE(read.field.rows() == 5);
  // igorfile keeps 32 bits.
  for (std::size_t i = 0; i < written.size(); ++i)
    CHECK(static_cast<float>(read.field.heights_um().data()[i] / 1e6) ==
          static_cast<float>(written[i]));
  CHECK(read.field.dx_um() == Approx(0.1 / 3).epsilon(1e-6));
  CHECK(read.field.dy_um() == Approx(0.22).epsilon(1e-6));
  CHECK(read.sha256.size() == 64);
}

TEST_CASE("without Gwyddion a vendor file is refused in one line", "[vendor]") {
  const OnlyPath path;
  const fs::path file = path.file("scan.spm");
  CHECK_ERROR(evaluation::read_heights(file, {}), Errc::bad_input,
              file.string() +
                  ": not a known format; vendor files are read through Gwyddion, which "
                  "is not installed (apt-get install gwyddion)");
  // Only names of microscopes start another program.
  CHECK_ERROR(evaluation::read_heights(path.file("scan.bin"), {}), Errc::bad_input,
              "not a known format; read are");
}

TEST_CASE("Gwyddion is given a folder of its own and no more than the PATH", "[vendor]") {
  const OnlyPath path;
  path.gwyddion("/usr/bin/env > '" + (path.folder() / "environment").string() + "'\n" +
                "/bin/cp '" + foreign_file("gwyddion_mask.gwy").string() +
                "' \"${1#--convert-to-gwy=}\"\necho \"$2\" > '" +
                (path.folder() / "file").string() + "'\n");
  const fs::path file = path.file("-scan.spm");
  evaluation::HeightChoice choice;
  choice.missing = evaluation::MissingHeights::neighbours;
  setenv("LD_LIBRARY_PATH", "/nonexistent", 1);
  const auto read = evaluation::read_heights(file, choice);
  unsetenv("LD_LIBRARY_PATH");
  CHECK(read.field.cols() == 7);
  CHECK_THAT(read.format, Catch::Contains("Gwyddion"));
  int homes = 0;
  std::ifstream environment(path.folder() / "environment");
  for (std::string line; std::getline(environment, line);) {
    INFO(line);
    const std::string name = line.substr(0, line.find('='));
    CHECK((name == "PATH" || name == "HOME" || name == "LC_ALL" || name == "PWD" ||
           name == "SHLVL" || name == "_" || name == "OLDPWD"));
    if (name == "HOME") {
      ++homes;
      CHECK(!fs::exists(line.substr(line.find('=') + 1)));  // it is gone
    }
  }
  CHECK(homes == 1);
  std::ifstream given(path.folder() / "file");
  std::string absolute;
  std::getline(given, absolute);
  CHECK(absolute == file.string());
  CHECK(absolute[0] == '/');
}

TEST_CASE("what Gwyddion cannot convert is refused", "[vendor]") {
  const OnlyPath path;
  const fs::path file = path.file("scan.spm");
  path.gwyddion("exit 1\n");
  CHECK_ERROR(evaluation::read_heights(file, {}), Errc::bad_input, "does not know it either");
  path.gwyddion("echo GWYP > \"${1#--convert-to-gwy=}\"\n");
  CHECK_ERROR(evaluation::read_heights(file, {}), Errc::bad_input, "scan.spm: GWY");
  CHECK(refusal_of("neither numbers nor a magic") != "");
}
