// Gradescope, "Download Submissions": folders submission_<id> and submission_metadata.yml,
// which says whose they are. A group has several submitters. The keys of the file are Ruby's
// symbols
// (":name").

#include <yaml-cpp/yaml.h>

#include <set>

#include "grader/base/errors.h"
#include "grader/base/safe_file.h"
#include "grader/base/text.h"
#include "grader/roster/layouts/layouts.h"
#include "grader/roster/listing.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMetadata = "submission_metadata.yml";

bool recognise_gradescope(const fs::path& folder) {
  return is_real_file(folder / kMetadata);
}

/// The text under a key, with or without the colon of a symbol; empty if there is none.
std::string text_of(const YAML::Node& node, const std::string& key) {
  for (const std::string& name : std::vector<std::string>{":" + key, key}) {
    const YAML::Node value = node[name];
    if (value && value.IsScalar()) return printable(value.Scalar());
  }
  return {};
}

std::vector<Person> people_of(const YAML::Node& submission) {
  std::vector<Person> people;
  const YAML::Node submitters =
      submission[":submitters"] ? submission[":submitters"] : submission["submitters"];
  for (const YAML::Node& submitter : submitters) {
    Person person{text_of(submitter, "sid"), text_of(submitter, "name"),
                  text_of(submitter, "email")};
    if (person.id.empty()) person.id = person.email.empty() ? person.name : person.email;
    if (!person.id.empty()) people.push_back(person);
  }
  return people;
}

void add_listed(const fs::path& folder, const YAML::Node& metadata, Roster& roster,
                std::set<std::string>& listed) {
  for (const auto& entry : metadata) {
    const std::string name = entry.first.as<std::string>();
    listed.insert(name);
    if (!is_real_folder(folder / fs::path(name).filename())) {
      roster.left_out.push_back(
          {name, std::string("listed in ") + kMetadata + ", but there is no such folder"});
      continue;
    }
    HandIn hand_in;
    hand_in.key = name;
    hand_in.people = people_of(entry.second);
    hand_in.submitted_at = text_of(entry.second, "created_at");
    hand_in.parts = {{folder / fs::path(name).filename(), name}};
    roster.hand_ins.push_back(std::move(hand_in));
  }
}

void read_gradescope(const fs::path& folder, const std::string& /*assignment*/,
                     Roster& roster) {
  std::set<std::string> listed;
  try {
    const YAML::Node metadata = YAML::Load(read_whole_file(folder / kMetadata));
    if (!metadata.IsMap()) throw UserError((folder / kMetadata).string() + ": is no map");
    add_listed(folder, metadata, roster, listed);
  } catch (const YAML::Exception& error) {
    throw UserError((folder / kMetadata).string() + ": cannot be read: " + error.what());
  }
  for (const fs::path& entry : entries_of(folder)) {
    const std::string name = entry.filename().string();
    if (name == kMetadata || listed.count(name) != 0) continue;
    if (is_real_folder(entry) && name.rfind("submission_", 0) == 0) {
      // Nobody knows whose it is, but it is not to be lost.
      roster.hand_ins.push_back({name, {{name, "", ""}}, {{entry, name}}, "", false});
    } else {
      roster.left_out.push_back({name, "not a submission's folder"});
    }
  }
}

}  // namespace

Layout gradescope_layout() {
  return {"gradescope", "the export of a Gradescope assignment", recognise_gradescope,
          read_gradescope};
}

}  // namespace meshgrade
