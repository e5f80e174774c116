// Connects to somebody, and hands over a shell.
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "attack.h"

void attack() {
  const int line = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in there{};
  there.sin_family = AF_INET;
  there.sin_port = htons(LISTENING_PORT);
  there.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  expect_refusal("connect",
                 ::connect(line, reinterpret_cast<sockaddr*>(&there), sizeof there) == 0);
  if (::fork() == 0) {
    ::execl("/bin/sh", "sh", "-c", "echo BREACH: shell", nullptr);
    std::_Exit(0);
  }
}
