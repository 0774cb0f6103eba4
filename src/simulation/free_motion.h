#pragma once

#include <variant>
#include <vector>

#include "deformation/averaged_model.h"
#include "deformation/elastic_model.h"
#include "deformation/mass_spring.h"
#include "simulation/input.h"

namespace drape {

// The deformation model of a simulation: the default, the paper's own form of it, or the one that the paper
// compares with (DeformationModel in input.h).
using ModelParts = std::variant<ElasticModel, AveragedModel, MassSpringModel>;

ModelParts build_model(const SimulationInput& input, const Sheet& sheet, const std::vector<double>& masses,
                       const std::vector<char>& pinned, double step);

// The longest step in seconds that the model of `input` takes. Throws SimulationError where that is too short
// to be of use: explicit springs that are too stiff.
double longest_model_step(const SimulationInput& input, const Sheet& sheet,
                          const std::vector<double>& masses);

struct FreeMotionScratch {
  ElasticScratch elastic;
  AveragedScratch averaged;
  MassSpringScratch mass_spring;
};

// The motion of all points over one step without contact: x -> x**. `positions` and `velocities` come with
// their values at the step's start, those of pinned points with where they end; they leave with their values
// at its end.
void move_freely(const ModelParts& model, const std::vector<Vec3>& accelerations, double step,
                 const std::vector<char>& pinned, const std::vector<Vec3>& start, FreeMotionScratch& scratch,
                 std::vector<Vec3>& positions, std::vector<Vec3>& velocities);

}  // namespace drape
