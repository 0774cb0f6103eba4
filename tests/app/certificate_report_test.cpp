#include "app/certificate_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace drape::app {
namespace {

const double infinity = std::numeric_limits<double>::infinity();

FrameCertificate frame(const std::string& name, const SurfaceFigures& figures) {
  return {name, true, 0.99, 1.02, figures, std::nullopt};
}

TEST(CertificateReport, HasALineForEachFrame) {
  EXPECT_EQ(certificate_table({frame("1", {0, 0.005, 0, 0}), frame("12", {3, 0, 2, 0.0123})}),
            "frame             stretch          pairs    gap/mm  in colliders\n"
            "1      certified  0.9900  1.0200       0         5  0\n"
            "12     BAD        0.9900  1.0200       3         0  2 (12.3 mm deep)\n");
}

TEST(CertificateReport, SumsUpEachFigureAtItsWorst) {
  FrameCertificate first = frame("1", {0, 0.5, 4, 0.1}), second = frame("2", {2, 0.25, 0, 0});
  first.drawn = SurfaceFigures{1, 0.5, 0, 0};
  second.drawn = SurfaceFigures{0, 0.125, 3, 0.5};
  second.largest_stretch = 1.5;
  const CertificateSummary summary = summarize({first, second, frame("3", {0, infinity, 0, 0})});
  EXPECT_EQ(summary.frames, 3);
  EXPECT_EQ(summary.failed, 2);
  EXPECT_EQ(summary.extremes.simulated.intersecting_pairs, 2);
  EXPECT_EQ(summary.extremes.simulated.smallest_gap, 0.25);
  EXPECT_EQ(summary.extremes.simulated.collider_triangles, 4);
  EXPECT_EQ(summary.extremes.simulated.collider_depth, 0.1);
  EXPECT_EQ(summary.extremes.drawn->smallest_gap, 0.125);
  EXPECT_EQ(summary.extremes.drawn->collider_depth, 0.5);
  EXPECT_EQ(summary.extremes.largest_stretch, 1.5);
}

TEST(CertificateReport, WhatIsNotFiniteIsWorst) {
  FrameCertificate broken = frame("2", {0, 1, 0, 0});
  broken.is_finite = false;
  broken.largest_stretch = std::nan("");
  const std::vector<FrameCertificate> frames = {frame("1", {9, 0, 0, 0}), broken, frame("3", {0, 1, 0, 0})};
  EXPECT_EQ(worst_frame(frames), 1);
  EXPECT_FALSE(summarize(frames).extremes.is_finite);
  EXPECT_TRUE(std::isnan(summarize(frames).extremes.largest_stretch));
  EXPECT_EQ(verdict(summarize(frames)), "not certified: 2 of 3 frames, the worst is 2");
}

TEST(CertificateReport, NoFrameIsWorstWhereAllAreCertified) {
  EXPECT_EQ(worst_frame({frame("1", {0, 1, 0, 0})}), -1);
  EXPECT_EQ(verdict(summarize({frame("1", {0, 1, 0, 0})})), "certified: 1 frame");
}

// A surface that is drawn fails a frame as one that is simulated does.
TEST(CertificateReport, AFrameIsCertifiedWhereBothSurfacesAre) {
  FrameCertificate certificate = frame("1", {0, 1, 0, 0});
  EXPECT_TRUE(is_certified(certificate));
  certificate.drawn = SurfaceFigures{0, 1, 1, 0};
  EXPECT_FALSE(is_certified(certificate));
  certificate.drawn = SurfaceFigures{1, 0, 0, 0};
  EXPECT_FALSE(is_certified(certificate));
}

}  // namespace
}  // namespace drape::app
