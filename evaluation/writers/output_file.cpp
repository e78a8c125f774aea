#include "evaluation/writers/output_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "brdf/error.h"
#include "evaluation/readers/file_bytes.h"
#include "evaluation/writers/placing.h"

namespace evaluation {

namespace fs = std::filesystem;
using brdf::Errc;
using brdf::Error;

OutputFile::OutputFile(const fs::path& target) : target_(target) {
  std::error_code ec;
  if (fs::exists(target, ec)) target_ = resolved();
  try {
    file_.emplace(folder());
  } catch (const std::system_error& error) {
    refuse("its folder takes no new file: " + error.code().message());
  }
}

/// What a target that is there stands for. A link stays a link: what it points to is replaced.
fs::path OutputFile::resolved() const {
  std::error_code ec;
  const fs::path file = fs::canonical(target_, ec);
  if (ec) refuse("cannot be resolved: " + ec.message());
  if (!fs::is_regular_file(file)) refuse("is not a regular file");
  if (access(file.c_str(), W_OK) != 0) refuse(std::strerror(errno));
  return file;
}

fs::path OutputFile::folder() const {
  return target_.has_parent_path() ? target_.parent_path() : fs::path(".");
}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file_->descriptor(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) refuse(std::strerror(errno));
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void OutputFile::commit_together(std::span<OutputFile* const> files) {
  std::vector<Placement> placements;
  for (OutputFile* file : files) placements.push_back({&*file->file_, file->target_});
  try {
    place(placements);
  } catch (const std::system_error& error) {
    files.front()->refuse(error.code().message());
  }
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

Json OutputWithSidecar::commit(Json sidecar, std::vector<OutputFile*> beside) {
  sidecar["output"] = {{"file", output_.target().filename().string()}, {"sha256", hash_.hex()}};
  sidecar_.write(json_text(sidecar));
  beside.insert(beside.begin(), {&output_, &sidecar_});
  OutputFile::commit_together(beside);
  return sidecar;
}

std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
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
