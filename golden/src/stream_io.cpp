// SPDX-License-Identifier: Apache-2.0
// Stream files, byte by byte little-endian on any machine.
#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <gnomon/golden/stream_io.hpp>
#include <limits>
#include <string_view>

namespace gnomon::golden {
namespace {

constexpr std::string_view kMagic = "GNOMON\x1A\n";
constexpr std::uint32_t kVersion = 5;
/// Each version holds more of them: the silhouette-line buffer came with version 2, topology mode with 3, the
/// frame buffer with 4, the perspective projection with 5.
constexpr std::array<std::size_t, kVersion> kFieldsOfVersion{7, 15, 20, 22, 23};
constexpr std::size_t kConfigFields = kFieldsOfVersion.back();
constexpr std::size_t kRoundingField = 14;
constexpr std::size_t kConfigOffset = kMagic.size() + 4;
constexpr std::size_t kBlockWords = 1 << 16;

void put(std::string& bytes, std::uint64_t value, int count) {
  for (int i = 0; i < count; ++i) bytes.push_back(static_cast<char>(value >> (8 * i) & 0xFF));
}

std::uint64_t get(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    value |= std::uint64_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  }
  return value;
}

std::array<int, kConfigFields> config_values(const HardwareConfig& c) {
  return {c.voxel_bits,        c.voxel_frac_bits, c.normal_bits,
          c.matrix_frac_bits,  c.depth_bits,      c.plane_log2,
          c.en_vpu_offset,     c.en_slb,          c.slb_plane_log2,
          c.frac_bits,         c.slope_bits,      c.frags_per_pixel,
          c.subpixel_bits,     c.query_bits,      static_cast<int>(c.slb_rounding),
          c.en_vpu_topology,   c.sub_bits,        c.span_log2,
          c.nodes_log2,        c.quads_log2,      c.en_frame_buffer,
          c.frame_layers_log2, c.en_perspective};
}

/// Of a file of this version.
std::size_t config_fields(std::uint64_t version) {
  return kFieldsOfVersion.at(version - 1);
}
std::size_t header_size(std::uint64_t version) {
  return kConfigOffset + 4 * config_fields(version) + 8;
}

/// A field too large for an int is illegal whatever it is; it is kept illegal rather than wrapped.
HardwareConfig decode_config(std::string_view bytes, std::uint64_t version) {
  std::array<int, kConfigFields> v = config_values({});
  for (std::size_t i = 0; i < config_fields(version); ++i) {
    const std::uint64_t value = get(bytes, kConfigOffset + 4 * i, 4);
    v[i] = static_cast<int>(std::min(value, std::uint64_t{std::numeric_limits<int>::max()}));
  }
  HardwareConfig c;
  c.voxel_bits = v[0];
  c.voxel_frac_bits = v[1];
  c.normal_bits = v[2];
  c.matrix_frac_bits = v[3];
  c.depth_bits = v[4];
  c.plane_log2 = v[5];
  c.en_vpu_offset = v[6] != 0;
  c.en_slb = v[7] != 0;
  c.slb_plane_log2 = v[8];
  c.frac_bits = v[9];
  c.slope_bits = v[10];
  c.frags_per_pixel = v[11];
  c.subpixel_bits = v[12];
  c.query_bits = v[13];
  c.slb_rounding = v[kRoundingField] == 0 ? slb::Rounding::Better : slb::Rounding::Published;
  c.en_vpu_topology = v[15] != 0;
  c.sub_bits = v[16];
  c.span_log2 = v[17];
  c.nodes_log2 = v[18];
  c.quads_log2 = v[19];
  c.en_frame_buffer = v[20] != 0;
  c.frame_layers_log2 = v[21];
  c.en_perspective = v[22] != 0;
  return c;
}

std::uint64_t rounding_field(std::string_view bytes, std::uint64_t version) {
  return version == 1 ? 0 : get(bytes, kConfigOffset + 4 * kRoundingField, 4);
}

std::string header_bytes(const HardwareConfig& config, std::size_t words) {
  std::string bytes(kMagic);
  put(bytes, kVersion, 4);
  for (const int value : config_values(config)) put(bytes, static_cast<std::uint64_t>(value), 4);
  put(bytes, words, 8);
  return bytes;
}

std::string failure(const std::filesystem::path& path, const std::string& what) {
  return path.string() + ": " + what;
}

std::string system_failure(const std::filesystem::path& path, const std::string& what) {
  return failure(path, what + ": " + std::strerror(errno));
}

void swap_if_big_endian(std::span<Word> words) {
  if constexpr (std::endian::native == std::endian::big) {
    for (Word& word : words) word = __builtin_bswap64(word);
  }
}

}  // namespace

