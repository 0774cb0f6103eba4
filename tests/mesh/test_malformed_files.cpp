#include <gtest/gtest.h>

#include "core/error.h"
#include "mesh/mesh_bytes.h"
#include "mesh/obj_reader.h"
#include "mesh/ply_reader.h"

namespace drape {
namespace {

struct Malformed {
  const char* name;
  std::string content;
  std::string words;  // of the refusal
};

std::string refusal(PolygonSoup (*read)(std::string_view, const std::filesystem::path&), const char* path,
                    const std::string& content) {
  try {
    read(content, path);
    return "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.exit_status(), 3);
    return error.what();
  }
}

class MalformedObj : public testing::TestWithParam<Malformed> {};
class MalformedPly : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedObj, IsRefusedInWords) {
  EXPECT_EQ(refusal(read_obj, "a.obj", GetParam().content), GetParam().words);
}
TEST_P(MalformedPly, IsRefusedInWords) {
  EXPECT_EQ(refusal(read_ply, "a.ply", GetParam().content), GetParam().words);
}

const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

const Malformed malformed_obj[] = {
    {"Empty", "", "a.obj: error: there are no faces (lines 'f P P P') in this file"},
    {"OnlyPoints", points, "a.obj: error: there are no faces (lines 'f P P P') in this file"},
    {"UnknownStatement", points + "f 1 2 3\n  cstype bezier\n",
     "a.obj:5:3: error: 'cstype' is not a statement of a polygon mesh (v, vt, vn, f, ...)"},
    {"Binary", std::string("\x00\x01\xff\x1b[2J\n", 8),
     "a.obj:1:1: error: '\?\?\?\?[2J' is not a statement of a polygon mesh (v, vt, vn, f, ...)"},
    {"TwoCoordinates", "v 1 2\n", "a.obj:1:1: error: a point needs three coordinates: v X Y Z"},
    {"NotANumber", "v 1 2 three\n", "a.obj:1:7: error: 'three' is not a number"},
    {"HalfANumber", "v 1 2 3,5\n", "a.obj:1:7: error: '3,5' is not a number"},
    {"Nan", "v 1 nan 3\n", "a.obj:1:5: error: 'nan' is not a usable coordinate; it must be within +-1e+09"},
    {"Infinite", "v 1 -inf 3\n",
     "a.obj:1:5: error: '-inf' is not a usable coordinate; it must be within +-1e+09"},
    {"TooLarge", "v 1 1e10 3\n",
     "a.obj:1:5: error: '1e10' is not a usable coordinate; it must be within +-1e+09"},
    {"OutOfRange", "v 1 1e999 3\n", "a.obj:1:5: error: '1e999' is not a number"},
    {"UvWithoutNumbers", "vt\n", "a.obj:1:1: error: a texture coordinate needs numbers: vt U V"},
    {"TwoCorners", points + "f 1 2\n", "a.obj:4:1: error: face 1 has 2 corners; it needs at least 3"},
    {"NoCorners", points + "f 1 2 3\nf # none\n",
     "a.obj:5:1: error: face 2 has 0 corners; it needs at least 3"},
    {"IndexZero", points + "f 1 0 3\n",
     "a.obj:4:5: error: a corner has the number 0, but OBJ files count from 1"},
    {"IndexTooLarge", points + "f 1 2 3\nf 1 2 900\n",
     "a.obj:5:1: error: face 2 names point 900, but the file has 3"},
    {"IndexHuge", points + "f 1 2 99999999999\n",
     "a.obj:4:1: error: face 1 names point 2147483648, but the file has 3"},
    {"IndexBeyondIntegers", points + "f 1 2 99999999999999999999\n",
     "a.obj:4:7: error: '99999999999999999999' is not a corner of a face: use P, P/T or P/T/N"},
    {"IndexTooNegative", points + "f -1 -2 -4\n",
     "a.obj:4:9: error: -4 counts back further than there are lines before it: 3"},
    {"IndexMostNegative", points + "f 1 2 -9223372036854775808\n",
     "a.obj:4:7: error: -9223372036854775808 counts back further than there are lines before it: 3"},
    {"IndexFraction", points + "f 1 2 2.5\n",
     "a.obj:4:7: error: '2.5' is not a corner of a face: use P, P/T or P/T/N"},
    {"IndexMissing", points + "f 1 2 /1\n",
     "a.obj:4:7: error: '/1' is not a corner of a face: use P, P/T or P/T/N"},
    {"UvIndexTooLarge", points + "vt 0 0\nf 1/1 2/1 3/2\n",
     "a.obj:5:1: error: face 1 names texture coordinate 2, but the file has 1"},
    {"DosLines", points + "f 1 2 3\r\n\r\nf 1 2\r\n",
     "a.obj:6:1: error: face 2 has 2 corners; it needs at least 3"},
};

std::string header(const std::string& vertices, const std::string& faces,
                   const std::string& format = "ascii") {
  return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}
const std::string rows = "0 0 0\n1 0 0\n0 1 0\n";

std::string replaced(std::string text, const std::string& old, const std::string& now) {
  return text.replace(text.find(old), old.size(), now);
}

const Malformed malformed_ply[] = {
    {"Empty", "", "a.ply:1:1: error: a PLY file starts with a line 'ply'"},
    {"NoMagic", "solid\n", "a.ply:1:1: error: a PLY file starts with a line 'ply'"},
    {"OnlyMagic", "ply",
     "a.ply: error: the file ends before its header does; a line 'end_header' is missing"},
    {"NoEnd", replaced(header("3", "1"), "end_header\n", ""),
     "a.ply: error: the file ends before its header does; a line 'end_header' is missing"},
    {"NoFormat", replaced(header("3", "1"), "format ascii 1.0\n", ""),
     "a.ply:8:1: error: the header has no line 'format ...'"},
    {"OtherFormat", header("3", "1", "middle_endian"),
     "a.ply:2:8: error: 'middle_endian' is not a format of PLY: format "
     "ascii|binary_little_endian|binary_big_endian 1.0"},
    {"OtherVersion", replaced(header("3", "1"), "1.0", "2.0"),
     "a.ply:2:14: error: '2.0' is not 1.0, the version of PLY"},
    {"UnknownStatement", replaced(header("3", "1"), "format", "fromat"),
     "a.ply:2:1: error: 'fromat' is not a statement of a PLY header (format, element, property, end_header)"},
    {"ShortLine", replaced(header("3", "1"), "element vertex 3", "element vertex"),
     "a.ply:3:1: error: the line is too short: element NAME COUNT"},
    {"NegativeCount", header("-3", "1"), "a.ply:3:16: error: '-3' is not a count"},
    {"CountBeyondIntegers", header("99999999999999999999", "1"),
     "a.ply:3:16: error: '99999999999999999999' is not a count"},
    {"UnknownType", replaced(header("3", "1"), "float x", "half x"),
     "a.ply:4:10: error: 'half' is not a type of PLY (float, int, uchar, ...)"},
    {"FractionalListCount", replaced(header("3", "1"), "list uchar", "list float"),
     "a.ply:8:15: error: the count of a list must be of an integer type"},
    {"PropertyFirst", "ply\nformat ascii 1.0\nproperty float x\n",
     "a.ply:3:1: error: a property before the first element"},
    {"ElementTwice", replaced(header("3", "1"), "element face", "element vertex"),
     "a.ply:7:9: error: element 'vertex' is declared twice"},
    {"NoFaces", replaced(header("3", "1"), "element face", "element cell"),
     "a.ply: error: the file has no elements 'face', which a surface needs"},
    {"NoVertices", header("0", "1"),
     "a.ply: error: the file has no elements 'vertex', which a surface needs"},
    {"NoZ", replaced(header("3", "1"), "float z", "float w"),
     "a.ply: error: the points have no property 'z'"},
    {"NoCornerList", replaced(header("3", "1"), "vertex_indices", "tristrip"),
     "a.ply: error: the faces have no list 'vertex_indices'"},
    {"ABillionPoints", header("1000000000", "1") + rows,
     "a.ply: error: the file has 1000000000 points; the most is 5000000"},
    {"AMillionPoints", header("1000000", "1") + rows,
     "a.ply: error: the header promises 1000000 rows of 'vertex', but the file is too short for them"},
    {"ABillionFaces", header("3", "1000000000", "binary_little_endian") + std::string(36, '\0') + "\x03",
     "a.ply: error: the header promises 1000000000 rows of 'face', but the file is too short for them"},
    {"NotANumber", header("3", "1") + "0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n",
     "a.ply:11:3: error: vertex 1 has a value that is not a number: 'zero'"},
    {"Nan", header("3", "1") + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n",
     "a.ply:11:3: error: vertex 1 has the coordinate nan; it must be within +-1e+09"},
    {"BinaryNan", header("3", "1", "binary_little_endian") + std::string(36, '\xff') + std::string(13, '\3'),
     "a.ply: error: vertex 0 has the coordinate -nan; it must be within +-1e+09"},
    {"TwoCorners", header("3", "1") + rows + "2 0 1   \n",
     "a.ply:13:1: error: face 0 has 2 corners; it needs at least 3"},
    {"NegativeCorners", header("3", "1") + rows + "-3 0 1\n",
     "a.ply:13:1: error: face 0 has a list 'vertex_indices' of -3 values"},
    {"HugeList", header("3", "1") + rows + "4000000000 0 1 2\n",
     "a.ply:13:1: error: face 0 has a list 'vertex_indices' of 4e+09 values, more than are left in the file"},
    {"BinaryHugeList", header("3", "1", "binary_little_endian") + std::string(36, '\0') + "\xff" + "abc",
     "a.ply: error: face 0 has a list 'vertex_indices' of 255 values, more than are left in the file"},
    {"IndexTooLarge", header("3", "1") + rows + "3 0 1 3\n",
     "a.ply:13:7: error: face 0 names point 3, but they are numbered 0 to 2"},
    {"IndexNegative", header("3", "1") + rows + "3 0 -1 2\n",
     "a.ply:13:5: error: face 0 names point -1, but they are numbered 0 to 2"},
    {"IndexFraction", header("3", "1") + rows + "3 0 0.5 2\n",
     "a.ply:13:5: error: face 0 names point 0.5, but they are numbered 0 to 2"},
    {"LastRowMissing", header("3", "2") + rows + "3 0 1 2\n",
     "a.ply:13:7: error: face 1 is not whole: the file ends in it"},
    {"BinaryTruncated", test::square_binary_ply(false).substr(0, test::square_binary_ply(false).size() - 33),
     "a.ply: error: face 0 is not whole: the file ends in it"},
    {"BinaryTruncatedByAByte",
     test::square_binary_ply(true).substr(0, test::square_binary_ply(true).size() - 1),
     "a.ply: error: face 0 has a list 'texcoord' of 8 values, more than are left in the file"},
    {"TooFewTexcoords",
     replaced(header("3", "1"), "end_header", "property list uchar float texcoord\nend_header") + rows +
         "3 0 1 2 4 0 0 0 0\n",
     "a.ply:14:17: error: face 0 has 4 values of texcoord for 3 corners; it needs two for each"},
};

const auto case_name = [](const testing::TestParamInfo<Malformed>& info) {
  return std::string(info.param.name);
};
INSTANTIATE_TEST_SUITE_P(Files, MalformedObj, testing::ValuesIn(malformed_obj), case_name);
INSTANTIATE_TEST_SUITE_P(Files, MalformedPly, testing::ValuesIn(malformed_ply), case_name);

}  // namespace
}  // namespace drape
