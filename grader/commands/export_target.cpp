#include "grader/commands/export_target.h"

#include <ctime>
#include <iostream>

#include "grader/base/errors.h"
#include "grader/base/safe_file.h"
#include "grader/base/text.h"

namespace meshgrade {
namespace {

void write(const std::vector<ExportTarget>& targets, const StudentResult& result) {
  ExportOptions options;
  options.time = time_of_export();
  for (const ExportTarget& target : targets) {
    const std::string text = target.format->write(result, options);
    if (target.file == "-") {
      std::cout << text << std::flush;
    } else {
      write_file_safely(target.file, text);
    }
  }
}

}  // namespace

std::vector<ExportTarget> parse_export_targets(const std::vector<std::string>& texts) {
  std::vector<ExportTarget> targets;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const StudentExport* format = find_student_export(text.substr(0, equals));
    if (format == nullptr || equals == std::string::npos || equals + 1 == text.size()) {
      std::vector<std::string> names;
      for (const StudentExport& known : student_exports())
        names.emplace_back(known.name);
      throw UserError("--write takes FORMAT=FILE, for example gradescope=results.json, and " +
                      printable(text) + " is none; the formats are " + join(names, ", "));
    }
    targets.push_back({format, text.substr(equals + 1)});
  }
  return targets;
}

std::vector<Output> outputs_of(const std::vector<ExportTarget>& targets) {
  std::vector<Output> outputs;
  for (const ExportTarget& target : targets)
    outputs.push_back({std::string("--write ") + target.format->name, target.file});
  return outputs;
}

void write_exports(const std::vector<ExportTarget>& targets, const Report& report) {
  if (report.has_grader_error()) {
    write_exports(targets, ResultStatus::kGraderError, "the grader failed in one of the cases");
    return;
  }
  const Report seen = student_view(report);
  write(targets, {seen.submission, ResultStatus::kGraded, "", &seen});
}

void write_exports(const std::vector<ExportTarget>& targets, ResultStatus status,
                   const std::string& reason) {
  write(targets, {"submission", status, printable(reason), nullptr});
}

std::string time_of_export() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &parts);
  return text;
}

}  // namespace meshgrade
