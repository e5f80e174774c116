#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "grader/report/report.h"

namespace meshgrade {

/// What the page may reach: nothing, or the server that it came from.
enum class PageAccess { kNone, kOwnServer };

/// Puts data into the viewer's page, such that no text of it can end its element.
/// @throws GraderError if this is not the viewer's page
std::string fill_page(std::string page, const nlohmann::ordered_json& data, PageAccess access);

/// The report as one HTML file that asks for no other: the JSON report inside the viewer's
/// page, with the meshes of the steps that went wrong.
std::string to_html(const Report& report, const std::string& page);

/// The results of a class as a page: points, verdicts by exercise, and a table of all.
///
/// @param results  as in the file class.json of a batch
/// @param links    for each hand-in's key, the page of its report, seen from this page
/// @param similar  `groups` of keys that share `percent` of their code, and the `page` that
/// shows it
std::string class_to_html(const nlohmann::ordered_json& results,
                          const std::map<std::string, std::string>& links,
                          const nlohmann::ordered_json& similar, const std::string& page);

}  // namespace meshgrade
