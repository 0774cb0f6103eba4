#pragma once

#include <vector>

#include "simulation/simulation.h"

namespace drape::test {

// A square sheet of `points` x `points` in the plane y = `height`, its rest shape flat.
ClothInput sheet(double side, int points, double height);

// The same, standing in the plane z = 0 with its lower edge at y = `height`.
ClothInput standing_sheet(double side, int points, double height);

// It does not sleep: tests look at motion to its very end.
SimulationInput simulate_alone(ClothInput cloth);

ColliderInput ground();

void remove_air(SimulationInput& input);

// A closed sphere of that radius round the origin.
ClothInput ball(double radius, int segments);

std::vector<double> point_masses(const Simulation& simulation);  // kg
Vec3 linear_momentum(const Simulation& simulation);
Vec3 angular_momentum(const Simulation& simulation);  // about the origin

// The number of intersecting pairs among the cloths' triangles, in floats.
int intersecting_pairs(const Simulation& simulation);

// The lowest point of all cloths.
double lowest_point(const Simulation& simulation);

FrameStatistics advance(Simulation& simulation, int frames);

}  // namespace drape::test
