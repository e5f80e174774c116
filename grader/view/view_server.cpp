#include "grader/view/view_server.h"

#include <httplib.h>

#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <random>

#include "grader/base/errors.h"
#include "grader/base/process.h"
#include "grader/base/text.h"
#include "grader/files/mesh_file.h"
#include "grader/report/html_report.h"
#include "grader/view/bezier_view.h"
#include "grader/view/page_answer.h"
#include "grader/view/view_json.h"

namespace meshgrade {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostUploaded = 64U << 20U;
constexpr std::size_t kMostConnections = 32;
constexpr auto kHeartbeat = std::chrono::seconds(5);

/// A request that this page would not send.
class BadRequest : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

std::string random_token() {
  std::random_device system;
  std::string token;
  for (int word = 0; word < 4; ++word) {
    unsigned bits = system();
    for (int digit = 0; digit < 8; ++digit, bits >>= 4U)
      token += "0123456789abcdef"[bits & 15U];
  }
  return token;
}

/// Takes as long whatever differs.
bool same_token(const std::string& a, const std::string& b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference |= static_cast<unsigned>(a[i] ^ b[i]);
  return difference == 0;
}

/// A number that stands for an element or a step: nothing else is turned into one.
std::uint32_t whole_number(const Json& request, const char* key) {
  const Json& value = request.at(key);
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > kUnsetRef) {
    throw BadRequest(std::string(key) + " must be a whole number");
  }
  return value.get<std::uint32_t>();
}

/// {"kind": "collapse", "face": 2}, {"kind": "weld", "edge": 3, "partner": 7}
ViewOperation operation_of(const std::vector<ViewVerb>& verbs, const Json& request) {
  const std::string word = request.at("kind");
  for (const ViewVerb& verb : verbs) {
    const char* kind = kind_name(verb.picks);
    if (verb.word != word || (verb.picked > 0 && !request.contains(kind))) continue;
    ViewOperation operation{verb.exercise, verb.picks, {}};
    if (verb.picked > 0) operation.picked.push_back(whole_number(request, kind));
    if (verb.picked > 1) operation.picked.push_back(whole_number(request, "partner"));
    return operation;
  }
  const std::string kinds = picked_by_word(verbs, word);
  if (!kinds.empty()) throw BadRequest(word + " takes: " + kinds);
  throw UserError("there is no operation " + word);
}

/// A mesh that the page has sent, read like any file of its name.
LoadedMesh read_sent(const std::string& name, const std::string& bytes) {
  const ScratchFolder folder;
  const std::filesystem::path own = std::filesystem::path(name).filename();
  const std::string extension = own.extension().string();
  if (extension.empty() || extension.size() > 8) throw UserError(name + ": not a mesh file");
  const std::filesystem::path file = folder.path() / ("mesh" + extension);
  std::ofstream(file, std::ios::binary) << bytes;
  try {
    return read_mesh(file);
  } catch (const UserError& error) {
    // The user's name for it, not ours.
    const std::string what = error.what();
    const std::string path = file.string();
    throw UserError(what.rfind(path, 0) == 0 ? own.string() + what.substr(path.size()) : what);
  }
}

}  // namespace

class ViewServer::Impl {
 public:
  Impl(MeshSession& session, std::string page, std::string start)
      : session_(session),
        page_(std::move(page)),
        start_(std::move(start)),
        token_(random_token()) {
    server_.set_payload_max_length(kMostUploaded);
    server_.set_keep_alive_max_count(1000);
    server_.set_keep_alive_timeout(1);  // stop() waits for connections that are idle
    // Each open page holds one for its news.
    server_.new_task_queue = [] { return new httplib::ThreadPool(kMostConnections); };
    server_.set_pre_routing_handler(
        [this](const httplib::Request& request, httplib::Response& response) {
          return may_come_in(request, response) ? httplib::Server::HandlerResponse::Unhandled
                                                : httplib::Server::HandlerResponse::Handled;
        });
    add_routes();
  }

  void bind(int port) {
    port_ = port == 0 ? server_.bind_to_any_port("127.0.0.1")
                      : (server_.bind_to_port("127.0.0.1", port) ? port : -1);
    if (port_ < 0) {
      throw UserError("port " + std::to_string(port) + " is taken: choose another by --port");
    }
  }

  std::string address() const {
    return "http://127.0.0.1:" + std::to_string(port_) + "/?token=" + token_;
  }

  void serve() { server_.listen_after_bind(); }

  void stop() {
    {
      const std::lock_guard<std::mutex> lock(news_mutex_);
      stopped_ = true;
    }
    news_.notify_all();
    server_.stop();
  }

  void change(const std::function<void(MeshSession&)>& how) {
    {
      const std::lock_guard<std::mutex> lock(session_mutex_);
      how(session_);
    }
    {
      const std::lock_guard<std::mutex> lock(news_mutex_);
      ++version_;
    }
    news_.notify_all();
  }

 private:
  static void refuse(httplib::Response& response, const char* why) {
    response.status = 403;
    response.set_content(why, "text/plain");
  }

  /// Another page that the user has open must not talk to this server, also not by a name of
  /// its own that leads to 127.0.0.1.
  bool may_come_in(const httplib::Request& request, httplib::Response& response) const {
    const std::string port = ":" + std::to_string(port_);
    const std::string host = request.get_header_value("Host");
    response.set_header("Cache-Control", "no-store");
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_header("X-Frame-Options", "DENY");
    if (host != "127.0.0.1" + port && host != "localhost" + port) {
      refuse(response, "This server answers to 127.0.0.1 only.\n");
      return false;
    }
    const std::string origin = request.get_header_value("Origin");
    if (!origin.empty() && origin != "http://" + host) {
      refuse(response, "Other pages may not use this server.\n");
      return false;
    }
    std::string token = request.get_header_value("X-Meshgrade-Token");
    if (token.empty()) token = request.get_param_value("token");
    if (!same_token(token, token_)) {
      refuse(response, "Open the address that meshgrade view has printed.\n");
      return false;
    }
    return true;
  }

