// `--figures` of `meshgrade check` and `meshgrade replay`.

#include <nlohmann/json.hpp>
#include <set>

#include "tests/commands/command_line.h"

namespace meshgrade {
namespace {

using testing::HasSubstr;
using testing::Not;

class FiguresOption : public CommandLine {
 protected:
  std::filesystem::path pictures() const { return folder_ / "new" / "pictures"; }

  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(pictures()))
      names.insert(entry.path().filename().string());
    return names;
  }

  static std::string content(const std::filesystem::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
};

TEST_F(FiguresOption, CheckDrawsTheExplainedFailuresAndSaysWhere) {
  const std::string json = (folder_ / "report.json").string();
  const Said said = call({"check", wrong("edge_flip/next_wrong"), "edge_flip", "--figures",
                          pictures().string(), "--json", json});
  EXPECT_EQ(said.status, 1);
  std::set<std::string> named;
  const auto report = nlohmann::json::parse(content(json));
  for (const auto& judged : report.at("exercises").at(0).at("cases")) {
    if (judged.contains("figure")) named.insert(judged.at("figure").get<std::string>());
  }
  EXPECT_FALSE(named.empty());
  EXPECT_EQ(files(), named);
  EXPECT_THAT(said.output,
              HasSubstr(std::to_string(named.size()) + " pictures of what is wrong"));
  EXPECT_THAT(said.output,
              HasSubstr("picture   " + (pictures() / "edge_flip_basic_1.svg").string()));
  EXPECT_THAT(content(pictures() / "edge_flip_basic_1.svg"), HasSubstr("h3.next must be"));
}

TEST_F(FiguresOption, CheckDrawsNothingOfTheReference) {
  const Said said = call({"check", reference(), "edge_flip", "--figures", pictures().string()});
  EXPECT_THAT(said.output, HasSubstr("no pictures"));
  EXPECT_FALSE(std::filesystem::exists(pictures())) << "an empty folder is left behind";
}

TEST_F(FiguresOption, EmptyFolderThatWasThereBeforeStays) {
  std::filesystem::create_directories(pictures());
  call({"check", reference(), "edge_flip", "--figures", pictures().string()});
  EXPECT_TRUE(std::filesystem::is_directory(pictures()));
}

TEST_F(FiguresOption, OtherFilesOfTheFolderStay) {
  std::filesystem::create_directories(pictures());
  std::ofstream(pictures() / "mine.txt") << "mine";
  std::ofstream(pictures() / "edge_flip_basic_1.svg") << "old";
  call({"replay", "edge_flip:basic/1", wrong("edge_flip/next_wrong"), "--figures",
        pictures().string()});
  EXPECT_EQ(files(), (std::set<std::string>{"mine.txt", "edge_flip_basic_1.svg"}));
  EXPECT_EQ(content(pictures() / "mine.txt"), "mine");
  EXPECT_THAT(content(pictures() / "edge_flip_basic_1.svg"), HasSubstr("<svg"));
}

TEST_F(FiguresOption, ReplaySaysWhereItsPictureIs) {
  const Said said = call({"replay", "edge_flip:basic/1", wrong("edge_flip/next_wrong"),
                          "--figures", pictures().string()});
  EXPECT_EQ(said.status, 1);
  EXPECT_THAT(said.output, HasSubstr((pictures() / "edge_flip_basic_1.svg").string()));
}

TEST_F(FiguresOption, FolderThatCannotBeMadeIsToldBeforeAnythingIsGraded) {
  write("new", "a file");
  const Said said = call(
      {"check", wrong("edge_flip/next_wrong"), "edge_flip", "--figures", pictures().string()});
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.output, HasSubstr(pictures().string()));
  EXPECT_THAT(said.output, Not(HasSubstr("points")));
}

}  // namespace
}  // namespace meshgrade
