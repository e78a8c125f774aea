#include "evaluation/checkpoint.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

#include "brdf/error.h"
#include "evaluation/sha256.h"
#include "evaluation/writers/output_file.h"

namespace evaluation {

namespace fs = std::filesystem;
using brdf::Errc;
using brdf::Error;

namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::string_view magic = "shedlight checkpoint 1\n";
constexpr std::size_t hash_digits = 64;

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string slot_hash(std::size_t i, std::string_view bytes) {
  Sha256 hash;
  hash.update(std::to_string(i) + "\n");
  hash.update(bytes);
  return hash.hex();
}

/// Up to `size` bytes; fewer at the end of the file.
std::string read_at(int file, off_t place, std::size_t size) {
  std::string bytes(size, '\0');
  std::size_t have = 0;
  while (have < size) {
    const ssize_t count =
        pread(file, bytes.data() + have, size - have, place + static_cast<off_t>(have));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    have += static_cast<std::size_t>(count);
  }
  bytes.resize(have);
  return bytes;
}

/// The first difference of two requests, for people: "lambda_nm.last is 780 in it, 700 asked for".
std::string difference(const Json& kept, const Json& asked) {
  const Json before = kept.flatten(), now = asked.flatten();
  const auto value = [](const Json& request, const std::string& key) {
    return request.contains(key) ? request[key].dump() : "nothing";
  };
  for (const Json* one : {&now, &before})
    for (const auto& [key, ignored] : one->items())
      if (value(before, key) != value(now, key)) {
        constexpr std::string_view before_names = "/request/";
        std::string name = key.substr(key.starts_with(before_names) ? before_names.size() : 1);
        std::ranges::replace(name, '/', '.');
        return name + " is " + value(before, key) + " in it, " + value(now, key) + " asked for";
      }
  return "";
}

}  // namespace

Checkpoint::Checkpoint(fs::path file, Json request, std::function<void(const Resumed&)> report)
    : file_(std::move(file)), request_(std::move(request)), report_(std::move(report)) {}

Checkpoint::~Checkpoint() {
  if (descriptor_ < 0) return;
  fdatasync(descriptor_);
  close(descriptor_);
}

void Checkpoint::refuse(const std::string& what) const {
  throw Error(Errc::bad_input, file_.string() + ": " + what);
}

std::string Checkpoint::head(std::size_t count, std::size_t bytes) const {
  const Json json{{"request", request_}, {"chunks", count}, {"bytes", bytes}};
  const std::string line = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return std::string(magic) + sha256_hex(line) + "\n" + line + "\n";
}

/// Whole or not at all; a file that is there already stays.
void Checkpoint::make(const std::string& head) const {
  try {
    const TemporaryFile made(fs::absolute(file_).parent_path());
    const auto failed = [] { return std::system_error(errno, std::generic_category()); };
    if (write(made.descriptor(), head.data(), head.size()) != static_cast<ssize_t>(head.size()) ||
        fsync(made.descriptor()) != 0)
      throw failed();
    if (const int error = made.give_name(); error != 0)
      throw std::system_error(error, std::generic_category());
    const int linked = made.link_to(file_.c_str());
    made.remove_name();
    if (linked != 0 && linked != EEXIST) throw std::system_error(linked, std::generic_category());
  } catch (const std::system_error& error) {
    throw Error(Errc::cannot_write,
                file_.string() + ": cannot be written: " + error.code().message());
  }
}

/// Opens the file for ourselves alone; leaves it closed where it has gone meanwhile.
void Checkpoint::lock() {
  descriptor_ = ::open(file_.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor_ < 0 && errno == ENOENT) return;
  struct stat status {};
  if (descriptor_ < 0 || fstat(descriptor_, &status) != 0)
    throw Error(Errc::cannot_write, file_.string() + ": " + std::strerror(errno));
  if (!S_ISREG(status.st_mode)) refuse("is not a regular file");
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    refuse("another run goes on from this checkpoint right now");
  // Its run may have ended and removed it in between.
  if (fstat(descriptor_, &status) == 0 && status.st_nlink > 0) return;
  close(std::exchange(descriptor_, -1));
}

