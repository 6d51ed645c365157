#include "sim/exchange/ply_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "sim/exchange/mesh_file.h"
#include "tests/sim/exchange/file_bytes.h"
#include "tests/sim/exchange/two_panels.h"
#include "tests/support/bodies.h"

namespace selvedge::sim {
namespace {

struct Ply {
    std::vector<std::string> header;  // its lines, without end_header
    std::string data;
};

Ply open_ply(const std::string& bytes) {
    const std::string end = "end_header\n";
    const std::size_t data = bytes.find(end) + end.size();
    Ply ply{{}, bytes.substr(data)};
    std::istringstream text(bytes.substr(0, data - end.size()));
    for (std::string line; std::getline(text, line);) ply.header.push_back(line);
    return ply;
}

TEST(PlyFile, names_its_properties_and_panels_in_the_header) {
    DrawMesh mesh = two_panels();
    mesh.panel_names[1] = "left\nsleeve";
    EXPECT_EQ(open_ply(garment_ply(mesh)).header,
              (std::vector<std::string>{
                  "ply",
                  "format binary_little_endian 1.0",
                  "comment Selvedge garment: metres, y up; s t in the unit square, material_u material_v in metres",
                  "comment panel 0 front",
                  "comment panel 1 left_sleeve",
                  "element vertex 8",
                  "property float x",
                  "property float y",
                  "property float z",
                  "property float nx",
                  "property float ny",
                  "property float nz",
                  "property float s",
                  "property float t",
                  "property float material_u",
                  "property float material_v",
                  "property int panel",
                  "property uchar seam",
                  "element face 4",
                  "property list uchar uint vertex_indices"}));
}

TEST(PlyFile, holds_each_corner_with_its_material_coordinates_panel_and_seam) {
    constexpr std::size_t kVertex = 10 * sizeof(float) + 5, kFace = 13;
    const DrawMesh mesh = sewn_right_to_wrong();
    const std::string data = open_ply(garment_ply(mesh)).data;
    std::vector<PanelPart> parts = split_by_panel(mesh);
    pack_panels(parts, {});
    ASSERT_EQ(data.size(), 8 * kVertex + 4 * kFace);
    for (std::size_t t = 0; t < 4; ++t) {
        const std::size_t face = 8 * kVertex + t * kFace;
        EXPECT_EQ(data[face], 3);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t vertex = kVertex * value_at<std::uint32_t>(data, face + 1 + 4 * k);
            ASSERT_LT(vertex, 8 * kVertex);
            const std::uint32_t v = mesh.triangles[t][k];
            const auto number = [&](std::size_t i) { return value_at<float>(data, vertex + i * sizeof(float)); };
            EXPECT_EQ(Vec3f(number(0), number(1), number(2)), mesh.x[v]);
            EXPECT_EQ(Vec3f(number(3), number(4), number(5)),
                      is_turned(mesh, t, k) ? Vec3f(-mesh.normals[v]) : mesh.normals[v]);
            const Vec2d packed(number(6), number(7));
            EXPECT_LT((parts[mesh.panel[t]].chart->uv(mesh.u[t][k].cast<double>()) - packed).norm(), 1e-6);
            EXPECT_EQ(Vec2f(number(8), number(9)), mesh.u[t][k]);
            EXPECT_EQ(value_at<std::int32_t>(data, vertex + 40), mesh.panel[t]);
            EXPECT_EQ(data[vertex + 44], v == 1 || v == 2 ? 1 : 0);
        }
    }
}

TEST(PlyFile, holds_the_body_after_the_cloth_when_asked_to) {
    constexpr std::size_t kVertex = 10 * sizeof(float) + 5, kFace = 13;
    const Body box = shapes::box({0, 0, 0}, {1, 1, 1}, 1);
    const std::string without = garment_ply(two_panels()), with = garment_ply(two_panels(), {.body = &box});
    const Ply ply = open_ply(with);
    EXPECT_EQ(std::ranges::count(ply.header, "comment panel -1 is the body"), 1);
    EXPECT_EQ(std::ranges::count(ply.header, "element vertex " + std::to_string(8 + box.x.size())), 1);
    EXPECT_EQ(std::ranges::count(ply.header, "element face " + std::to_string(4 + box.triangles.size())), 1);
    ASSERT_EQ(ply.data.size(), (8 + box.x.size()) * kVertex + (4 + box.triangles.size()) * kFace);
    EXPECT_EQ(ply.data.substr(0, 8 * kVertex), open_ply(without).data.substr(0, 8 * kVertex))
        << "the cloth is the same";
    for (std::size_t v = 0; v < box.x.size(); ++v) {
        const std::size_t at = (8 + v) * kVertex;
        EXPECT_EQ(value_at<float>(ply.data, at + 4), static_cast<float>(box.x[v].y()));
        EXPECT_EQ(value_at<std::int32_t>(ply.data, at + 40), -1);
    }
    const std::size_t faces = (8 + box.x.size()) * kVertex;
    EXPECT_EQ(ply.data.substr(faces, 4 * kFace), open_ply(without).data.substr(8 * kVertex));
    for (std::size_t t = 0; t < box.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(value_at<std::uint32_t>(ply.data, faces + (4 + t) * kFace + 1 + 4 * k),
                      8 + static_cast<std::uint32_t>(box.triangles[t][k]));
}

TEST(PlyFile, is_read_by_another_program) {
    const std::string bytes = garment_ply(two_panels());
    Assimp::Importer importer;
    const aiScene* scene =
        importer.ReadFileFromMemory(bytes.data(), bytes.size(), aiProcess_ValidateDataStructure, "ply");
    ASSERT_NE(scene, nullptr) << importer.GetErrorString();
    ASSERT_EQ(scene->mNumMeshes, 1U);
    const aiMesh& mesh = *scene->mMeshes[0];
    EXPECT_EQ(mesh.mNumFaces, 4U);
    ASSERT_EQ(mesh.mNumVertices, 8U);
    ASSERT_TRUE(mesh.HasNormals() && mesh.HasTextureCoords(0));
    EXPECT_EQ(mesh.mVertices[7].x, 0.1F);  // the sleeve's last vertex, on the seam
    EXPECT_GT(mesh.mTextureCoords[0][7].x, 0);
    EXPECT_LT(mesh.mTextureCoords[0][7].x, 1);
}

TEST(PlyFile, leaves_out_what_a_mesh_does_not_have) {
    DrawMesh bare = two_panels();
    bare.u.clear();
    EXPECT_EQ(garment_ply(bare).find("property float s"), std::string::npos);
    const Body box = shapes::box({0, 0, 0}, {1, 1, 1}, 1);
    const Ply body = open_ply(body_ply(box));
    EXPECT_EQ(body.header.size(), 3U + 1U + 6U + 2U);  // three lines, the vertices with their properties, the faces
    EXPECT_EQ(body.data.size(), 24 * box.x.size() + 13 * box.triangles.size());
}

}  // namespace
}  // namespace selvedge::sim
