#include <CLI/CLI.hpp>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "grader/base/errors.h"
#include "tests/bench/check_bench.h"
#include "tests/bench/class_bench.h"
#include "tests/bench/mesh_bench.h"
#include "tests/bench/setup_bench.h"

namespace meshgrade::bench {
namespace {

struct Arguments {
  Selection selection;
  std::string json;
  Programs programs{MESHGRADE_PROGRAM, ""};
};

void add_options(CLI::App& app, Arguments& arguments) {
  Selection& selection = arguments.selection;
  app.add_flag("--quick", selection.quick, "Small meshes and few rounds: a minute");
  app.add_option("--only", selection.tables,
                 "Only these tables; setup, some minutes, is made only when it is named")
      ->check(CLI::IsMember({"build", "normals", "flips", "splits", "loop", "catmull-clark",
                             "threads", "memory", "check", "class", "setup"}));
  app.add_option("--mesh", selection.meshes, "Only these meshes")
      ->check(CLI::IsMember({"1k", "20k", "330k", "330k shuffled", "1.3M"}));
  app.add_option("--json", arguments.json, "Write all samples and goals to this file as JSON");
  app.add_option("--program", arguments.programs.now,
                 "The meshgrade program to time `check` and `batch` of")
      ->check(CLI::ExistingFile);
  app.add_option("--against-program", arguments.programs.before,
                 "Another one, of an older revision, to take turns with it; --against REVISION "
                 "builds it")
      ->check(CLI::ExistingFile);
  app.footer(
      "Examples:\n"
      "  meshgrade bench --quick\n"
      "  meshgrade bench --only loop memory --mesh 20k 330k\n"
      "  meshgrade bench --json bench.json\n"
      "  meshgrade bench --only check class --against v1.4   beside an older revision\n"
      "Compare ratios, not times: the machine's other work is in the times. Goals that are\n"
      "missed do not change the exit code.");
}

Results run(const Arguments& arguments) {
  Results results;
  keep_heap_warm();
  results.tables = run_mesh_bench(arguments.selection);
  if (arguments.selection.has_table("check")) {
    results.tables.push_back(run_check_bench(arguments.programs, arguments.selection.quick));
  }
  if (arguments.selection.has_table("class")) {
    results.tables.push_back(run_class_bench(arguments.programs, arguments.selection.quick));
  }
  if (arguments.selection.names("setup"))
    results.tables.push_back(run_setup_bench(arguments.programs));
  std::vector<Goal> goals = mesh_goals();
  for (const auto& more : {check_goals(), class_goals(), setup_goals()})
    goals.insert(goals.end(), more.begin(), more.end());
  for (const Goal& goal : goals) {
    if (const auto result = evaluate(goal, results.tables)) results.goals.push_back(*result);
  }
  return results;
}

void write_json(const std::string& file, const Results& results) {
  std::ofstream out(file);
  out << to_json(results).dump(2) << "\n";
  if (!out.flush()) throw UserError(file + ": cannot be written");
}

int main_or_throw(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Times Meshgrade's parts against their peers, and says which goals are met.",
               "meshgrade bench");
  add_options(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  std::cout << "compiled by " MESHGRADE_COMPILER_NAME " with" MESHGRADE_FLAGS "\n";
  const Results results = run(arguments);
  for (const Table& table : results.tables)
    print(std::cout, table);
  print(std::cout, results.goals);
  if (!arguments.json.empty()) write_json(arguments.json, results);
  return 0;
}

}  // namespace
}  // namespace meshgrade::bench

int main(int argc, char** argv) {
  try {
    return meshgrade::bench::main_or_throw(argc, argv);
  } catch (const meshgrade::UserError& error) {
    std::cerr << "meshgrade bench: " << error.what() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "meshgrade bench: " << error.what() << "\n";
    return 3;
  }
}
