// Makes objects that outlive all processes.
#include <fcntl.h>
#include <sys/ipc.h>
#include <sys/msg.h>
#include <sys/sem.h>
#include <sys/shm.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "attack.h"

void attack() {
  expect_refusal("shmget", ::shmget(IPC_PRIVATE, 4096, IPC_CREAT | 0600) >= 0);
  expect_refusal("semget", ::semget(IPC_PRIVATE, 1, IPC_CREAT | 0600) >= 0);
  expect_refusal("msgget", ::msgget(IPC_PRIVATE, IPC_CREAT | 0600) >= 0);
  expect_refusal("mq_open",
                 ::syscall(SYS_mq_open, LEFT_BEHIND, O_CREAT | O_RDWR, 0600, nullptr) >= 0);
}
