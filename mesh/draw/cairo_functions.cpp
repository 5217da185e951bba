// SPDX-License-Identifier: MIT
#include "asterism/mesh/draw/cairo_functions.hpp"

#include <dlfcn.h>

#include <string>
#include <type_traits>

namespace asterism::internal {
namespace {

// Names of the library, which contain the version of its interface.
#ifdef __APPLE__
constexpr const char* library_name = "libcairo.2.dylib";
#else
constexpr const char* library_name = "libcairo.so.2";
#endif

struct loaded {
  cairo_functions functions;
  std::string missing;  // what failed, if anything did
};

// Keeps the library loaded: its data for the whole process could not be freed safely.
loaded load() {
  loaded cairo;
  void* const library = dlopen(library_name, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* const why = dlerror();
    cairo.missing = why != nullptr ? why : library_name;
    return cairo;
  }
  const auto find = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
    if (function == nullptr) cairo.missing = std::string(library_name) + " has no " + name;
  };
#define ASTERISM_FIND(name) find(cairo.functions.name, "cairo_" #name);
  ASTERISM_CAIRO_FUNCTIONS(ASTERISM_FIND)
#undef ASTERISM_FIND
  return cairo;
}

}  // namespace

result<const cairo_functions*> load_cairo() {
  static const loaded cairo = load();
  if (!cairo.missing.empty())
    return error{"cairo, which draws pictures, is missing: " + cairo.missing};
  return &cairo.functions;
}

}  // namespace asterism::internal