  void add_routes() {
    server_.Get("/", [this](const httplib::Request&, httplib::Response& response) {
      const Json data{{"kind", "live"}, {"token", token_}, {"start", Json::parse(start_)}};
      response.set_content(fill_page(page_, data, PageAccess::kOwnServer),
                           "text/html; charset=utf-8");
    });
    add_action("/state", [](MeshSession&, const Json&) {});
    add_action("/step", [](MeshSession& session, const Json& request) {
      session.apply(operation_of(session.verbs(), request));
    });
    add_action("/go", [](MeshSession& session, const Json& request) {
      session.go_to(whole_number(request, "position"));
    });
    add_post("/open", [this](const httplib::Request& request) {
      const std::string name = request.get_param_value("name");
      const LoadedMesh loaded = read_sent(name, request.body);
      session_.open(name, loaded.mesh, loaded.notes);
      for (const std::string& note : loaded.notes)
        std::cerr << printable(name) << ": note: " << note << "\n";
      return answer_for_page(session_);
    });
    add_question("/normals", [this](const Json&) {
      return to_json_value(session_.normals(), session_.states()[session_.position()].mesh);
    });
    add_question("/levels", [this](const Json&) { return levels_value(session_); });
    add_bezier("/curve", view_curve);
    add_bezier("/patch", view_patch);
    add_bezier("/isocurves", view_isocurves);
    server_.Get("/events", [this](const httplib::Request&, httplib::Response& response) {
      response.set_chunked_content_provider(
          "text/event-stream",
          [this, seen = version_now()](std::size_t, httplib::DataSink& sink) mutable {
            return send_news(seen, sink);
          });
    });
  }

  /// Changes the session, or not, and answers with what is to be shown now.
  void add_action(const std::string& path,
                  const std::function<void(MeshSession&, const Json&)>& action) {
    add_post(path, [this, action](const httplib::Request& request) {
      action(session_, json_of(request));
      return answer_for_page(session_);
    });
  }

  void add_bezier(const std::string& path, Json (*view)(const StudentProgram&, const Json&)) {
    add_question(
        path, [this, view](const Json& request) { return view(session_.program(), request); });
  }

  void add_question(const std::string& path, const std::function<Json(const Json&)>& question) {
    add_post(path, [question](const httplib::Request& request) {
      return PageAnswer{text_of(question(json_of(request))), "application/json"};
    });
  }

  static Json json_of(const httplib::Request& request) {
    return request.body.empty() ? Json::object() : Json::parse(request.body);
  }

  void add_post(const std::string& path,
                const std::function<PageAnswer(const httplib::Request&)>& handle) {
    server_.Post(path,
                 [this, handle](const httplib::Request& request, httplib::Response& response) {
                   const std::lock_guard<std::mutex> lock(session_mutex_);
                   try {
                     const PageAnswer given = handle(request);
                     response.set_content(given.body, given.type);
                   } catch (const std::exception& error) {
                     fail(response, error);
                   }
                 });
  }

  static void fail(httplib::Response& response, const std::exception& error) {
    const bool unreadable = dynamic_cast<const WireError*>(&error) != nullptr;
    const bool user = dynamic_cast<const UserError*>(&error) != nullptr;
    const bool bad = dynamic_cast<const Json::exception*>(&error) != nullptr ||
                     dynamic_cast<const BadRequest*>(&error) != nullptr;
    response.status = unreadable || user ? 422 : bad ? 400 : 500;
    const std::string what = error.what();
    const Json told{
        {"error", unreadable ? "the program's answer cannot be read: " + what : what}};
    response.set_content(text_of(told), "application/json");
  }

  static std::string text_of(const Json& value) {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
  }

  std::size_t version_now() {
    const std::lock_guard<std::mutex> lock(news_mutex_);
    return version_;
  }

  /// Waits for the next change, or says from time to time that it is still there.
  bool send_news(std::size_t& seen, httplib::DataSink& sink) {
    std::unique_lock<std::mutex> lock(news_mutex_);
    news_.wait_for(lock, kHeartbeat, [&] { return stopped_ || version_ != seen; });
    if (stopped_) return false;
    const std::string line = version_ != seen ? "data: changed\n\n" : ": still here\n\n";
    seen = version_;
    lock.unlock();
    return sink.write(line.data(), line.size());
  }

  MeshSession& session_;
  std::string page_;
  std::string start_;
  std::string token_;
  int port_ = 0;
  httplib::Server server_;
  std::mutex session_mutex_;
  std::mutex news_mutex_;
  std::condition_variable news_;
  std::size_t version_ = 0;
  bool stopped_ = false;
};

ViewServer::ViewServer(MeshSession& session, std::string page, std::string start)
    : impl_(std::make_unique<Impl>(session, std::move(page), std::move(start))) {}
ViewServer::~ViewServer() = default;

void ViewServer::bind(int port) {
  impl_->bind(port);
}
std::string ViewServer::address() const {
  return impl_->address();
}
void ViewServer::serve() {
  impl_->serve();
}
void ViewServer::stop() {
  impl_->stop();
}
void ViewServer::change(const std::function<void(MeshSession&)>& how) {
  impl_->change(how);
}

}  // namespace meshgrade
