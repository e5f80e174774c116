#pragma once

// Homework includes it for nothing that is graded: it is empty.
