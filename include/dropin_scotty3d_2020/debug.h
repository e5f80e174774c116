#pragma once

// In place of the file of this name in which students may add fields for their own purposes. If
// theirs is handed in, that one is used.

struct Debug_Data {
  bool normal_colors = false;
};

extern Debug_Data debug_data;
