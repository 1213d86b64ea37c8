// SPDX-License-Identifier: Apache-2.0
// What each kind of light has, and has to have.
#include "host/scene/scene_lights.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "host/config/nearest.hpp"

namespace gnomon::scene {
namespace {

using config::Document;

constexpr double kLargestAngle = 160;  ///< degrees; wider cones have nearly no tangent plane to project on
constexpr double kLargestPosition = 1e90;  ///< as for a model's coordinates

struct Kind {
  std::string_view name;
  std::vector<std::string_view> keys;  ///< besides type
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{{"directional", {"direction"}},
                                     {"spot", {"position", "direction", "target", "angle"}},
                                     {"point", {"position"}}};
  return all;
}

/// A light that does not say is directional.
Result<const Kind*> read_kind(const Document& document, const Pointer& at) {
  if (!has(document, at, "type")) {
    if (has(document, at, "position"))
      return document.refuse(
          at, key_of(at) + " has a position but no type, expected type = \"spot\" or \"point\"");
    return &kinds().front();
  }
  const Result<std::string> name = read_text(document, at / "type");
  if (!name) return tl::make_unexpected(name.error());
  std::vector<std::string_view> names;
  for (const Kind& kind : kinds()) {
    if (kind.name == *name) return &kind;
    names.push_back(kind.name);
  }
  return document.refuse(at / "type", fmt::format("{} = \"{}\" is no type of light, {}", key_of(at / "type"),
                                                  *name, config::suggestion(*name, names)));
}

/// Refuses what another kind of light has.
Result<void> check_belongs(const Document& document, const Pointer& at, const Kind& kind) {
  for (const auto& [key, value] : document.root().at(at).items()) {
    if (key == "type" || std::ranges::find(kind.keys, key) != kind.keys.end()) continue;
    return document.refuse(at / key, fmt::format("{}: a {} light has no {}, expected {}", key_of(at / key),
                                                 kind.name, key, fmt::join(kind.keys, ", ")));
  }
  return {};
}

Result<Vec3> read_direction(const Document& document, const Pointer& at) {
  Result<Vec3> vector = read_vector(document, at);
  if (!vector) return vector;
  if (vector->length() == 0) return document.refuse(at, key_of(at) + " is no direction: its length is zero");
  if (!std::isfinite(vector->length()))
    return document.refuse(at, key_of(at) + " is too long for a direction");
  return vector->normalized();
}

Result<Vec3> read_position(const Document& document, const Pointer& light, const char* key,
                           std::string_view kind) {
  if (!has(document, light, key))
    return document.refuse(light, fmt::format("{} is a {} light and has no {}", key_of(light), kind, key));
  Result<Vec3> position = read_vector(document, light / key);
  if (!position) return position;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs((*position)[axis]) > kLargestPosition)
      return document.refuse(
          light / key, fmt::format("{} is farther away than {:g}", key_of(light / key), kLargestPosition));
  }
  return position;
}

/// Which way a spot at `position` points: along its direction, or to its target.
Result<Vec3> read_aim(const Document& document, const Pointer& at, const Vec3& position) {
  const bool aimed = has(document, at, "target");
  if (aimed && has(document, at, "direction"))
    return document.refuse(at / "target",
                           key_of(at / "target") + " next to direction, expected one or the other");
  if (!aimed && !has(document, at, "direction"))
    return document.refuse(at, key_of(at) + " is a spot light and has neither direction nor target");
  if (!aimed) return read_direction(document, at / "direction");
  Result<Vec3> target = read_position(document, at, "target", "spot");
  if (!target) return target;
  const Vec3 way = *target - position;
  if (way.length() == 0)
    return document.refuse(at / "target", key_of(at / "target") + " is where the light is");
  return way.normalized();
}

Result<Light> read_spot(const Document& document, const Pointer& at) {
  const Result<Vec3> position = read_position(document, at, "position", "spot");
  if (!position) return tl::make_unexpected(position.error());
  const Result<Vec3> direction = read_aim(document, at, *position);
  if (!direction) return tl::make_unexpected(direction.error());
  if (!has(document, at, "angle"))
    return document.refuse(at,
                           key_of(at) + " is a spot light and has no angle, the cone's opening in degrees");
  const Result<double> angle = read_number(document, at / "angle");
  if (!angle) return tl::make_unexpected(angle.error());
  if (!(*angle > 0) || *angle > kLargestAngle)
    return document.refuse(at / "angle",
                           fmt::format("{} = {} is out of range, expected above 0 and at most {} degrees",
                                       key_of(at / "angle"), *angle, kLargestAngle));
  return SpotLight{*position, *direction, *angle / 2};
}

Result<Light> read_directional(const Document& document, const Pointer& at) {
  if (!has(document, at, "direction")) return document.refuse(at, key_of(at) + " has no direction");
  return read_direction(document, at / "direction").map([](const Vec3& way) -> Light {
    return DirectionalLight{way};
  });
}

}  // namespace

Result<Light> read_light(const Document& document, const Pointer& at) {
  if (Result<void> table = expect(document, at, &nlohmann::json::is_object, "a table"); !table)
    return tl::make_unexpected(table.error());
  if (Result<void> known = document.check_keys(at, {"type", "direction", "position", "target", "angle"});
      !known)
    return tl::make_unexpected(known.error());
  const Result<const Kind*> kind = read_kind(document, at);
  if (!kind) return tl::make_unexpected(kind.error());
  if (Result<void> fits = check_belongs(document, at, **kind); !fits)
    return tl::make_unexpected(fits.error());
  if ((*kind)->name == "directional") return read_directional(document, at);
  if ((*kind)->name == "spot") return read_spot(document, at);
  return read_position(document, at, "position", "point").map([](const Vec3& p) -> Light {
    return PointLight{p};
  });
}

}  // namespace gnomon::scene
