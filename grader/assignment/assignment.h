#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace meshgrade {

/// What a group earns of which not all cases pass.
enum class Partial {
  kNone,      ///< nothing
  kCases,     ///< the share of the cases that pass
  kPointers,  ///< by the pointers that are right in the cases that fail
};

/// Which edges of a mesh are flipped or split, each in a case of its own.
enum class EdgesOf { kInner, kBoundary, kEvery, kNamed };

/// A mesh of the instructor's own that a group is tried on, besides the standard ones.
struct OwnMesh {
  std::string name;            ///< as in the assignment: "meshes/ring.obj", beside it
  std::filesystem::path file;  ///< where it is
  bool is_there = true;        ///< false only where a hidden one is not handed out
  bool hidden = false;         ///< not handed out; its cases are hidden ones
  std::uint32_t levels = 0;    ///< of subdivision; 0: not said
  std::optional<EdgesOf> edges = std::nullopt;  ///< empty: not said
  /// If they are named, by their ends, vertices of the file counted from 0.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> named_edges = {};
  std::string place = {};  ///< "assignment.toml:42", for messages
};

/// Cases that points are given for together.
struct Group {
  std::string name;   ///< as in the cases: "basic"
  std::string title;  ///< what it tests, in a few words
  double points = 0.0;
  bool extra_credit = false;  ///< points on top, not needed for a full score
  Partial partial = Partial::kNone;
  std::string needs;  ///< a group that must earn something before this one counts
  std::string place;  ///< "assignment.toml:42", for messages
  std::vector<OwnMesh> meshes = {};
};

/// A setting of an exercise's own.
struct Option {
  std::string value;
  std::string place;  ///< "assignment.toml:42", for messages
};

struct ExerciseRubric {
  std::string name;                       ///< "edge_flip"
  std::string title;                      ///< "Edge flip"
  std::vector<std::string> needs;         ///< exercises whose functions this one calls
  std::map<std::string, Option> options;  ///< by their names
  std::vector<Group> groups;
  std::string place;  ///< "assignment.toml:42", for messages
  /// Functions by the names of our skeleton, and what they are called in the one that the
  /// submission was written for. Empty for ours.
  std::vector<std::pair<std::string, std::string>> other_names = {};

  /// A text with these functions called as in the submission's skeleton.
  std::string by_other_names(std::string text) const;

  double points() const;        ///< without extra credit
  double extra_points() const;  ///< extra credit
};

/// Memory and sizes are in megabytes of 1024 * 1024 bytes.
struct Limits {
  std::uint32_t compile_seconds = 60;
  std::uint32_t compile_memory_mb = 4096;
  std::uint32_t object_mb = 256;  ///< the largest file that compiling may make
  std::uint32_t case_cpu_ms = 5000;
  std::uint32_t case_wall_ms = 15000;
  std::uint32_t run_seconds = 300;
  std::uint32_t memory_mb = 2048;
  std::uint32_t result_mb = 512;
  std::uint32_t output_mb = 16;  ///< what one case may print
  std::uint32_t processes = 64;  ///< with threads
  std::uint32_t open_files = 64;
};

struct SubmissionRules {
  bool headers = true;  ///< headers next to the sources come along
  std::uint32_t files = 64;
  std::uint32_t file_kb = 1024;
};

/// What a student learns about a hidden case that failed.
enum class HiddenShow {
  kName,  ///< that it failed
  kRule,  ///< and which rule was broken
  kAll,   ///< everything, as of any other case
};

/// Cases that are not in the handout: of the same kinds, drawn by another seed.
struct HiddenCases {
  std::filesystem::path seed_file;    ///< holds the seed; not handed out
  std::optional<std::uint64_t> seed;  ///< what it says; empty where the file is not there
  HiddenShow show = HiddenShow::kName;
};

/// What is asked and what it is worth.
struct Assignment {
  std::string title;
  /// Of its files in reference, student_skeleton and docs/exercises; empty: at their top.
  std::string folder;
  std::uint64_t seed = 0;  ///< draws the random cases
  double tolerance = 0.0;  ///< of positions, relative to the size of the mesh
  Limits limits;
  SubmissionRules submission;
  std::optional<HiddenCases> hidden;
  std::vector<ExerciseRubric> exercises;  ///< in the order in which they are reported

  double points() const;
  /// All meshes of the instructor's own.
  std::vector<OwnMesh> own_meshes() const;
  const ExerciseRubric* find(const std::string& exercise) const;
};

/// Reads an assignment file (TOML; docs/assignment.md lists the keys), and the seed of hidden
/// cases if its file is there.
/// @throws UserError that names the file, the line and the key
Assignment read_assignment(const std::filesystem::path& file);

/// The same from text. `name` stands for the file in messages.
Assignment parse_assignment(const std::string& text, const std::string& name);

}  // namespace meshgrade
