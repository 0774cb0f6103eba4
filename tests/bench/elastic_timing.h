#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "deformation/averaged_model.h"
#include "deformation/elastic_model.h"
#include "deformation/mass_spring.h"
#include "hanging_sheet.h"

namespace drape::bench {

// The parts of a step of the default model, in the order of advance_elastic.
inline constexpr std::array<std::string_view, 8> stage_names = {
    "loading", "damping", "prediction", "bending", "tethers", "fibres", "membrane", "velocities"};
enum Stage : std::size_t { loading, damping, prediction, bending, tethers, fibres, membrane, velocities };

// Least times of one step seen so far, in seconds.
struct Least {
  double cpu = 1e9;   // of this thread
  double wall = 1e9;  // of all threads
  std::array<double, stage_names.size()> stages{1e9, 1e9, 1e9, 1e9, 1e9, 1e9, 1e9, 1e9};
};

// A swinging sheet of one of the models. run() advances it for some time, and keeps the least time of a step;
// the state stays in the caches from one step to the next, as it does in a simulation without contact.
class ElasticRun {
 public:
  explicit ElasticRun(const HangingSheet& hanging) : hanging_(hanging), x_(with_corners_pulled(hanging)) {
    v_.assign(x_.size(), Vec3::Zero());
  }
  virtual ~ElasticRun() = default;
  ElasticRun(const ElasticRun&) = delete;
  ElasticRun& operator=(const ElasticRun&) = delete;

  void run(double seconds);
  const Least& least() const { return least_; }

  virtual std::string_view name() const = 0;
  virtual std::size_t clusters() const = 0;
  virtual std::size_t model_bytes() const = 0;
  virtual std::size_t scratch_bytes() const = 0;

 protected:
  virtual void advance() = 0;
  virtual void time_stages(Least&) {}

  const HangingSheet& hanging_;
  std::vector<Vec3> x_, v_;

 private:
  Least least_;
};

class ShapeMatchingRun : public ElasticRun {
 public:
  explicit ShapeMatchingRun(const HangingSheet& hanging);
  std::string_view name() const override { return "shape_matching"; }
  std::size_t clusters() const override { return 2 * hanging_.sheet.triangles.size(); }
  std::size_t model_bytes() const override;
  std::size_t scratch_bytes() const override;

 private:
  void advance() override;
  void time_stages(Least& least) override;

  ElasticModel model_;
  ElasticScratch scratch_;
  std::vector<Vec3> start_;
};

class MassSpringRun : public ElasticRun {
 public:
  explicit MassSpringRun(const HangingSheet& hanging);
  std::string_view name() const override { return "mass_spring"; }
  std::size_t clusters() const override { return model_.springs.size() + model_.bending.size(); }
  std::size_t model_bytes() const override;
  std::size_t scratch_bytes() const override;

 private:
  void advance() override;

  MassSpringModel model_;
  MassSpringScratch scratch_;
};

class AveragedRun : public ElasticRun {
 public:
  explicit AveragedRun(const HangingSheet& hanging);
  std::string_view name() const override { return "averaged"; }
  std::size_t clusters() const override { return model_.rest.size() + model_.fibre_begin.size() - 1; }
  std::size_t model_bytes() const override;
  std::size_t scratch_bytes() const override;

 private:
  void advance() override;

  AveragedModel model_;
  AveragedScratch scratch_;
  std::vector<Vec3> start_;
};

}  // namespace drape::bench
