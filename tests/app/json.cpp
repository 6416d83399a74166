// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/json.hpp>

#include <catch2/catch_test_macros.hpp>

#include <limits>

namespace scree::test::json_tests {
using namespace scree::app;

TEST_CASE("JSON keeps digits, escapes texts and nests") {
  auto const text = to_json({{"steps", 12},
                             {"mean_C", 0.1 + 0.2},
                             {"scheme", "a \"b\" \\c"},
                             {"clipped", false},
                             {"missing", std::numeric_limits<double>::quiet_NaN()},
                             {"compared", Json::Array{Json::Object{{"t", 20.0}, {"mae", 1e-12}}, 3}}});
  CHECK(text == R"({
    "clipped" : false,
    "compared" : [
        {
            "mae" : 9.9999999999999998e-13,
            "t" : 20.0
        },
        3
    ],
    "mean_C" : 0.30000000000000004,
    "missing" : "NaN",
    "scheme" : "a \"b\" \\c",
    "steps" : 12
}
)");
}

}  // namespace scree::test::json_tests
