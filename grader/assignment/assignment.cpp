#include "grader/assignment/assignment.h"

#include <toml++/toml.h>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "grader/assignment/late_rule.h"
#include "grader/assignment/toml_section.h"
#include "grader/base/errors.h"
#include "grader/base/text.h"

namespace meshgrade {
namespace {

Limits read_limits(TomlSection section) {
  Limits limits;
  const auto read = [&](const char* key, std::uint32_t& limit) {
    limit = section.get_positive(key, limit);
  };
  read("compile_seconds", limits.compile_seconds);
  read("compile_memory_mb", limits.compile_memory_mb);
  read("object_mb", limits.object_mb);
  read("case_cpu_ms", limits.case_cpu_ms);
  read("case_wall_ms", limits.case_wall_ms);
  read("run_seconds", limits.run_seconds);
  read("memory_mb", limits.memory_mb);
  read("result_mb", limits.result_mb);
  read("output_mb", limits.output_mb);
  read("processes", limits.processes);
  read("open_files", limits.open_files);
  section.refuse_unknown_keys();
  return limits;
}

SubmissionRules read_submission(TomlSection section) {
  SubmissionRules rules;
  rules.headers = section.get("headers", rules.headers);
  rules.files = section.get_positive("files", rules.files);
  rules.file_kb = section.get_positive("file_kb", rules.file_kb);
  section.refuse_unknown_keys();
  return rules;
}

std::optional<HiddenCases> read_hidden(TomlSection section) {
  HiddenCases hidden;
  hidden.seed_file = section.require<std::string>("seed_file");
  if (hidden.seed_file.empty()) section.fail_at("seed_file", "must name a file");
  const auto show = section.get<std::string>("show", "name");
  if (show == "rule") {
    hidden.show = HiddenShow::kRule;
  } else if (show == "all") {
    hidden.show = HiddenShow::kAll;
  } else if (show != "name") {
    section.fail_at("show", "must be \"name\", \"rule\" or \"all\"");
  }
  section.refuse_unknown_keys();
  return hidden;
}

/// Own meshes lie beside the assignment.
void find_own_meshes(Assignment& assignment, const std::filesystem::path& file) {
  for (ExerciseRubric& exercise : assignment.exercises) {
    for (Group& group : exercise.groups) {
      for (OwnMesh& mesh : group.meshes) {
        std::error_code error;
        mesh.file = file.parent_path() / mesh.name;
        mesh.is_there = std::filesystem::is_regular_file(mesh.file, error);
        if (!mesh.is_there && !mesh.hidden) {
          throw UserError(mesh.place + ": there is no file " + mesh.file.string());
        }
      }
    }
  }
}

/// The number in the seed file, which lies beside the assignment unless its name says
/// otherwise.
void read_seed(HiddenCases& hidden, const std::filesystem::path& assignment) {
  hidden.seed_file = assignment.parent_path() / hidden.seed_file;
  std::ifstream stream(hidden.seed_file);
  if (!stream.is_open()) return;
  std::string word;
  std::string more;
  stream >> word >> more;
  const bool digits = !word.empty() && word.size() < 19 && more.empty() &&
                      word.find_first_not_of("0123456789") == std::string::npos;
  if (!digits) {
    throw UserError(hidden.seed_file.string() +
                    ": must hold one whole number, the seed of the hidden cases");
  }
  hidden.seed = std::stoull(word);
}

/// Packages hold the file under this name beside the assignment.
void require_beside(TomlSection& section, const std::string& name) {
  const std::filesystem::path path(name);
  const bool goes_up = std::any_of(
      path.begin(), path.end(), [](const std::filesystem::path& part) { return part == ".."; });
  if (name.empty() || path.is_absolute() || goes_up || path.filename().empty()) {
    section.fail_at("file", "must name a mesh beside the assignment or in a folder below it");
  }
}

OwnMesh read_own_mesh(TomlSection& section) {
  OwnMesh mesh;
  mesh.place = section.place();
  mesh.name = section.require<std::string>("file");
  require_beside(section, mesh.name);
  mesh.file = mesh.name;
  mesh.hidden = section.get("hidden", false);
  if (section.has("levels")) mesh.levels = section.get_positive("levels", 1);
  if (mesh.levels > 5) section.fail_at("levels", "must be at most 5");
  if (section.has("edges") && section.is_text("edges")) {
    const auto edges = section.get<std::string>("edges", "");
    if (edges == "inner") mesh.edges = EdgesOf::kInner;
    if (edges == "boundary") mesh.edges = EdgesOf::kBoundary;
    if (edges == "every") mesh.edges = EdgesOf::kEvery;
    if (!mesh.edges) {
      section.fail_at("edges",
                      "must be \"inner\", \"boundary\", \"every\" or a list of pairs of "
                      "vertices, as [[0, 1], [4, 2]]");
    }
  } else if (section.has("edges")) {
    mesh.edges = EdgesOf::kNamed;
    mesh.named_edges = section.require_pairs("edges");
  }
  section.refuse_unknown_keys();
  return mesh;
}

Group read_group(TomlSection& section, const std::vector<Group>& before) {
  Group group;
  group.place = section.place();
  group.name = section.require<std::string>("name");
  group.title = section.get<std::string>("title", group.name);
  group.points = section.require_at_least("points", 0.0);
  group.extra_credit = section.get("extra_credit", false);
  group.partial = section.get_choice<Partial>(
      "partial",
      {{"none", Partial::kNone}, {"cases", Partial::kCases}, {"pointers", Partial::kPointers}});
  group.needs = section.get<std::string>("needs", "");
  const auto named = [](const std::string& name) {
    return [name](const Group& other) { return other.name == name; };
  };
  if (std::any_of(before.begin(), before.end(), named(group.name))) {
    section.fail_at("name", "\"" + group.name + "\" is there twice");
  }
  if (!group.needs.empty() && std::none_of(before.begin(), before.end(), named(group.needs))) {
    section.fail_at("needs", "must name a group of this exercise that comes before this one");
  }
  for (TomlSection& mesh : section.sections_if_any("mesh"))
    group.meshes.push_back(read_own_mesh(mesh));
  section.refuse_unknown_keys();
  return group;
}

ExerciseRubric read_exercise(TomlSection& section, const Assignment& assignment) {
  ExerciseRubric exercise;
  exercise.place = section.place();
  exercise.name = section.require<std::string>("name");
  if (assignment.find(exercise.name) != nullptr) {
    section.fail_at("name", "\"" + exercise.name + "\" is there twice");
  }
  exercise.title = section.get<std::string>("title", exercise.name);
  exercise.needs = section.get_strings("needs");
  for (const std::string& name : exercise.needs) {
    if (assignment.find(name) == nullptr) {
      section.fail_at("needs", "names \"" + name + "\", which is no exercise before this one");
    }
  }
  exercise.options = section.section("options").all_options();
  for (TomlSection& group : section.sections("group")) {
    exercise.groups.push_back(read_group(group, exercise.groups));
  }
  section.refuse_unknown_keys();
  return exercise;
}

bool is_plain_name(const std::string& name) {
  return std::all_of(name.begin(), name.end(), is_word_character);
}

Assignment read_table(const toml::table& table, const std::string& name) {
  TomlSection root(table, name, "");
  Assignment assignment;
  if (root.require<std::int64_t>("version") != 1) root.fail_at("version", "must be 1");
  assignment.title = root.require<std::string>("title");
  assignment.folder = root.get<std::string>("folder", "");
  if (!is_plain_name(assignment.folder))
    root.fail_at("folder", "must be a name of letters, digits and _");
  const auto seed = root.require<std::int64_t>("seed");
  if (seed < 0) root.fail_at("seed", "must not be negative");
  assignment.seed = static_cast<std::uint64_t>(seed);
  assignment.tolerance = root.get("tolerance", 1e-5);
  if (!(assignment.tolerance > 0.0 && assignment.tolerance < 1e-2)) {
    root.fail_at("tolerance", "must be greater than 0 and less than 0.01");
  }
  assignment.limits = read_limits(root.section("limits"));
  assignment.submission = read_submission(root.section("submission"));
  root.section("late");  // read by read_late_rule()
  if (table.contains("hidden")) assignment.hidden = read_hidden(root.section("hidden"));
  for (TomlSection& exercise : root.sections("exercise")) {
    assignment.exercises.push_back(read_exercise(exercise, assignment));
  }
  root.refuse_unknown_keys();
  return assignment;
}

double sum_points(const std::vector<Group>& groups, bool extra_credit) {
  double sum = 0.0;
  for (const Group& group : groups) {
    if (group.extra_credit == extra_credit) sum += group.points;
  }
  return sum;
}

}  // namespace

std::string ExerciseRubric::by_other_names(std::string text) const {
  for (const auto& [ours, other] : other_names) {
    for (std::size_t at = text.find(ours); at != std::string::npos;
         at = text.find(ours, at + other.size()))
      text.replace(at, ours.size(), other);
  }
  return text;
}

double ExerciseRubric::points() const {
  return sum_points(groups, false);
}
double ExerciseRubric::extra_points() const {
  return sum_points(groups, true);
}

std::vector<OwnMesh> Assignment::own_meshes() const {
  std::vector<OwnMesh> all;
  for (const ExerciseRubric& exercise : exercises) {
    for (const Group& group : exercise.groups)
      all.insert(all.end(), group.meshes.begin(), group.meshes.end());
  }
  return all;
}

double Assignment::points() const {
  double sum = 0.0;
  for (const ExerciseRubric& exercise : exercises)
    sum += exercise.points();
  return sum;
}

const ExerciseRubric* Assignment::find(const std::string& exercise) const {
  for (const ExerciseRubric& rubric : exercises) {
    if (rubric.name == exercise) return &rubric;
  }
  return nullptr;
}

Assignment parse_assignment(const std::string& text, const std::string& name) {
  parse_late_rule(text, name);  // its mistakes, too, are told before any work
  try {
    return read_table(toml::parse(text, name), name);
  } catch (const toml::parse_error& error) {
    throw UserError(name + ":" + std::to_string(error.source().begin.line) + ": " +
                    std::string(error.description()));
  }
}

Assignment read_assignment(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream.good() || std::filesystem::is_directory(file)) {
    throw UserError(file.string() + ": cannot be read; name an assignment file (.toml)");
  }
  Assignment assignment = parse_assignment(text.str(), file.string());
  if (assignment.hidden) read_seed(*assignment.hidden, file);
  find_own_meshes(assignment, file);
  return assignment;
}

}  // namespace meshgrade
