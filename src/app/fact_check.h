#pragma once

#include <string>
#include <vector>

#include "app/fact_result.h"
#include "app/frame_certificate.h"
#include "app/run.h"

namespace drape::app {

// Holds the frames `numbers`, with their certificates in the same order, to what the scene says of them.
// Throws FileError where the cache lacks a frame.
std::vector<FactResult> check_facts(const Run& run, const std::vector<int>& numbers,
                                    const std::vector<FrameCertificate>& certificates);

// A line for each; empty where the scene says nothing.
std::string fact_table(const std::vector<FactResult>& results);

}  // namespace drape::app
