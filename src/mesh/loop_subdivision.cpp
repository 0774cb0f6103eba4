#include "mesh/loop_subdivision.h"

#include <opensubdiv/far/stencilTable.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>
#include <opensubdiv/sdc/crease.h>

#include <cassert>
#include <stdexcept>

#include "core/parallel.h"
#include "mesh/topology.h"

namespace drape {
namespace {
namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

using Refiner = std::unique_ptr<Far::TopologyRefiner>;
using StencilTable = Far::StencilTableReal<float>;
using StencilFactory = Far::StencilTableFactoryReal<float>;
using Stencils = std::unique_ptr<const StencilTable>;

constexpr std::size_t stencils_in_a_block = 4096;
constexpr int uv_channel = 0;

// Corners of a sheet stay sharp; texture coordinates are not smoothed, so that a texture's seams stay where
// they are.
Sdc::Options rules() {
  Sdc::Options options;
  options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
  options.SetFVarLinearInterpolation(Sdc::Options::FVAR_LINEAR_ALL);
  return options;
}

// The points where the boundary turns by more than 70 degrees. OpenSubdiv's own rule takes a corner of one
// triangle only for a corner, and would round the two corners of a grid whose diagonal splits them.
std::vector<int> sharp_corners(const TriangleMesh& mesh) {
  std::vector<Vec3> boundary_directions(mesh.positions.size(), Vec3::Zero());  // sum of unit vectors
  for (const Edge& edge : build_topology(static_cast<int>(mesh.positions.size()), mesh.triangles).edges) {
    if (edge.triangles[1] >= 0) continue;
    const Vec3 direction = (mesh.positions[edge.vertices[1]] - mesh.positions[edge.vertices[0]]).normalized();
    boundary_directions[edge.vertices[0]] += direction;
    boundary_directions[edge.vertices[1]] -= direction;
  }
  constexpr double square_at_70_degrees =
      1.316;  // two unit vectors: 2 - 2 cos 70, and 0 where it goes straight on
  std::vector<int> corners;
  for (int v = 0; v < static_cast<int>(boundary_directions.size()); ++v)
    if (boundary_directions[v].squaredNorm() > square_at_70_degrees) corners.push_back(v);
  return corners;
}

Refiner refine(const TriangleMesh& mesh, int levels) {
  const std::vector<int> corner_counts(mesh.triangles.size(), 3);
  const std::vector<int> corners = sharp_corners(mesh);
  const std::vector<float> sharpness(corners.size(), Sdc::Crease::SHARPNESS_INFINITE);
  Far::TopologyDescriptor::FVarChannel uvs;
  uvs.numValues = static_cast<int>(mesh.uvs.size());
  uvs.valueIndices = mesh.uv_triangles.empty() ? nullptr : mesh.uv_triangles.front().data();

  Far::TopologyDescriptor descriptor;
  descriptor.numVertices = static_cast<int>(mesh.positions.size());
  descriptor.numFaces = static_cast<int>(mesh.triangles.size());
  descriptor.numVertsPerFace = corner_counts.data();
  descriptor.vertIndicesPerFace = mesh.triangles.front().data();
  descriptor.numCorners = static_cast<int>(corners.size());
  descriptor.cornerVertexIndices = corners.data();
  descriptor.cornerWeights = sharpness.data();
  descriptor.numFVarChannels = mesh.uv_triangles.empty() ? 0 : 1;
  descriptor.fvarChannels = &uvs;

  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  Refiner refiner(Factory::Create(descriptor, Factory::Options(Sdc::SCHEME_LOOP, rules())));
  if (!refiner) throw std::invalid_argument("a mesh that is not fit for subdivision");
  Far::TopologyRefiner::UniformOptions options(levels);
  options.fullTopologyInLastLevel = true;
  refiner->RefineUniform(options);
  return refiner;
}

Stencils stencils_of(const Far::TopologyRefiner& refiner, unsigned interpolation) {
  StencilFactory::Options options;
  options.interpolationMode = interpolation & 3u;
  options.generateOffsets = true;
  options.generateIntermediateLevels = false;
  options.fvarChannel = uv_channel;
  return Stencils(StencilFactory::Create(refiner, options));
}

template <typename Vector>
std::vector<Vector> apply_stencils(const StencilTable& stencils, const std::vector<Vector>& coarse) {
  std::vector<Vector> fine(static_cast<std::size_t>(stencils.GetNumStencils()), Vector(Vector::Zero()));
  parallel_for_each(fine.size(), stencils_in_a_block, [&](std::size_t i) {
    const int begin = stencils.GetOffsets()[i];
    for (int k = begin; k < begin + stencils.GetSizes()[i]; ++k)
      fine[i] += stencils.GetWeights()[k] * coarse[stencils.GetControlIndices()[k]];
  });
  return fine;
}

Triangle to_triangle(const Far::ConstIndexArray& corners) { return {corners[0], corners[1], corners[2]}; }

}  // namespace

struct LoopSubdivision::Tables {
  std::vector<Triangle> triangles;
  std::vector<Vec2f> uvs;
  std::vector<Triangle> uv_triangles;
  Stencils stencils, flat_stencils;  // none at level 0
};

LoopSubdivision::LoopSubdivision(const TriangleMesh& mesh, int levels) : tables_(std::make_unique<Tables>()) {
  assert(levels >= 0 && levels <= 4);
  for (const Vec2& uv : mesh.uvs) tables_->uvs.push_back(uv.cast<float>());
  if (levels == 0 || mesh.triangles.empty()) {
    tables_->triangles = mesh.triangles;
    tables_->uv_triangles = mesh.uv_triangles;
    return;
  }
  const Refiner refiner = refine(mesh, levels);
  const Far::TopologyLevel& finest = refiner->GetLevel(levels);
  const bool has_uvs = !mesh.uv_triangles.empty();
  for (int face = 0; face < finest.GetNumFaces(); ++face) {
    tables_->triangles.push_back(to_triangle(finest.GetFaceVertices(face)));
    if (has_uvs) tables_->uv_triangles.push_back(to_triangle(finest.GetFaceFVarValues(face, uv_channel)));
  }
  tables_->stencils = stencils_of(*refiner, StencilFactory::INTERPOLATE_VERTEX);
  tables_->flat_stencils = stencils_of(*refiner, StencilFactory::INTERPOLATE_VARYING);
  if (!has_uvs) return;
  const Stencils uv_stencils = stencils_of(*refiner, StencilFactory::INTERPOLATE_FACE_VARYING);
  tables_->uvs = apply_stencils(*uv_stencils, tables_->uvs);
}

LoopSubdivision::~LoopSubdivision() = default;
LoopSubdivision::LoopSubdivision(LoopSubdivision&&) noexcept = default;

const std::vector<Triangle>& LoopSubdivision::triangles() const { return tables_->triangles; }
const std::vector<Vec2f>& LoopSubdivision::uvs() const { return tables_->uvs; }
const std::vector<Triangle>& LoopSubdivision::uv_triangles() const { return tables_->uv_triangles; }

std::vector<Vec3f> LoopSubdivision::apply(const std::vector<Vec3f>& positions) const {
  return tables_->stencils ? apply_stencils(*tables_->stencils, positions) : positions;
}
std::vector<Vec3f> LoopSubdivision::apply_flat(const std::vector<Vec3f>& positions) const {
  return tables_->flat_stencils ? apply_stencils(*tables_->flat_stencils, positions) : positions;
}

}  // namespace drape
