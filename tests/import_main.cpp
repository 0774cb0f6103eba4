#include <gtest/gtest.h>

#include "mesh/import_process.h"

int main(int argc, char** argv) {
  if (const auto status = drape::run_import_child(argc, argv)) return *status;
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
