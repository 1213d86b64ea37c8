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
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kConfigFields = 7;
constexpr std::size_t kHeaderBytes = kMagic.size() + 4 + 4 * kConfigFields + 8;
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
  return {c.voxel_bits, c.voxel_frac_bits, c.normal_bits,  c.matrix_frac_bits,
          c.depth_bits, c.plane_log2,      c.en_vpu_offset};
}

/// A field too large for an int is illegal whatever it is; it is kept illegal rather than wrapped.
HardwareConfig decode_config(std::string_view bytes, std::size_t at) {
  std::array<int, kConfigFields> v{};
  for (std::size_t i = 0; i < kConfigFields; ++i) {
    const std::uint64_t value = get(bytes, at + 4 * i, 4);
    v[i] = static_cast<int>(std::min(value, std::uint64_t{std::numeric_limits<int>::max()}));
  }
  return {v[0], v[1], v[2], v[3], v[4], v[5], v[6] != 0};
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
  std::string header(kHeaderBytes, '\0');
  file.read(header.data(), static_cast<std::streamsize>(header.size()));
  const auto got = static_cast<std::size_t>(file.gcount());
  if (header.compare(0, kMagic.size(), kMagic) != 0) return failure(path, "is not a Gnomon stream file");
  if (got < kHeaderBytes) {
    return failure(path, "ends after " + std::to_string(got) + " bytes; the header alone has " +
                             std::to_string(kHeaderBytes));
  }
  const std::uint64_t version = get(header, kMagic.size(), 4);
  if (version != kVersion) {
    return failure(path, "has version " + std::to_string(version) + "; this program reads version " +
                             std::to_string(kVersion));
  }
  StreamFile stream;
  stream.config = decode_config(header, kMagic.size() + 4);
  if (const auto error = stream.config.check()) return failure(path, "names illegal hardware: " + *error);
  const std::uint64_t words = get(header, kHeaderBytes - 8, 8);
  const std::uint64_t bytes = std::filesystem::file_size(path, status);
  if (status) return failure(path, "cannot tell the file's size: " + status.message());
  if ((bytes - kHeaderBytes) % 8 != 0 || (bytes - kHeaderBytes) / 8 != words) {
    return failure(path, "promises " + std::to_string(words) + " words, but " +
                             std::to_string(bytes - kHeaderBytes) + " bytes follow the header");
  }
  stream.words.resize(words);
  file.read(reinterpret_cast<char*>(stream.words.data()), static_cast<std::streamsize>(words * 8));
  if (static_cast<std::uint64_t>(file.gcount()) != words * 8)
    return system_failure(path, "cannot read the words");
  swap_if_big_endian(stream.words);
  return stream;
}

}  // namespace gnomon::golden
