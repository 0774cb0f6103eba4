#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/frame_certificate.h"

namespace drape::app {

// What there is to say of many frames.
struct CertificateSummary {
  int frames = 0;
  int failed = 0;             // of these, not certified
  std::string worst;          // the name of the worst that failed; empty where none did
  FrameCertificate extremes;  // each figure at its worst; the name is not used
};

CertificateSummary summarize(const std::vector<FrameCertificate>& frames);

// The index of the worst frame that is not certified; -1 where all are. Values that are not finite are worst,
// then the number of triangles that meet one another or a collider, then the depth.
int worst_frame(const std::vector<FrameCertificate>& frames);

// One line a frame, under a line that says what stands where: in mm, and stretch as a share of the rest
// length. As short as the frames allow: with columns for what is drawn where that is certified too.
std::string certificate_table(const std::vector<FrameCertificate>& frames);

// "certified: 90 frames", or how many are not, and which is the worst.
std::string verdict(const CertificateSummary& summary);

}  // namespace drape::app
