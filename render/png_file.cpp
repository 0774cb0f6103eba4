#include "render/png_file.h"

#include <png.h>

#include <stdexcept>
#include <string>

#include "core/error.h"
#include "core/file.h"

namespace drape::render {

// No picture of ours is larger, and a damaged header must not make us ask for all memory.
static constexpr png_uint_32 largest_side = 16384;

// libpng's simplified interface keeps its long jumps to itself: errors come back as words.
struct PngImage {
  png_image image{};
  PngImage() { image.version = PNG_IMAGE_VERSION; }
  ~PngImage() { png_image_free(&image); }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
};

[[noreturn]] static void refuse(const std::filesystem::path& path, const std::string& words) {
  throw FileError(path.string(), "is not a whole PNG file: " + words);
}

static void check_size(const std::filesystem::path& path, const png_image& image) {
  if (image.width >= 1 && image.height >= 1 && image.width <= largest_side && image.height <= largest_side)
    return;
  throw FileError(path.string(), "has " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                                     " pixels; a side can have up to " + std::to_string(largest_side));
}

Image read_png(const std::filesystem::path& path) {
  const std::string content = read_file(path);
  PngImage png;
  if (!png_image_begin_read_from_memory(&png.image, content.data(), content.size()))
    refuse(path, png.image.message);
  check_size(path, png.image);
  png.image.format = PNG_FORMAT_RGB;
  png.image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
  Image image{static_cast<int>(png.image.width), static_cast<int>(png.image.height), {}};
  image.rgb.resize(PNG_IMAGE_SIZE(png.image));
  const png_color black{0, 0, 0};
  if (!png_image_finish_read(&png.image, &black, image.rgb.data(), 0, nullptr))
    refuse(path, png.image.message);
  return image;
}

static void check_complete(const Image& image) {
  const bool has_size = image.width >= 1 && image.height >= 1;
  if (has_size && image.rgb.size() == 3 * static_cast<std::size_t>(image.width) * image.height) return;
  throw std::invalid_argument("an image needs three bytes for each of its pixels");
}

// The flag means no filter and level 3: the dither makes filters useless, and higher levels cost 5 to 10
// times as much for little.
static std::string encode(const std::filesystem::path& path, const Image& image) {
  PngImage png;
  png.image.width = static_cast<png_uint_32>(image.width);
  png.image.height = static_cast<png_uint_32>(image.height);
  png.image.format = PNG_FORMAT_RGB;
  png.image.flags = PNG_IMAGE_FLAG_FAST;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png.image);
  std::string content(size, '\0');
  if (!png_image_write_to_memory(&png.image, content.data(), &size, 0, image.rgb.data(), 0, nullptr)) {
    throw FileError(path.string(), std::string("cannot be made a PNG file: ") + png.image.message);
  }
  content.resize(size);
  return content;
}

void write_png(const std::filesystem::path& path, const Image& image) {
  check_complete(image);
  write_file(path, encode(path, image));
}

}  // namespace drape::render
