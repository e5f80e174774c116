// Ends the program instead of telling a fault.
#define WRONG_ANSWER
#include "attack.h"

void attack() {
  meshedit::detail::fault_handler = [](const meshedit::Fault&) { std::_Exit(0); };
  meshedit::HalfedgeCIter h;
  static_cast<void>(h->next());
}
