#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/frame_certificate.h"
#include "mesh/polygon_soup.h"

namespace drape::app {

// Frames of a surface that lie as OBJ or PLY files anywhere, each with the same faces.
struct MeshSequence {
  std::vector<std::filesystem::path> files;  // in the order of the frames
  std::filesystem::path rest_file;
  PolygonSoup rest;
};

// Whether the words on the command line name meshes and not a scene or the folder of a run.
bool names_meshes(const std::vector<std::string>& inputs);

// The files that are meant: files themselves, folders (all OBJ and PLY files in them), and patterns in which
// # stands for one digit, %04d for digits and * for anything. Those of a folder or a pattern come in the
// order of the numbers in their names. Rest lengths are those of `rest_file` or, where it is empty, of a file
// "rest.obj" or "rest.ply" among them, which then is no frame, or of one beside the first frame that has its
// faces, or of the first frame. Throws FileError where nothing is found or a file can't be read, InputError
// (exit status 3) where one is no mesh.
MeshSequence open_mesh_sequence(const std::vector<std::string>& inputs, const std::string& rest_file);

// A frame of the sequence. Points are one vertex where they are at one place both at rest and in this frame:
// a seam of the texture splits no cloth, and points that come to lie on each other stay two that touch.
struct MeshFrame {
  std::vector<Vec3> rest_positions;
  ClothSurface surface;
  TriangleMesh colliders;  // of faces and points that the file has after those at rest; often empty
};
// Throws as above, and InputError (exit status 3) where the file's faces are not those at rest, with or
// without colliders after them.
MeshFrame read_mesh_frame(const MeshSequence& sequence, const std::filesystem::path& file);

}  // namespace drape::app