void Checkpoint::require_head(const std::string& head) const {
  constexpr std::size_t most = 1 << 20;
  const std::string found = read_at(descriptor_, 0, most);
  if (found.starts_with(head)) return;
  const std::size_t line = magic.size() + hash_digits + 1, end = found.find('\n', line);
  if (!found.starts_with(magic) || end == found.npos ||
      sha256_hex(std::string_view(found).substr(line, end - line)) !=
          found.substr(magic.size(), hash_digits))
    refuse("is no checkpoint, or its head is damaged; remove it, or give another name");
  const std::string asked = head.substr(line);
  refuse("is the checkpoint of another request: " +
         difference(Json::parse(found.substr(line, end - line)), Json::parse(asked)));
}

off_t Checkpoint::place(std::size_t i) const {
  return static_cast<off_t>(head_bytes_ + i * (hash_digits + bytes_));
}

/// Looks at every slot once. What lies behind the end of a file that was cut off is damaged too.
Resumed Checkpoint::find_valid(std::size_t count) {
  Resumed found{count, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    const std::string slot = read_at(descriptor_, place(i), hash_digits + bytes_);
    const bool whole = slot.size() == hash_digits + bytes_;
    valid_[i] = whole && slot.substr(0, hash_digits) ==
                             slot_hash(i, std::string_view(slot).substr(hash_digits));
    if (valid_[i])
      ++found.taken_over;
    else if (!whole || slot.find_first_not_of('\0') != slot.npos)
      ++found.damaged;
  }
  return found;
}

void Checkpoint::open(std::size_t count, std::size_t bytes) {
  const std::string head = this->head(count, bytes);
  head_bytes_ = head.size();
  bytes_ = bytes;
  valid_.assign(count, false);
  synced_ = std::chrono::steady_clock::now();
  const bool is_new = !fs::exists(file_);
  constexpr int patience = 100;  // other runs may make and remove it; a link may point nowhere
  for (int i = 0; descriptor_ < 0; ++i) {
    if (i == patience) refuse("cannot be opened");
    if (!fs::exists(file_)) make(head);
    lock();
  }
  require_head(head);
  if (!is_new) report_(find_valid(count));
  if (ftruncate(descriptor_, place(count)) != 0)
    throw Error(Errc::cannot_write,
                file_.string() + ": cannot be written: " + std::strerror(errno));
}

bool Checkpoint::load(std::size_t i, std::span<std::byte> chunk) const {
  if (!valid_[i]) return false;
  const std::string bytes =
      read_at(descriptor_, place(i) + static_cast<off_t>(hash_digits), chunk.size());
  if (bytes.size() != chunk.size()) return false;
  std::memcpy(chunk.data(), bytes.data(), bytes.size());
  return true;
}

void Checkpoint::store(std::size_t i, std::span<const std::byte> chunk) {
  std::string bytes(text_of(chunk));
  bytes.resize(bytes_, '\0');
  const std::string slot = slot_hash(i, bytes) + bytes;
  std::string_view rest = slot;
  while (!rest.empty()) {
    const ssize_t count = pwrite(descriptor_, rest.data(), rest.size(),
                                 place(i) + static_cast<off_t>(slot.size() - rest.size()));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0)
      throw Error(Errc::cannot_write,
                  file_.string() + ": cannot be written: " + std::strerror(errno));
    rest.remove_prefix(static_cast<std::size_t>(count));
  }
  constexpr std::chrono::seconds between_syncs(5);
  const auto now = std::chrono::steady_clock::now();
  auto synced = synced_.load();
  if (now - synced >= between_syncs && synced_.compare_exchange_strong(synced, now))
    fdatasync(descriptor_);
}

std::string Checkpoint::kept() const {
  return file_.string() + " keeps what is done (--checkpoint)";
}

void Checkpoint::remove() {
  struct stat ours {
  }, named{};
  if (fstat(descriptor_, &ours) == 0 && stat(file_.c_str(), &named) == 0 &&
      ours.st_dev == named.st_dev && ours.st_ino == named.st_ino)
    unlink(file_.c_str());
}

}  // namespace evaluation
