// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "shape.hpp"

#include <scree/app/json.hpp>
#include <scree/app/study.hpp>
#include <scree/io/checkpoint.hpp>
#include <scree/io/write_file.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

namespace scree::test::study_tests {
namespace {

using namespace shape;
using Catch::Matchers::ContainsSubstring;
using Texts = std::vector<std::string>;

/// A program whose runs multiply the length and the corners of a shape; paint.maker names a checkpoint to start from.
struct ShapeProgram {
  Folder folder;
  CommandLine line{.quiet = true, .vary = {"shape.length=[1, 2]", "shape.corners=[3, 4]"}};
  Program program{.name = "shape", .summary = "", .results = {"summary.json"}, .restart = "paint.maker"};
  Schema<Options> all = schema();
  Texts ran = {};  ///< the members that ran, "length corners maker"

  ShapeProgram() { line.output = folder / "out"; }

  /// Runs the members that have not finished; simulate(options, output) returns an exit code.
  template <class Simulate>
  int run(Simulate const& simulate) {
    ran.clear();
    app::detail::Study study(line, all.list(), &all.standard(), program);
    std::vector<Options> members(study.size());
    for (std::size_t k = 0; k < members.size(); ++k) study.read(k, &members[k]);
    study.check();
    for (std::size_t k = 0; k < members.size(); ++k) {
      Options scratch;
      study.look(k, &members[k], &scratch);
    }
    study.check();
    for (std::size_t k = 0; k < members.size(); ++k)
      if (!study.finished(k)) study.run(k, [&] { return run(study, k, members[k], simulate); });
    return study.finish(0);
  }
  template <class Simulate>
  int run(app::detail::Study& study, std::size_t k, Options& options, Simulate const& simulate) {
    auto const any = study.begin(k, &options);
    ran.push_back(fmt::format("{} {} {}", options.shape.length, options.shape.corners, options.paint.maker));
    any.directory->begin(any.case_text);
    return simulate(options, any.output);
  }
  std::string table() const { return content_of(line.output / "study.csv"); }
};
int area(Options const& o, std::filesystem::path const& output) {
  scree::write_file(output / "summary.json", to_json({{"area", o.shape.length * o.shape.corners}}));
  return 0;
}

}  // namespace

TEST_CASE("a study runs each member in a directory of its own and makes one table") {
  ShapeProgram all;
  CHECK(all.run(area) == 0);
  CHECK(all.ran == Texts{"1 3 nobody", "1 4 nobody", "2 3 nobody", "2 4 nobody"});
  CHECK(all.table() ==
        "member,state,shape.length [m],shape.corners,area,message\n"
        "1,finished,1,3,3,\n2,finished,1,4,4,\n3,finished,2,3,6,\n4,finished,2,4,8,\n");
  CHECK_THAT(content_of(all.line.output / "3" / "case.toml"), ContainsSubstring("length = 2\n"));
}

TEST_CASE("members that have finished do not run again, unless by force") {
  ShapeProgram all;
  all.run(area);
  auto const table = all.table();
  CHECK(all.run(area) == 0);
  CHECK(all.ran.empty());
  CHECK(all.table() == table);
  all.line.force = true;
  CHECK(all.run(area) == 0);
  CHECK(all.ran.size() == 4);
}

TEST_CASE("a member that failed begins anew or goes on from its checkpoint") {
  ShapeProgram all;
  auto const fails = [&](Options const& o, std::filesystem::path const& output) {
    if (o.shape.length == 2 && o.shape.corners == 4) scree::write_checkpoint(output / "checkpoint.h5", {});
    return o.shape.length == 2 ? throw std::runtime_error("disk full") : area(o, output);
  };
  CHECK(all.run(fails) == 1);
  CHECK_THAT(all.table(), ContainsSubstring("3,failed,2,3,,error: disk full\n"));
  CHECK(all.run(area) == 0);
  CHECK(all.ran == Texts{"2 3 nobody", "2 4 " + (all.line.output / "4" / "checkpoint.h5").string()});
  CHECK(all.run(area) == 0);  // the case of a member that went on is still the same
  CHECK(all.ran.empty());
}

TEST_CASE("a study refuses the directory of another one") {
  ShapeProgram all;
  all.run(area);
  all.line.vary = {"shape.length=[1, 2]", "shape.corners=[3, 5]"};
  CHECK_THROWS_WITH(all.run(area), ContainsSubstring("2/case.toml: is of another case ('corners = 4' there, 'corners = "
                                                     "5' here); give another --output, or --force to replace it") &&
                                       ContainsSubstring("4/case.toml") && !ContainsSubstring("3/case.toml"));
  scree::write_file(all.line.output / "1" / "case.toml", "[form]\n");
  CHECK_THROWS_WITH(all.run(area), ContainsSubstring("1/case.toml:1:2: form: unknown section"));
}

TEST_CASE("one study at a time writes to a directory, and a wrong one writes to none") {
  ShapeProgram all;
  all.line.vary = {"shape.length=[1, 20]"};
  CHECK_THROWS_AS(all.run(area), CaseError);
  CHECK(all.ran.empty());
  CHECK_FALSE(std::filesystem::exists(all.line.output / "1"));
  app::detail::Study const study(all.line, all.all.list(), &all.all.standard(), all.program);
  CHECK_THROWS_WITH(all.run(area), ContainsSubstring("another run"));
}

TEST_CASE("a program that runs one case at a time refuses several workers") {
  ShapeProgram all;
  all.line.workers = 2;
  app::detail::Study const study(all.line, all.all.list(), &all.all.standard(), all.program);
  CHECK(study.workers(false) == 2);
  CHECK_THROWS_WITH(study.workers(true), "--workers: shape runs one case at a time");
}

TEST_CASE("a program that knows no studies refuses them") {
  ShapeProgram all;
  CHECK_THROWS_AS(start(all.line, all.all, all.program), CaseError);
}

}  // namespace scree::test::study_tests
