#include "CGL/viewer.h"
#include "meshEdit.h"

int main(int argc, char** argv) {
  return CGL::runViewer(argc, argv);
}
