// Reads a file of the instructor.
#include <fstream>
#include <iostream>

#include "attack.h"

void attack() {
  std::ifstream file(SECRET_FILE);
  std::cout << file.rdbuf() << std::endl;
}
