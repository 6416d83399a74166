// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: an enumeration with a function names_of\(\) next to it
#include <scree/app/schema.hpp>

namespace paint {

enum class Colour { red, blue };
#ifdef FIXED
constexpr auto names_of(Colour) { return scree::app::Names<Colour, 2>{{{Colour::red, "red"}, {Colour::blue, "blue"}}}; }
#endif

struct Coat {
  Colour colour = Colour::red;
};
struct Options {
  Coat coat;
};

scree::app::Schema<Options> schema() {
  scree::app::Schema<Options> all;
  all.section("coat", &Options::coat, "The coat").add("colour", &Coat::colour, {.meaning = "of the coat"});
  return all;
}

}  // namespace paint
