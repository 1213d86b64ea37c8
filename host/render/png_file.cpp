// SPDX-License-Identifier: Apache-2.0
// libpng's simplified interface, and the one place where pictures are turned upside down.
#include "host/render/png_file.hpp"

#include <png.h>

#include <system_error>
#include <utility>

namespace gnomon::render {
namespace {

/// Frees what libpng keeps, however the function is left.
struct PngImage {
  png_image image{};
  PngImage() { image.version = PNG_IMAGE_VERSION; }
  ~PngImage() { png_image_free(&image); }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
};

std::filesystem::path temporary_beside(const std::filesystem::path& path) {
  std::filesystem::path temporary = path;
  temporary += ".part";
  return temporary;
}

}  // namespace

Result<void> write_png(const Image& image, const std::filesystem::path& path) {
  PngImage png;
  png.image.width = static_cast<png_uint_32>(image.width);
  png.image.height = static_cast<png_uint_32>(image.height);
  png.image.format = PNG_FORMAT_RGB;
  const std::filesystem::path temporary = temporary_beside(path);
  // A negative stride writes the last row first: PNG's row 0 is the top.
  const png_int_32 stride = -3 * image.width;
  std::error_code error;
  if (png_image_write_to_file(&png.image, temporary.c_str(), 0, image.rgb.data(), stride, nullptr) == 0) {
    std::filesystem::remove(temporary, error);
    return fail(path.string() + ": cannot write the picture: " + png.image.message);
  }
  std::filesystem::rename(temporary, path, error);
  if (error) {
    const std::string reason = error.message();
    std::filesystem::remove(temporary, error);
    return fail(path.string() + ": cannot write the picture: " + reason);
  }
  return {};
}

Result<Image> read_png(const std::filesystem::path& path) {
  PngImage png;
  if (png_image_begin_read_from_file(&png.image, path.c_str()) == 0)
    return fail(path.string() + ": cannot read the picture: " + png.image.message);
  png.image.format = PNG_FORMAT_RGB;
  Image image{static_cast<int>(png.image.width), static_cast<int>(png.image.height),
              std::vector<std::uint8_t>(PNG_IMAGE_SIZE(png.image))};
  if (png_image_finish_read(&png.image, nullptr, image.rgb.data(), -3 * image.width, nullptr) == 0)
    return fail(path.string() + ": cannot read the picture: " + png.image.message);
  return image;
}

}  // namespace gnomon::render
