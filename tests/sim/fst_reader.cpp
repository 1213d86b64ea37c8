// SPDX-License-Identifier: Apache-2.0
// Wraps fstapi.h, a C library in Verilator's include folder.
#include "tests/sim/fst_reader.hpp"

#include <gtkwave/fstapi.h>

#include <memory>

namespace gnomon::sim::test {

namespace {

fstHandle find_handle(void* reader, const std::string& name) {
  while (const fstHier* item = fstReaderIterateHier(reader)) {
    if (item->htyp != FST_HT_VAR) continue;
    const std::string found = item->u.var.name;  // vectors have their range behind the name
    if (found == name || found.starts_with(name + " ")) return item->u.var.handle;
  }
  return 0;
}

void take_change(void* edges, std::uint64_t time, fstHandle, const unsigned char* value) {
  static_cast<std::vector<Edge>*>(edges)->push_back({time, reinterpret_cast<const char*>(value)});
}

}  // namespace

std::optional<std::vector<Edge>> read_signal(const std::filesystem::path& file, const std::string& name) {
  const std::unique_ptr<void, void (*)(void*)> reader(fstReaderOpen(file.c_str()), fstReaderClose);
  if (!reader) return std::nullopt;
  const fstHandle handle = find_handle(reader.get(), name);
  if (handle == 0) return std::nullopt;
  fstReaderSetFacProcessMask(reader.get(), handle);
  std::vector<Edge> edges;
  if (!fstReaderIterBlocks(reader.get(), take_change, &edges, nullptr)) return std::nullopt;
  return edges;
}

}  // namespace gnomon::sim::test
