// Opens sockets of every kind.
#include <sys/socket.h>

#include "attack.h"

void attack() {
  expect_refusal("tcp", ::socket(AF_INET, SOCK_STREAM, 0) >= 0);
  expect_refusal("udp", ::socket(AF_INET, SOCK_DGRAM, 0) >= 0);
  expect_refusal("tcp6", ::socket(AF_INET6, SOCK_STREAM, 0) >= 0);
  expect_refusal("unix", ::socket(AF_UNIX, SOCK_STREAM, 0) >= 0);
  expect_refusal("netlink", ::socket(AF_NETLINK, SOCK_RAW, 0) >= 0);
  expect_refusal("packet", ::socket(AF_PACKET, SOCK_RAW, 0) >= 0);
  int pair[2];
  expect_refusal("pair", ::socketpair(AF_UNIX, SOCK_STREAM, 0, pair) == 0);
}
