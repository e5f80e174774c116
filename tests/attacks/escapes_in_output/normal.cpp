// Prints what terminals, HTML, XML and spreadsheets take for commands.
#define WRONG_ANSWER
#include "attack.h"

void attack() {
  std::printf(
      "\033[2J\033]0;title\007\033]52;c;ZXZpbA==\007\x9b"
      "31m\b\b\r");
  std::printf(
      "\xe2\x80\xae"
      "evil\xe2\x81\xa6\xc2\x85\xff\xfe\n");
  std::printf("<script>alert(1)</script><!-- ]]> &amp; \"' =cmd|'/C calc'!A0\n");
  std::printf("\xed\xa0\x80 \xf4\x90\x80\x80 \xc0\xaf %c end\n", 0);
}
