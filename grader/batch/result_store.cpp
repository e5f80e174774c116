#include "grader/batch/result_store.h"

#include <nlohmann/json.hpp>

#include "grader/base/digest.h"
#include "grader/base/errors.h"
#include "grader/base/safe_file.h"
#include "grader/report/json_report.h"
#include "grader/report/report_reader.h"
#include "grader/roster/roster.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kStatusFile = "result.json";
constexpr const char* kResultSchema = "meshgrade-result/1";
constexpr const char* kDamaged = "its result is damaged";

std::string dump(const Json& value) {
  return value.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// SHA-256 of the value without its own.
std::string checksum_of(Json value) {
  value.erase("checksum");
  return sha256(dump(value));
}

ResultStatus find_status(const std::string& name) {
  for (const ResultStatus status :
       {ResultStatus::kGraded, ResultStatus::kUngradable, ResultStatus::kGraderError}) {
    if (name == status_name(status)) return status;
  }
  throw UserError("unknown status " + name);
}

/// @throws UserError, Json::exception if anything is not as it was written
Result read_result(const fs::path& folder, const std::string& key) {
  const Json value = Json::parse(read_whole_file(folder / kStatusFile));
  if (value.at("schema") != kResultSchema || value.at("checksum") != checksum_of(value) ||
      value.at("key") != key) {
    throw UserError(kDamaged);
  }
  Result result;
  result.key = key;
  result.fingerprint = value.at("fingerprint");
  result.status = find_status(value.at("status"));
  result.reason = value.at("reason");
  const std::string text = read_whole_file(folder / "report.txt");
  if (value.at("text_sha256") != sha256(text)) throw UserError(kDamaged);
  if (result.status == ResultStatus::kGraded) {
    const std::string report = read_whole_file(folder / "report.json");
    if (value.at("report_sha256") != sha256(report)) throw UserError(kDamaged);
    result.report = read_report(report);
  }
  return result;
}

}  // namespace

const char* status_name(ResultStatus status) {
  switch (status) {
    case ResultStatus::kGraded:
      return "graded";
    case ResultStatus::kUngradable:
      return "ungradable";
    case ResultStatus::kGraderError:
      return "grader error";
    case ResultStatus::kMissing:
      break;
  }
  return "not graded yet";
}

ResultStore result_store(const fs::path& batch_folder) {
  return ResultStore(batch_folder / "results");
}

fs::path ResultStore::folder_of(const std::string& key) const {
  return folder_ / safe_file_name(key);
}

fs::path ResultStore::make_folder(const std::string& key) const {
  fs::path folder = folder_of(key);
  meshgrade::make_folder(folder);
  return folder;
}

void ResultStore::save(const Result& result, const std::string& text) const {
  const fs::path folder = make_folder(result.key);
  std::error_code error;
  Json value{{"schema", kResultSchema},
             {"key", result.key},
             {"status", status_name(result.status)},
             {"reason", result.reason},
             {"fingerprint", result.fingerprint},
             {"text_sha256", sha256(text)},
             {"report_sha256", ""}};
  if (result.report) {
    const std::string report = to_json(*result.report);
    write_file_safely(folder / "report.json", report);
    value["report_sha256"] = sha256(report);
  } else {
    fs::remove(folder / "report.json", error);
  }
  write_file_safely(folder / "report.txt", text);
  value["checksum"] = checksum_of(value);
  write_file_safely(folder / kStatusFile, dump(value));
}

void ResultStore::take_over(const ResultStore& other, const std::string& key) const {
  const fs::path from = other.folder_of(key);
  const fs::path to = make_folder(key);
  std::error_code error;
  // The status goes first: without it, nothing else here is believed.
  fs::remove(to / kStatusFile, error);
  for (const auto& entry : fs::directory_iterator(to))
    fs::remove_all(entry.path(), error);
  for (const auto& entry : fs::recursive_directory_iterator(from)) {
    const fs::path name = entry.path().lexically_relative(from);
    if (!entry.is_regular_file() || name == kStatusFile) continue;
    fs::create_directories((to / name).parent_path(), error);
    write_file_safely(to / name, read_whole_file(entry.path()));
  }
  write_file_safely(to / kStatusFile, read_whole_file(from / kStatusFile));
}

std::string ResultStore::key_in(const fs::path& result_folder) {
  std::error_code error;
  if (!fs::exists(result_folder / kStatusFile, error)) return {};
  const Json value = Json::parse(read_whole_file(result_folder / kStatusFile), nullptr, false);
  return value.is_object() ? value.value("key", "") : "";
}

Result ResultStore::load(const std::string& key) const {
  Result missing;
  missing.key = key;
  const fs::path folder = folder_of(key);
  std::error_code error;
  if (!fs::exists(folder / kStatusFile, error)) return missing;
  try {
    return read_result(folder, key);
  } catch (const std::exception&) {
    missing.reason = kDamaged;
  }
  return missing;
}

}  // namespace meshgrade