std::optional<std::string> save_stream(const std::filesystem::path& path, const HardwareConfig& config,
                                       std::span<const Word> words) {
  if (const auto error = config.check()) return failure(path, "not written: " + *error);
  errno = 0;
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  if (!file) return system_failure(path, "cannot create the stream file");
  const std::string header = header_bytes(config, words.size());
  file.write(header.data(), static_cast<std::streamsize>(header.size()));
  std::vector<Word> block;
  while (!words.empty() && file) {
    const auto part = words.first(std::min(words.size(), kBlockWords));
    block.assign(part.begin(), part.end());
    swap_if_big_endian(block);
    file.write(reinterpret_cast<const char*>(block.data()), static_cast<std::streamsize>(block.size() * 8));
    words = words.subspan(part.size());
  }
  file.close();
  if (!file) return system_failure(path, "cannot write the stream file");
  return std::nullopt;
}

std::variant<StreamFile, std::string> load_stream(const std::filesystem::path& path) {
  std::error_code status;
  if (std::filesystem::is_directory(path, status)) return failure(path, "is a directory, not a stream file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) return system_failure(path, "cannot open the stream file");
  std::string header(header_size(kVersion), '\0');
  file.read(header.data(), static_cast<std::streamsize>(header.size()));
  const auto got = static_cast<std::size_t>(file.gcount());
  if (header.compare(0, kMagic.size(), kMagic) != 0) return failure(path, "is not a Gnomon stream file");
  const std::uint64_t version = got < kConfigOffset ? kVersion : get(header, kMagic.size(), 4);
  if (version < 1 || version > kVersion) {
    return failure(path, "has version " + std::to_string(version) + "; this program reads versions 1 to " +
                             std::to_string(kVersion));
  }
  const std::size_t header_length = header_size(version);
  if (got < header_length) {
    return failure(path, "ends after " + std::to_string(got) + " bytes; the header alone has " +
                             std::to_string(header_length));
  }
  file.clear();  // a short file of an old version ends before a header of the newest does
  file.seekg(static_cast<std::streamoff>(header_length));
  if (const auto rounding = rounding_field(header, version); rounding > 1) {
    return failure(
        path, "names illegal hardware: SLB_ROUNDING=" + std::to_string(rounding) + " is out of range 0..1");
  }
  StreamFile stream;
  stream.config = decode_config(header, version);
  if (const auto error = stream.config.check()) return failure(path, "names illegal hardware: " + *error);
  const std::uint64_t words = get(header, header_length - 8, 8);
  const std::uint64_t bytes = std::filesystem::file_size(path, status);
  if (status) return failure(path, "cannot tell the file's size: " + status.message());
  if ((bytes - header_length) % 8 != 0 || (bytes - header_length) / 8 != words) {
    return failure(path, "promises " + std::to_string(words) + " words, but " +
                             std::to_string(bytes - header_length) + " bytes follow the header");
  }
  stream.words.resize(words);
  file.read(reinterpret_cast<char*>(stream.words.data()), static_cast<std::streamsize>(words * 8));
  if (static_cast<std::uint64_t>(file.gcount()) != words * 8)
    return system_failure(path, "cannot read the words");
  swap_if_big_endian(stream.words);
  return stream;
}

}  // namespace gnomon::golden
