#include "evaluation/readers/tiff_file.h"

#include <cstdio>
#include <memory>
#include <new>

#include "brdf/error.h"

namespace evaluation::detail {
namespace {

// The tables of libtiff's own decoders.
constexpr std::uint64_t decoder_bytes = 1 << 20;

TiffFile& self(void* data) {
  return *static_cast<TiffFile*>(data);
}

std::string formatted(const char* format, va_list values) {
  char text[256] = {};
  std::vsnprintf(text, sizeof text, format, values);
  return text;
}

tmsize_t write(thandle_t, void*, tmsize_t) {
  return -1;
}

int close(thandle_t) {
  return 0;
}

toff_t size(thandle_t data) {
  return self(data).source().size();
}

}  // namespace

TiffFile::TiffFile(const FileSource& source) : source_(source) {
  const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(),
                                                                             TIFFOpenOptionsFree);
  if (!options) throw std::bad_alloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), on_error, this);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), on_warning, this);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(),
                                      static_cast<tmsize_t>(source.size() + decoder_bytes));
  // D leaves the tables of strips for after the check of the dimensions.
  tiff_ = TIFFClientOpenExt(source.name().c_str(), "rD", this, read, write, seek, close, size,
                            nullptr, nullptr, options.get());
  if (!tiff_) refuse_read("its directory cannot be read");
}

TiffFile::~TiffFile() {
  if (tiff_) TIFFClose(tiff_);
}

void TiffFile::refuse(const std::string& what) const {
  throw brdf::Error(brdf::Errc::bad_input, source_.name() + ": TIFF: " + what);
}

void TiffFile::refuse_read(const std::string& what) const {
  refuse(message_.empty() ? what : what + ": " + message_);
}

void TiffFile::require_no_guess() const {
  if (!guess_.empty()) refuse(guess_);
}

int TiffFile::on_error(TIFF*, void* data, const char*, const char* format, va_list values) {
  std::string& message = self(data).message_;
  if (message.empty()) message = formatted(format, values);
  return 1;
}

int TiffFile::on_warning(TIFF*, void* data, const char*, const char* format, va_list values) {
  const std::string text = formatted(format, values);
  for (const char* harmless : {"Unknown field", "ASCII value", "Nonstandard tile"})
    if (text.find(harmless) != std::string::npos) return 1;
  self(data).guess_ = text;
  return 1;
}

tmsize_t TiffFile::read(thandle_t data, void* to, tmsize_t count) {
  TiffFile& file = self(data);
  // No exception may pass through libtiff.
  try {
    const std::size_t got = file.source_.read_at(file.position_, static_cast<char*>(to),
                                                 static_cast<std::size_t>(count));
    file.position_ += got;
    if (got < static_cast<std::size_t>(count)) file.guess_ = "file is truncated";
    return static_cast<tmsize_t>(got);
  } catch (const brdf::Error& error) {
    file.message_ = error.what();
    return -1;
  }
}

toff_t TiffFile::seek(thandle_t data, toff_t offset, int whence) {
  TiffFile& file = self(data);
  const toff_t origin = whence == SEEK_SET   ? 0
                        : whence == SEEK_CUR ? file.position_
                                             : file.source_.size();
  return file.position_ = origin + offset;
}

}  // namespace evaluation::detail
