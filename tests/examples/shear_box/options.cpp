// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <support/folder.hpp>

#include <example_paths.hpp>
#include <scree/app/case_file.hpp>
#include <scree/app/describe.hpp>
#include <scree/io/write_file.hpp>
#include <shear_box/case.hpp>

#include <catch2/catch_test_macros.hpp>

namespace scree::test::shear_box_options_tests {
using namespace shear_box;

namespace {

std::filesystem::path const shipped = SCREE_EXAMPLES "/shear_box/shear_box.toml";

std::string errors(std::vector<std::string> const& overrides) {
  try {
    scree::app::read_case(schema(), shipped, overrides);
  } catch (scree::app::CaseError const& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the shipped case file is what the declarations say") {
  auto const found = scree::app::read_case(schema(), shipped);
  CHECK(found.notes.empty());
  auto const text = scree::app::case_text(schema(), Options{});
  CHECK(scree::app::case_text(schema(), found.options) == text);
  // After a change of options.hpp, update it with `test_examples "[.renew]"`.
  auto const lines = content_of(shipped);
  CHECK(lines.substr(lines.find("\n\n") + 2) == text);
}

TEST_CASE("every default of the shear box is allowed and every option is described") {
  auto const all = schema();
  for (auto const& option : all.options()) {
    INFO(option.key());
    CHECK_FALSE(option.about.meaning.empty());
    auto const text = option.text(&all.standard());
    if (text.empty())
      CHECK_FALSE(option.about.unset.empty());
    else
      CHECK(errors({option.key() + "=" + text}).empty());
  }
}

TEST_CASE("the flux takes the paper's amplitude and asymmetry by its name") {
  auto const with = [](std::vector<std::string> const& overrides) {
    return scree::app::read_case(schema(), shipped, overrides).options;
  };
  CHECK(with({}).flux_amplitude() == 1);
  CHECK(with({}).flux_asymmetry() == 0);
  CHECK(with({"model.flux=asymmetric"}).flux_amplitude() == 1.6);
  CHECK(with({"model.flux=asymmetric"}).flux_asymmetry() == 0.89);
  CHECK(with({"model.flux=asymmetric", "model.kappa=0.5"}).flux_asymmetry() == 0.5);
}

TEST_CASE("options of the shear box that contradict each other are refused or noted") {
  CHECK(errors({"geometry.d_large=0.001"}) == "--set: geometry.d_large: smaller than geometry.d_small");
  CHECK(errors({"output.compared=[20, 20]"}) == "--set: output.compared: its times do not rise");
  CHECK(errors({"geometry.width=0.005"}).starts_with("--set: geometry.width: less than four particles wide"));
  CHECK(errors({"geometry.height=0.001", "geometry.width=100", "numerics.spacing=0.0001"})
            .starts_with("--set: numerics.spacing: 1e+13 particles are more than the 2147483647 that can be counted"));
  CHECK(scree::app::read_case(schema(), shipped, std::vector<std::string>{"model.d_bar=0.004"}).notes ==
        std::vector<std::string>{"--set: model.d_bar: has no effect unless model.closure = \"shear-rate\""});
}

TEST_CASE("renew shear_box.toml from options.hpp", "[.renew]") {
  auto const lines = content_of(shipped);
  scree::write_file(shipped, lines.substr(0, lines.find("\n\n") + 2) + scree::app::case_text(schema(), Options{}));
}

}  // namespace scree::test::shear_box_options_tests
