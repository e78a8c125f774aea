#include "evaluation/writers/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "brdf/error.h"
#include "evaluation/readers/file_bytes.h"

namespace evaluation {

namespace fs = std::filesystem;
using brdf::Errc;
using brdf::Error;

namespace {

std::string reason() {
  return std::strerror(errno);
}

/// The permissions that a newly created file gets. The umask cannot be read without setting it.
mode_t default_mode() {
  const mode_t mask = umask(0);
  umask(mask);
  return 0666 & ~mask;
}

}  // namespace

OutputFile::OutputFile(const fs::path& target) : target_(target) {
  std::error_code ec;
  if (fs::exists(target, ec)) {
    // A link stays a link: what it points to is replaced.
    target_ = fs::canonical(target, ec);
    if (ec) refuse("cannot be resolved: " + ec.message());
    if (!fs::is_regular_file(target_)) refuse("is not a regular file");
    if (access(target_.c_str(), W_OK) != 0) refuse(reason());
  }
  std::string name = target_.string() + ".XXXXXX.tmp";
  descriptor_ = mkostemps(name.data(), 4, O_CLOEXEC);
  if (descriptor_ < 0) refuse("its folder takes no new file: " + reason());
  temporary_ = name;
  fchmod(descriptor_, default_mode());
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) refuse(reason());
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void OutputFile::commit() {
  if (fsync(descriptor_) != 0) refuse(reason());
  if (close(std::exchange(descriptor_, -1)) != 0) refuse(reason());
  if (rename(temporary_.c_str(), target_.c_str()) != 0) refuse(reason());
  temporary_.clear();
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  const int directory = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (directory < 0) return;  // a folder that may be written but not read; the file is in place
  fsync(directory);
  close(directory);
}

void OutputFile::refuse(const std::string& what) const {
  throw Error(Errc::cannot_write, target_.string() + ": cannot be written: " + what);
}

OutputWithSidecar::OutputWithSidecar(const fs::path& target)
    : output_(target), sidecar_(sidecar_path(target)) {}

void OutputWithSidecar::write(std::string_view bytes) {
  hash_.update(bytes);
  output_.write(bytes);
}

Json OutputWithSidecar::commit(Json sidecar) {
  sidecar["output"] = {{"file", output_.target().filename().string()}, {"sha256", hash_.hex()}};
  sidecar_.write(sidecar.dump(2) + "\n");
  output_.commit();
  sidecar_.commit();
  return sidecar;
}

fs::path sidecar_path(const fs::path& output) {
  return output.string() + ".json";
}

void require_room(const fs::path& target, std::uintmax_t bytes) {
  std::error_code ec;
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  const fs::space_info space = fs::space(folder, ec);
  if (!ec && bytes > space.available)
    throw Error(Errc::cannot_write, target.string() + ": needs " + std::to_string(bytes) +
                                        " bytes, the disk has room for " +
                                        std::to_string(space.available));
}

namespace {

[[noreturn]] void refuse_sidecar(const fs::path& output, const std::string& what) {
  throw Error(Errc::bad_input, sidecar_path(output).string() + ": " + what);
}

}  // namespace

Json read_sidecar(const fs::path& output) {
  constexpr std::uintmax_t largest = 1 << 24;  // far above any that is written
  const fs::path path = sidecar_path(output);
  if (!fs::exists(path)) return nullptr;
  Json sidecar = Json::parse(read_file_bytes(path, largest), nullptr, /*allow_exceptions=*/false);
  if (!sidecar.is_object()) refuse_sidecar(output, "is not a JSON object");
  const Json::json_pointer hash("/output/sha256");
  if (!sidecar.contains(hash) || !sidecar[hash].is_string())
    refuse_sidecar(output, "has no output.sha256");
  return sidecar;
}

Json read_sidecar(const fs::path& output, const std::string& sha256) {
  Json sidecar = read_sidecar(output);
  if (!sidecar.is_null() && sidecar["output"]["sha256"] != sha256)
    refuse_sidecar(output,
                   "does not belong to " + output.string() +
                       ": the SHA-256 differs, so one of the two was changed; make it again, or "
                       "remove the sidecar and give the options");
  return sidecar;
}

}  // namespace evaluation
