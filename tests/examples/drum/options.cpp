// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <support/folder.hpp>

#include <example_paths.hpp>

#include <drum/schema.hpp>
#include <scree/app/case_file.hpp>
#include <scree/app/describe.hpp>
#include <scree/io/write_file.hpp>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::drum_options_tests {
using namespace drum;

namespace {

std::filesystem::path const folder = SCREE_EXAMPLES "/drum";
auto const ev = folder / "ev.toml", en = folder / "en.toml", three = folder / "ternary.toml";

/// The case EN of the paper; all other options are those of EV.
Options equal_number() {
  Options o;
  o.geometry.fill_depth = 0.591;
  o.segregation.C0 = 0.1111111111111111;
  return o;
}

/// Three sizes.
Options ternary() {
  Options o;
  o.segregation.closure = Closure::schlick;
  o.species = {.diameters = {0.25e-3, 0.4e-3, 0.64e-3}, .shares = {0.35, 0.35, 0.3}};
  return o;
}

std::string errors(std::vector<std::string> const& overrides) {
  try {
    scree::app::read_case(schema(), ev, overrides);
  } catch (scree::app::CaseError const& error) {
    return error.what();
  }
  return "";
}
std::vector<std::string> notes(std::vector<std::string> const& overrides) {
  return scree::app::read_case(schema(), ev, overrides).notes;
}

void check_file(std::filesystem::path const& file, Options const& expected) {
  auto const found = scree::app::read_case(schema(), file);
  CHECK(found.notes.empty());
  auto const text = scree::app::case_text(schema(), expected);
  CHECK(scree::app::case_text(schema(), found.options) == text);
  // After a change of options.hpp, update the files with `test_examples "[.renew]"`.
  auto const lines = content_of(file);
  CHECK(lines.substr(lines.find("\n\n") + 2) == text);
}

}  // namespace

TEST_CASE("the drum's case files are what the declarations and the paper's two cases say") {
  check_file(ev, Options{});
  check_file(en, equal_number());
  check_file(three, ternary());
}

TEST_CASE("a case file of the drum of version 0.1.0 is read, and its keys of that version are told") {
  auto const old = std::filesystem::path(SCREE_EXAMPLES "/../tests/reliability/golden/version_0_1/case.toml");
  auto const found = scree::app::read_case(schema(), old, std::vector<std::string>{"time.restart_from=a.h5"});
  CHECK(found.options.output.checkpoints == 1e-9);
  CHECK(found.options.output.restart_from == "a.h5");
  CHECK(found.notes.size() == 3);
  CHECK(found.notes.back() == "--set: time.restart_from: it is now called output.restart_from");
}

TEST_CASE("every default of the drum is allowed and every option is described") {
  auto const all = schema();
  for (auto const& option : all.options()) {
    INFO(option.key());
    CHECK_FALSE(option.about.meaning.empty());
    CHECK(errors({option.key() + "=" + option.text(&all.standard())}).empty());
  }
}

TEST_CASE("options of the drum that contradict each other are refused") {
  CHECK(errors({"numerics.spacing=0.0036"}) ==
        "--set: numerics.spacing: more than a tenth of geometry.radius: too coarse for a drum");
  CHECK(errors({"geometry.fill_depth=0.1"}).starts_with("--set: geometry.fill_depth: the bed, "));
  CHECK(errors({"geometry.length=0.005"}).empty());
  CHECK(errors({"geometry.length=0.005", "numerics.dimension=3"}).starts_with("--set: geometry.length: less than 4"));
  CHECK(errors({"material.d_large=0.0001"}) == "--set: material.d_large: smaller than material.d_small");
  for (std::string const closure : {"schlick", "trewhela"}) {
    CHECK(errors({"segregation.closure=" + closure}).empty());
    CHECK(errors({"segregation.closure=" + closure, "segregation.flux=asymmetric"})
              .starts_with("--set: segregation.flux: not symmetric"));
  }
  CHECK(errors({"material.grain_density=1000"}).starts_with("--set: material.grain_density: less than"));
  CHECK(errors({"material.mu_d=0.3"}).starts_with("--set: material.mu_d: less than material.mu_s"));
  CHECK(errors({"material.stiffness_factor=0.0005"}).starts_with("--set: material.stiffness_factor: so soft"));
  CHECK(errors({"output.profile_times=[2, 1]"}) == "--set: output.profile_times: its times do not rise");
}

