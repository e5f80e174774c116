// Whom the live viewer answers, and that nothing that comes in does harm.

#include "grader/view/view_server.h"

#include <gtest/gtest.h>
#include <httplib.h>

#include <atomic>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/view/student_folder.h"

namespace meshgrade {
namespace {

using Json = nlohmann::ordered_json;
using httplib::Headers;

/// The viewer's page, but for what a browser would do with it.
constexpr const char* kPage = "connect-src 'none' <p>page</p> {\"kind\":\"empty\"}";

class ViewServerTest : public testing::Test {
 protected:
  ViewServerTest() : student_({"edge_flip.cpp"}), server_(*student_.session, kPage, "null") {
    server_.bind(0);
    serving_ = std::thread([this] { server_.serve(); });
    const std::string address = server_.address();
    token_ = address.substr(address.find('=') + 1);
    host_ = address.substr(7, address.find('/', 7) - 7);
    client_.emplace("http://" + host_);
    client_->set_read_timeout(30);
    // Wait until it answers.
    for (int i = 0; i < 100 && !client_->Get("/"); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  ~ViewServerTest() override {
    server_.stop();
    if (serving_.joinable()) serving_.join();
  }
  ViewServerTest(const ViewServerTest&) = delete;
  ViewServerTest& operator=(const ViewServerTest&) = delete;

  Headers with_token() const { return {{"X-Meshgrade-Token", token_}}; }

  httplib::Result post(const std::string& path, const std::string& body) {
    return client_->Post(path, with_token(), body, "application/json");
  }
  int status(const std::string& path, const std::string& body) {
    const httplib::Result result = post(path, body);
    return result ? result->status : 0;
  }
  Json state() { return Json::parse(post("/state", "")->body); }

  /// Everything is as it was at first, and the server still works.
  void expect_no_harm() {
    const Json now = state();
    EXPECT_EQ(now["mesh"], "cube.obj");
    EXPECT_EQ(now["timeline"].size(), 1U);
    EXPECT_EQ(status("/step", R"({"kind": "flip", "edge": 4})"), 200);
    EXPECT_EQ(state()["timeline"].at(1)["verdict"], "passed");
  }

  Student student_;
  ViewServer server_;
  std::thread serving_;
  std::string token_;
  std::string host_;
  std::optional<httplib::Client> client_;
};

TEST_F(ViewServerTest, PageComesWithItsTokenAndForbidsFraming) {
  const httplib::Result page = client_->Get("/?token=" + token_);
  ASSERT_TRUE(page);
  EXPECT_EQ(page->status, 200);
  EXPECT_NE(page->body.find(token_), std::string::npos);
  EXPECT_EQ(page->get_header_value("X-Frame-Options"), "DENY");
  EXPECT_EQ(page->get_header_value("Cache-Control"), "no-store");
}

TEST_F(ViewServerTest, TwoServersHaveDifferentTokens) {
  const ViewServer other(*student_.session, kPage, "null");
  const std::string address = other.address();
  EXPECT_EQ(token_.size(), 32U);
  EXPECT_NE(address.substr(address.find('=') + 1), token_);
}

TEST_F(ViewServerTest, OtherHostsAreRefusedAlsoWithTheToken) {
  const std::string port = host_.substr(host_.find(':'));
  for (const std::string& host : std::vector<std::string>{
           "evil.example", "evil.example" + port, "127.0.0.1.evil.example" + port, "127.0.0.1",
           "127.0.0.1:1", "[::1]" + port}) {
    Headers headers = with_token();
    headers.emplace("Host", host);
    const httplib::Result result = client_->Get("/", headers);
    ASSERT_TRUE(result) << host;
    EXPECT_EQ(result->status, 403) << host;
    EXPECT_EQ(result->body.find(token_), std::string::npos) << host;
  }
  Headers headers = with_token();
  headers.emplace("Host", "localhost" + port);
  EXPECT_EQ(client_->Get("/", headers)->status, 200);
  expect_no_harm();
}

TEST_F(ViewServerTest, OtherPagesAreRefusedAlsoWithTheToken) {
  for (const std::string& origin :
       std::vector<std::string>{"http://evil.example", "null", "https://" + host_,
                                "http://" + host_ + ".evil.example"}) {
    Headers headers = with_token();
    headers.emplace("Origin", origin);
    const httplib::Result result =
        client_->Post("/step", headers, R"({"kind": "flip", "edge": 4})", "text/plain");
    ASSERT_TRUE(result) << origin;
    EXPECT_EQ(result->status, 403) << origin;
    EXPECT_FALSE(result->has_header("Access-Control-Allow-Origin"));
  }
  Headers own = with_token();
  own.emplace("Origin", "http://" + host_);
  EXPECT_EQ(client_->Get("/", own)->status, 200);
  expect_no_harm();
}

TEST_F(ViewServerTest, NothingIsAnsweredWithoutTheToken) {
  std::string last_differs = token_;
  last_differs.back() = last_differs.back() == '0' ? '1' : '0';
  for (const std::string& token :
       std::vector<std::string>{"", "0", last_differs, token_ + "0", token_.substr(1)}) {
    const Headers headers{{"X-Meshgrade-Token", token}};
    EXPECT_EQ(client_->Get("/?token=" + token)->status, 403) << token;
    EXPECT_EQ(client_->Get("/events", headers)->status, 403) << token;
    for (const char* path :
         {"/state", "/step", "/go", "/open", "/normals", "/curve", "/patch"}) {
      EXPECT_EQ(client_->Post(path, headers, "{}", "application/json")->status, 403) << path;
    }
  }
  expect_no_harm();
}

TEST_F(ViewServerTest, ThereAreNoFilesWhateverThePath) {
  for (const char* path :
       {"/../../../../etc/passwd", "/..%2f..%2f..%2fetc%2fpasswd", "/%2e%2e/%2e%2e/etc/passwd",
        "//etc/passwd", "/edge_flip.cpp", "/./", "/state/../../etc/passwd", "/%00"}) {
    const httplib::Result result = client_->Get(path, with_token());
    ASSERT_TRUE(result) << path;
    EXPECT_EQ(result->status, 404) << path;
    EXPECT_EQ(result->body.find("root:"), std::string::npos) << path;
  }
  expect_no_harm();
}

TEST_F(ViewServerTest, BodyThatIsTooLargeIsRefused) {
  const httplib::Result result =
      client_->Post("/open?name=a.obj", with_token(), std::string((64U << 20U) + 1, 'v'),
                    "application/octet-stream");
  // It may have hung up before all was sent.
  EXPECT_TRUE(!result || result->status == 413);
  client_.emplace("http://" + host_);
  expect_no_harm();
}

TEST_F(ViewServerTest, BadJsonIsRefusedWithAReason) {
  const std::string deep(200'000, '[');
  for (const std::string& body :
       {std::string("{"), std::string("not json"), std::string("[]"), std::string("3"),
        std::string("null"), std::string("{\"kind\": \"\xff\"}"), std::string("\0\0", 2), deep,
        std::string(R"({"kind": 3})"), std::string(R"({"kind": "flip", "edge": 1e999})"),
        std::string(R"({"kind": "flip", "edge": "e4"})"),
        std::string(R"({"kind": "flip", "edge": 4.5})"),
        std::string(R"({"kind": "flip", "edge": -4})"),
        std::string(R"({"kind": "flip", "edge": 1e300})"), std::string(R"({"kind": "flip"})"),
        std::string(R"({"kind": "erase", "edge": 4})")}) {
    const httplib::Result result = post("/step", body);
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->status == 400 || result->status == 422) << body.substr(0, 50);
    EXPECT_NE(Json::parse(result->body)["error"].get<std::string>(), "");
  }
  expect_no_harm();
}

TEST_F(ViewServerTest, NumbersThatAreNoStepAreRefused) {
  for (const char* position : {"-1", "1", "4294967296", "1e300", "0.5", "null", "\"0\""}) {
    const int answer = status("/go", std::string("{\"position\": ") + position + "}");
    EXPECT_TRUE(answer == 400 || answer == 422) << position;
  }
  // 2^32 + 4 must not be taken for 4.
  EXPECT_EQ(status("/step", R"({"kind": "flip", "edge": 4294967300})"), 400);
  expect_no_harm();
}

TEST_F(ViewServerTest, FileThatIsNoMeshIsRefusedByItsOwnName) {
  const std::vector<std::pair<std::string, std::string>> files{
      {"empty.obj", ""},
      {"words.obj", "these are words\n"},
      {"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"},
      {"bow_tie.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nf 1 2 3\nf 1 4 5\n"},
      {"garbage.glb", std::string("glTF\0\0\0\0", 8)},
      {"unknown.exe", "MZ"},
      {"none", "v 0 0 0\n"},
      {"../../up.off", "OFF\n"}};
  for (const auto& [name, bytes] : files) {
    const httplib::Result result =
        client_->Post("/open?name=" + httplib::detail::encode_query_param(name), with_token(),
                      bytes, "application/octet-stream");
    ASSERT_TRUE(result) << name;
    EXPECT_EQ(result->status, 422) << name;
    const std::string error = Json::parse(result->body)["error"];
    EXPECT_EQ(error.find(std::filesystem::temp_directory_path().string() + "/"),
              std::string::npos)
        << error;
  }
  expect_no_harm();
}

TEST_F(ViewServerTest, FileThatIsSentIsShown) {
  const httplib::Result result =
      client_->Post("/open?name=mine.obj", with_token(), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                    "application/octet-stream");
  ASSERT_TRUE(result);
  EXPECT_EQ(result->status, 200) << result->body;
  EXPECT_EQ(state()["mesh"], "mine.obj");
  EXPECT_EQ(state()["state"]["mesh"]["v"].size(), 6U);
  EXPECT_TRUE(state()["notes"].empty());
}

TEST_F(ViewServerTest, WhatIsLeftOutOfAFileIsSaid) {
  const httplib::Result result = client_->Post("/open?name=mine.obj", with_token(),
                                               "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nf 1 2 3\n",
                                               "application/octet-stream");
  ASSERT_TRUE(result);
  EXPECT_EQ(state()["notes"], Json({"left out 1 vertex that belongs to no face"}));
}

TEST_F(ViewServerTest, EndsSoonThoughAPageHoldsItsConnection) {
  client_->set_keep_alive(true);
  ASSERT_TRUE(client_->Get("/", with_token()));
  const auto stopped = std::chrono::steady_clock::now();
  server_.stop();
  serving_.join();
  // Browsers hold connections that they may need again; five seconds were waited for each.
  EXPECT_LT(std::chrono::steady_clock::now() - stopped, std::chrono::seconds(4));
}

TEST_F(ViewServerTest, PagesAreToldOfAChange) {
  std::string news;
  std::thread listening([&] {
    httplib::Client listener("http://" + host_);
    listener.set_read_timeout(30);
    listener.Get("/events", with_token(), [&](const char* data, std::size_t size) {
      news.append(data, size);
      return news.find("changed") == std::string::npos;
    });
  });
  // It listens at some moment after it has asked: change again until it was told.
  std::atomic<bool> told{false};
  std::thread changing([&] {
    while (!told) {
      server_.change([](MeshSession&) {});
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  });
  listening.join();
  told = true;
  changing.join();
  EXPECT_NE(news.find("data: changed"), std::string::npos);
}

}  // namespace
}  // namespace meshgrade
