#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "grader/build/build.h"
#include "grader/build/kept_build.h"
#include "grader/build/member_splice.h"
#include "grader/build/workshop.h"

namespace meshgrade {

/// Runs the compiler on a submission's files, confined, each time in a folder of its own, and
/// gathers the objects in one. May be used by several threads at a time.
class UnitCompiler {
 public:
  /// @param splice   what students have added to the course's elements; may change between runs
  /// @param objects  the folder that they go to
  UnitCompiler(const Submission& submission, const Home& home, const Limits& limits,
               BuildKind kind, const MemberSplice& splice, std::filesystem::path objects);

  /// Compiles a source, or several as one; or takes the object that was kept of the same.
  ProcessResult compile(const std::vector<SourceFile>& unit, const std::string& object) const;

  /// Compiles a file of the drop-in's own. `name` begins with "~", as no submitted file does.
  ProcessResult compile_adapter(const std::string& name, const std::string& object) const;

  /// Compiles what of the worker sees the elements, with the members of this submission. It
  /// takes the place of the same functions in the worker's library.
  ProcessResult compile_driver(const std::string& object) const;

  /// Compiles nothing but the headers, with what is spliced into them.
  ProcessResult try_headers() const;

  /// "@flags.txt": the options of this kind of build.
  const std::string& flags() const { return flags_; }

  /// Divides what can be joined among the cores, so that what an earlier build has compiled
  /// need not be compiled again.
  /// @param joined  places in `sources`
  std::vector<std::vector<std::size_t>> divide(const std::vector<SourceFile>& sources,
                                               const std::vector<std::size_t>& joined) const;

 private:
  void put_headers(const Workshop& workshop) const;
  void add_headers(std::vector<std::string>& arguments) const;
  std::filesystem::path dropin() const;
  bool adds_later() const;
  std::vector<std::vector<std::size_t>> units_of_before(
      const std::vector<SourceFile>& sources, const std::vector<std::size_t>& joined) const;
  ProcessResult run(const std::vector<SourceFile>& unit, const std::string& file,
                    const std::string& object) const;
  ProcessResult run_anew(const std::vector<SourceFile>& unit, const std::string& file,
                         const std::string& object) const;
  ProcessResult compile_driver_anew(const std::string& object) const;
  template <typename Compile>
  ProcessResult kept_or(const std::vector<SourceFile>& unit, const std::string& object,
                        const Compile& compile) const;

  const Submission& submission_;
  const Home& home_;
  const Limits& limits_;
  const MemberSplice& splice_;
  std::string flags_;
  std::filesystem::path objects_;
  KeptObjects kept_;
};

}  // namespace meshgrade