TEST_CASE("lists of sizes that make no mixture are refused, and what a list replaces is told") {
  auto const with = [](std::string const& diameters, std::string const& shares, std::vector<std::string> more = {}) {
    more.insert(more.end(),
                {"segregation.closure=schlick", "species.diameters=" + diameters, "species.shares=" + shares});
    return more;
  };
  std::string const three_sizes = "[0.25e-3, 0.35e-3, 0.5e-3]", key = "--set: species.";
  CHECK(errors(with(three_sizes, "[0.2, 0.3, 0.5]")).empty());
  CHECK(errors(with("[0.5e-3, 0.25e-3, 0.25e-3]", "[0.3333333, 0.6666667, 0]")).empty());  // any order, alike, absent
  CHECK(errors(with(three_sizes, "[0.2, 0.3, 0.4]")) == key + "shares: they add up to 0.9, not to 1");
  CHECK(errors(with(three_sizes, "[0.333, 0.333, 0.333]")) == key + "shares: they add up to 0.999, not to 1");
  CHECK(errors(with(three_sizes, "[0.5, 0.5]")) == key + "shares: 2 shares for 3 species.diameters");
  CHECK(errors(with("[]", "[0.5, 0.5]")) == key + "shares: 2 shares for 0 species.diameters");
  CHECK(errors(with("[1e-3]", "[1]")) == key + "diameters: 1 diameter; a list has 2 to 5, and an empty one is no list");
  CHECK(errors(with("[1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 1e-3]", "[1, 0, 0, 0, 0, 0]")).starts_with(key + "diameters: 6 "));
  CHECK(errors(with("[0.25e-3, 0]", "[0.5, 0.5]")).starts_with(key + "diameters: "));
  CHECK(errors(with("[0.25e-3, 0.5e-3]", "[1.5, -0.5]")).starts_with(key + "shares: "));
  auto const list = with(three_sizes, "[0.2, 0.3, 0.5]");
  auto const and_with = [&](std::string const& setting) {
    auto all = list;
    all.push_back(setting);
    return all;
  };
  CHECK(errors(and_with("segregation.scheme=hcsr")).starts_with("--set: segregation.scheme: not conservative"));
  CHECK(errors(and_with("segregation.flux=asymmetric")).find("segregation.flux: not symmetric") != std::string::npos);
  CHECK(errors(and_with("segregation.closure=shear-rate")).starts_with("--set: segregation.closure: not \"schlick\""));
  CHECK(notes(and_with("segregation.C0=0.1")) ==
        std::vector<std::string>{"--set: segregation.C0: has no effect while species.diameters is given"});
}

TEST_CASE("options of the drum without effect are noted") {
  CHECK(notes({"segregation.V=1e-3"}) ==
        std::vector<std::string>{"--set: segregation.V: has no effect unless segregation.closure = \"constant\""});
  CHECK(notes({"segregation.V=1e-3", "segregation.closure=constant"}).empty());
  CHECK(notes({"segregation.chi_V=0.1", "segregation.closure=schlick"}).size() == 1);
  CHECK(notes({"segregation.flux=asymmetric", "segregation.closure=none"}).size() == 1);
  CHECK(notes({"numerics.filter_period=10", "numerics.stress_filter=none"}).size() == 1);
  CHECK(notes({"geometry.ends=walled"}).size() == 1);
  CHECK(notes({"geometry.ends=walled", "numerics.dimension=3"}).empty());
}

TEST_CASE("the drum's artificial viscosity does not change with the stiffness") {
  Options soft, hard;
  hard.material.stiffness_factor = 1;
  CHECK(sound_speed(hard) == Catch::Approx(94.7).margin(0.1));  // Table 1
  CHECK(sound_speed(soft) == Catch::Approx(sound_speed(hard) / 10));
  CHECK(artificial_viscosity(soft) * sound_speed(soft) == Catch::Approx(0.5));
  CHECK(artificial_viscosity(hard) * sound_speed(hard) == Catch::Approx(0.5));
  CHECK(artificial_dynamic_viscosity(soft) == artificial_dynamic_viscosity(hard));
  CHECK(artificial_dynamic_viscosity(soft) == Catch::Approx(1500 * 0.5 * 1.5e-3 / 16));
  CHECK(half_turn(soft) == Catch::Approx(6));
  CHECK(initial_level(soft) == Catch::Approx(-0.0056));
}

TEST_CASE("renew the drum's case files from its options.hpp", "[.renew]") {
  for (auto const& [file, options] :
       {std::pair{ev, Options{}}, std::pair{en, equal_number()}, std::pair{three, ternary()}}) {
    auto const lines = content_of(file);
    scree::write_file(file, lines.substr(0, lines.find("\n\n") + 2) + scree::app::case_text(schema(), options));
  }
}

}  // namespace scree::test::drum_options_tests
