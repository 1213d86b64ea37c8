// SPDX-License-Identifier: Apache-2.0
// Content hashes and whole-file reads.
#include "sim/content_hash.hpp"

#include <algorithm>
#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace gnomon::sim {

std::string content_hash(std::string_view bytes) {
  const boost::uuids::name_generator_sha1 hash(boost::uuids::ns::oid());
  std::string text = boost::uuids::to_string(hash(bytes.data(), bytes.size()));
  std::erase(text, '-');
  return text;
}

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file) throw std::runtime_error("cannot read " + path.string());
  return bytes;
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  std::ofstream file(path, std::ios::binary);
  file << bytes;
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace gnomon::sim
