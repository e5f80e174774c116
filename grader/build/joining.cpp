#include "grader/build/joining.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "grader/build/file_scope.h"

namespace meshgrade {
namespace {

using Names = std::set<std::string>;

/// Headers of the standard library that every source has through meshedit.h.
const Names& always_included() {
  static const Names names{"<algorithm>", "<array>",   "<cmath>", "<cstddef>",
                           "<iostream>",  "<list>",    "<map>",   "<set>",
                           "<string>",    "<utility>", "<vector>"};
  return names;
}

/// Whether it is meshedit.h or one of those that it includes: every source has them already.
bool is_shared_header(const std::string& include) {
  static const Names names{"bezier.h",         "fault.h",    "halfedge_mesh.h", "meshedit.h",
                           "mesh_resampler.h", "vector2d.h", "vector3d.h"};
  const std::string folder = "meshedit/";
  const std::string name = include.substr(1, include.size() - 2);
  return name.rfind(folder, 0) == 0 && names.count(name.substr(folder.size())) != 0;
}

bool is_plain_name(const std::string& name) {
  return std::all_of(name.begin(), name.end(), [](char c) {
    return c == '_' || c == '.' || c == '-' || c == '~' || (c >= '0' && c <= '9') ||
           (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  });
}

bool are_disjoint(const Names& a, const Names& b) {
  return std::none_of(a.begin(), a.end(),
                      [&](const std::string& name) { return b.count(name) != 0; });
}

bool could_see_each_other(const FileScope& a, const FileScope& b) {
  return !are_disjoint(a.declares, b.words) || !are_disjoint(b.declares, a.words);
}

/// What must be the same in all sources that are joined: headers and using directives.
using Surroundings = std::pair<Names, Names>;

Surroundings surroundings_of(const FileScope& scope) {
  Names headers;
  for (const std::string& include : scope.includes) {
    if (!is_shared_header(include) && always_included().count(include) == 0)
      headers.insert(include);
  }
  return {headers, scope.usings};
}

/// Whether all that a source includes belongs to the grader or to the library.
bool includes_nothing_handed_in(const FileScope& scope,
                                const std::vector<SourceFile>& headers) {
  return std::all_of(
      scope.includes.begin(), scope.includes.end(), [&](const std::string& text) {
        const std::string name = text.substr(1, text.size() - 2);
        const bool handed_in =
            std::any_of(headers.begin(), headers.end(),
                        [&](const SourceFile& header) { return header.name == name; });
        return !handed_in && (text[0] == '<' || is_shared_header(text));
      });
}

/// Of these files, the first and all that see nothing of those taken before.
std::vector<std::size_t> without_clashes(const std::vector<std::size_t>& files,
                                         const std::vector<FileScope>& scopes) {
  std::vector<std::size_t> taken;
  for (std::size_t i : files) {
    if (std::none_of(taken.begin(), taken.end(), [&](std::size_t other) {
          return could_see_each_other(scopes[i], scopes[other]);
        })) {
      taken.push_back(i);
    }
  }
  return taken;
}

}  // namespace

std::vector<std::size_t> joinable(const std::vector<SourceFile>& sources,
                                  const std::vector<SourceFile>& headers) {
  std::vector<FileScope> scopes;
  std::map<Surroundings, std::vector<std::size_t>> alike;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    scopes.push_back(read_file_scope(sources[i].text));
    if (scopes[i].is_plain && is_plain_name(sources[i].name) &&
        includes_nothing_handed_in(scopes[i], headers)) {
      alike[surroundings_of(scopes[i])].push_back(i);
    }
  }
  std::vector<std::size_t> best;
  for (const auto& [surroundings, files] : alike) {
    std::vector<std::size_t> joined = without_clashes(files, scopes);
    if (joined.size() > best.size()) best = std::move(joined);
  }
  return best.size() > 1 ? best : std::vector<std::size_t>();
}

std::vector<std::vector<std::size_t>> share_out(const std::vector<std::size_t>& joined,
                                                std::size_t units) {
  const std::size_t count = std::min(units, joined.size());
  std::vector<std::vector<std::size_t>> parts(count);
  for (std::size_t i = 0; i < joined.size(); ++i)
    parts[i * count / joined.size()].push_back(joined[i]);
  return parts;
}

std::string joined_source(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names)
    text += "#include \"" + name + "\"\n";
  return text;
}

}  // namespace meshgrade
