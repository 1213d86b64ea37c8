// SPDX-License-Identifier: Apache-2.0
// The figures of a sweep that its report and its table for spreadsheets show. Names: docs/sweep.md,
// "Results".
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/sweep/store.hpp"

namespace gnomon::sweep {

struct Figure {
  std::string_view name;   ///< as in the store
  std::string_view label;  ///< with its unit
};

/// Those that plots offer, errors first. Smaller is better for all.
std::span<const Figure> plotted_figures();

/// Parameters that differ between some of the rows, with their values: numbers ascending, words in the order
/// of the registry.
struct Varied {
  std::string key;
  std::vector<std::string> values;
};
std::vector<Varied> varied_parameters(const std::vector<Row>& rows);

/// The value of a parameter in a row's configuration, as it would be written after --set.
std::string parameter_text(const Row& row, const std::string& key);

/// The published encodings: technique slb with 4 or 7 bits for both fraction and slope.
bool is_published(const Row& row);

/// Whether the published encodings are to be marked among these rows: not where there are no others.
bool marks_published(const std::vector<Row>& rows);

/// For each row, whether it is on its scene's front of border displacement (voxels), memory bits and, where
/// any of the scene's rows has one, area.
std::vector<bool> on_front(const std::vector<Row>& rows);

/// One line a done point: scene, 1 for the front, every varied parameter, every figure that some point has,
/// the command.
std::string csv_table(const std::vector<Row>& rows);

}  // namespace gnomon::sweep
