#pragma once

#include <functional>
#include <memory>
#include <string>

#include "grader/view/mesh_session.h"

namespace meshgrade {

/// Serves a session to browsers on this machine, and to nobody else: it listens on 127.0.0.1,
/// refuses requests that name another host or come from another page, and wants a token that
/// only who has started it knows.
class ViewServer {
 public:
  /// @param page   the viewer's page, without data
  /// @param start  what the page begins with, as JSON: null for the mesh of the session, or a
  ///               Bezier `curve` or `patch`
  ViewServer(MeshSession& session, std::string page, std::string start);
  ~ViewServer();
  ViewServer(const ViewServer&) = delete;
  ViewServer& operator=(const ViewServer&) = delete;

  /// Takes a port; 0: any that is free.
  /// @throws UserError if it is taken
  void bind(int port);

  /// What to open in the browser.
  std::string address() const;

  /// Answers until stop() is called.
  void serve();
  void stop();

  /// Changes the session while no request does, and then tells all pages to look again.
  void change(const std::function<void(MeshSession&)>& how);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace meshgrade
