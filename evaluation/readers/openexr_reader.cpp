#include "evaluation/readers/openexr_reader.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <new>
#include <string>

#include "brdf/error.h"
#include "evaluation/readers/openexr_layout.h"
#include "evaluation/readers/samples.h"
#include "evaluation/readers/stored_number.h"

namespace evaluation::detail {
namespace {

class Stream : public Imf::IStream {
 public:
  explicit Stream(const FileSource& source)
      : Imf::IStream(source.name().c_str()), source_(source) {}

  bool read(char to[], int count) override {
    const auto wanted = static_cast<std::size_t>(count);
    if (source_.read_at(position_, to, wanted) != wanted) ExrRefusal{source_}("file is truncated");
    position_ += wanted;
    return position_ < source_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  const FileSource& source_;
  std::uint64_t position_ = 0;
};

/// As for all formats; without a wish, also the only channel of a height's usual names.
std::size_t channel_of(const std::vector<HeightChannel>& channels, const HeightRequest& request,
                       const FileSource& source) {
  std::vector<std::size_t> usual;
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (const std::string& title = channels[i].title;
        title == "Y" || title == "Z" || title == "height")
      usual.push_back(i);
  if (!request.channel && usual.size() == 1) return usual.front();
  return chosen_channel(channels, request.channel, source.name());
}

// Ten bits behind the point.
constexpr double half_epsilon = 0x1p-10;

/// Row by row through a line of the channel's own type: the file's lines may be in any order.
template <class T>
void read_rows(Imf::InputFile& file, Imf::PixelType type, const std::string& channel,
               const ExrWindow& window, brdf::HeightArray& values) {
  const auto line = std::make_unique_for_overwrite<T[]>(window.cols);
  Imf::FrameBuffer buffer;
  buffer.insert(channel,
                Imf::Slice(type,
                           reinterpret_cast<char*>(line.get()) -
                               std::ptrdiff_t{window.box.min.x} * std::ptrdiff_t{sizeof(T)},
                           sizeof(T), 0));
  file.setFrameBuffer(buffer);
  for (Eigen::Index row = 0; row < values.rows(); ++row) {
    file.readPixels(window.box.min.y + static_cast<int>(row));
    for (Eigen::Index col = 0; col < values.cols(); ++col)
      values(row, col) = static_cast<double>(line[static_cast<std::size_t>(col)]);
  }
}

RawHeights decoded(const FileSource& source, const HeightRequest& request) {
  const ExrRefusal refuse{source};
  const std::string_view head = source.head();
  if (head.size() < preamble_bytes) refuse("file is truncated");
  const auto version = stored_number<std::uint32_t>(head.data() + 4);
  if (version & deep_flag) refuse("holds deep pixels; read are plain ones");
  if (version & parts_flag) refuse("holds several parts; read is one");
  require_whole_header(head, refuse);

  Stream stream(source);
  stream.seekg(preamble_bytes);
  Imf::Header header;
  auto version_field = static_cast<int>(version);
  header.readFrom(stream, version_field);
  const bool is_tiled = (version & tiled_flag) != 0;
  const ExrWindow window = checked_window(header, is_tiled, source, request);
  require_places(header, is_tiled, window, stream.tellg(), source);

  RawHeights raw;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
    raw.channels.push_back({channel.name()});
  raw.channel = raw.channels[channel_of(raw.channels, request, source)].title;
  raw.values.resize(static_cast<Eigen::Index>(window.rows), static_cast<Eigen::Index>(window.cols));
  stream.seekg(0);
  Imf::InputFile file(stream);
  if (!file.isComplete()) refuse("file is truncated");
  switch (header.channels()[raw.channel].type) {
    case Imf::UINT:
      raw.format = "OpenEXR, 32 bit unsigned";
      raw.step = 1;
      read_rows<std::uint32_t>(file, Imf::UINT, raw.channel, window, raw.values);
      break;
    case Imf::HALF:
      raw.format = "OpenEXR, 16 bit float";
      read_rows<float>(file, Imf::FLOAT, raw.channel, window, raw.values);
      raw.step = step_at_largest(raw.values, half_epsilon);
      break;
    default:
      raw.format = "OpenEXR, 32 bit float";
      read_rows<float>(file, Imf::FLOAT, raw.channel, window, raw.values);
  }
  return raw;
}

}  // namespace

RawHeights decode_openexr(const FileSource& source, const HeightRequest& request) {
  try {
    return decoded(source, request);
  } catch (const brdf::Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    ExrRefusal{source}(error.what());
  }
}

}  // namespace evaluation::detail
