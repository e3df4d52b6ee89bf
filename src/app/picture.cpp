// SPDX-License-Identifier: MIT
#include "app/picture.hpp"

#include <map>

#include "app/gzip.hpp"
#include "app/option_checks.hpp"

#if BANKSHOT_PNG
#include <librsvg/rsvg.h>

#include <cmath>
#include <memory>
#endif

namespace bankshot::app {
namespace {

#if BANKSHOT_PNG
constexpr double zoom = 2;  // pixels of the PNG per pixel of the SVG: sharp in print and on dense screens

template <auto release>
struct Releases {
  template <class T>
  void operator()(T* p) const {
    release(p);
  }
};

void write_png(const std::string& path, const std::string& svg) {
  const auto* data = reinterpret_cast<const guint8*>(svg.data());
  const std::unique_ptr<RsvgHandle, Releases<g_object_unref>> handle(
      rsvg_handle_new_from_data(data, svg.size(), nullptr));
  double width = 0, height = 0;
  if (!handle || !rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height))
    throw WriteError(path + ": librsvg cannot read the picture");
  const std::unique_ptr<cairo_surface_t, Releases<cairo_surface_destroy>> surface(cairo_image_surface_create(
      CAIRO_FORMAT_ARGB32, static_cast<int>(std::ceil(zoom * width)), static_cast<int>(std::ceil(zoom * height))));
  const std::unique_ptr<cairo_t, Releases<cairo_destroy>> context(cairo_create(surface.get()));
  const RsvgRectangle whole{0, 0, zoom * width, zoom * height};
  if (!rsvg_handle_render_document(handle.get(), context.get(), &whole, nullptr))
    throw WriteError(path + ": librsvg cannot draw the picture");
  const cairo_status_t status = cairo_surface_write_to_png(surface.get(), path.c_str());
  if (status != CAIRO_STATUS_SUCCESS) throw WriteError(path + ": cannot be written: " + cairo_status_to_string(status));
}
#else
void write_png(const std::string& path, const std::string&) { throw WriteError(path + ": " + picture_name(path)); }
#endif

}  // namespace

void write_picture(const std::string& path, const std::string& svg) {
  path.ends_with(".png") ? write_png(path, svg) : write_file(path, svg);
}

std::string picture_name(const std::string& path) {
#if !BANKSHOT_PNG
  if (path.ends_with(".png")) return "this bankshot was built without librsvg (librsvg2-dev), which makes PNG";
#endif
  return file_name(path);
}

bool is_table(const std::string& path) { return unpacked_name(path).ends_with(".csv"); }

void add_output_option(CLI::App& command, std::vector<std::string>& files, const std::string& what) {
  const auto picture_or_table = [](const std::string& path) -> std::string {
    if (std::string bad = picture_name(path); !bad.empty()) return bad;
    if (is_table(path) || unpacked_name(path).ends_with(".svg") || path.ends_with(".png")) return "";
    return "\"" + path + "\" must end in .svg, .png or .csv";
  };
  command
      .add_option("-o,--output", files,
                  "Write " + what + " (.svg, .png) or a table (.csv) to this file; may be given twice")
      ->required()
      ->allow_extra_args(false)
      ->check(picture_or_table);
}

void add_theme_flag(CLI::App& command, Theme& theme) {
  const std::map<std::string, Theme> names{{"light", Theme::light}, {"dark", Theme::dark}};
  command.add_option("--theme", theme, "Colours of pictures: light (for paper) or dark")
      ->transform(CLI::CheckedTransformer(names).description("{light,dark}"))
      ->default_str("light");
}

void add_picture_flags(CLI::App& command, PictureFlags& flags) {
  command.add_option("--svg", flags.svg, "Write a picture to this file")->check([](const std::string& path) {
    return path.ends_with(".png") ? "\"" + path + "\" is a PNG: that is --png" : file_name(path);
  });
  command.add_option("--png", flags.png, "Write the picture as PNG to this file")->check([](const std::string& path) {
    return path.ends_with(".png") ? picture_name(path) : "\"" + path + "\" must end in .png";
  });
  add_theme_flag(command, flags.style.theme);
  command.add_flag("--animate", flags.style.moving, "Let the balls in the SVG move, in real time, again and again");
}

}  // namespace bankshot::app
