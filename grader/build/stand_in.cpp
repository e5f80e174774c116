#include "grader/build/stand_in.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "grader/base/errors.h"

namespace meshgrade {
namespace {

/// No submitted file can have this name.
std::string file_name(const StandIn& stand_in) {
  return "~" + stand_in.exercise + ".cpp";
}

std::string without(const std::vector<std::string>& functions, const std::string& name,
                    std::string text) {
  LeavingOut rest(name, std::move(text));
  for (const std::string& function : functions)
    rest.remove_function(function);
  return rest.text();
}

std::string read_reference(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw GraderError("the reference's file " + file.string() + " cannot be read");
  return text;
}

}  // namespace

std::optional<Submission> with_stand_ins(Submission submission, const Home& home,
                                         const std::vector<StandIn>& stand_ins) {
  // The reference has other functions than homework for Scotty3D.
  if (home.reference.empty() || submission.dialect == Dialect::kScotty3d) return std::nullopt;
  for (auto* files : {&submission.sources, &submission.headers}) {
    for (SourceFile& file : *files) {
      for (const StandIn& stand_in : stand_ins)
        file.text = without(stand_in.functions, file.name, std::move(file.text));
    }
  }
  // At the end, so that they go when there are two definitions, and not the student's file.
  for (const StandIn& stand_in : stand_ins) {
    const std::string name = file_name(stand_in);
    std::string text =
        read_reference(home.reference / stand_in.folder / (stand_in.exercise + ".cpp"));
    const std::size_t at = text.find(stand_in.was);
    if (at == std::string::npos) return std::nullopt;
    text.replace(at, stand_in.was.size(), stand_in.becomes);
    submission.sources.push_back({name, without(stand_in.kept, name, std::move(text))});
  }
  return submission;
}

bool has_stand_ins(const Build& build, const std::vector<StandIn>& stand_ins) {
  return std::all_of(stand_ins.begin(), stand_ins.end(), [&](const StandIn& stand_in) {
    const BuiltFile* file = build.find(file_name(stand_in));
    return file != nullptr && file->ok && file->left_out.empty();
  });
}

}  // namespace meshgrade
