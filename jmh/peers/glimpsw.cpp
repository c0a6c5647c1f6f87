// Draws a file of triangles with GLimpSW, a rasterizer for processors with AVX-512, and prints one line of JSON.
//
//   glimpsw FILE [--side N] [--warm-up SECONDS] [--measure SECONDS] [--picture FILE]
//
// A frame clears, and draws all triangles; colours stay linear. Triangles are put into meshlets, in their order, before
// anything is measured. LP_NUM_THREADS is the number of threads. Times, --picture and the file are those of llvmpipe.c.
#include "Rasterizer.h"
#include "triangles.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>


// Vertices and triangles, as GLimpSW takes them; colours and normals of each vertex
struct Meshlet {
    uint32_t vertices = 0, triangles = 0;
    alignas(64) float positions[3][64];
    alignas(64) uint8_t indices[3][128];
    float colors[3][64], normals[3][64];
};

struct Scene {
    glm::mat4 toClip;
    int coloring;
    std::vector<Meshlet> meshlets;
    light lights;
};

[[noreturn]] static void fail(const char* what) {
    fprintf(stderr, "glimpsw: %s\n", what);
    exit(1);
}

static Scene readScene(const char* file) {
    triangles read;
    if (const char* problem = read_triangles(file, &read)) fail(problem);
    const header& header = read.header;
    if (header.coloring == ROUNDS) fail("no shader for the rounds");
    Scene scene;
    scene.coloring = header.coloring;
    scene.lights = read.light;
    // From -w ... w, least first, to 0 ... w, greatest first
    memcpy(&scene.toClip, header.to_clip, sizeof header.to_clip);
    for (int column = 0; column < 4; column++) {
        scene.toClip[column][2] = 0.5f * (scene.toClip[column][3] - scene.toClip[column][2]);
    }
    std::vector<int> places(header.vertices, -1);
    std::vector<uint32_t> used;
    size_t corners = header.indices ? header.indices : header.vertices;
    for (size_t first = 0; first < corners; first += 3) {
        uint32_t triangle[3];
        int added = 0;
        for (int i = 0; i < 3; i++) {
            triangle[i] = header.indices ? read.indices[first + i] : uint32_t(first + i);
            added += places[triangle[i]] < 0;
        }
        if (scene.meshlets.empty() || scene.meshlets.back().vertices + added > 64 ||
            scene.meshlets.back().triangles == 127) {
            for (uint32_t vertex : used) places[vertex] = -1;
            used.clear();
            scene.meshlets.emplace_back();
        }
        Meshlet& meshlet = scene.meshlets.back();
        for (int i = 0; i < 3; i++) {
            uint32_t vertex = triangle[i];
            if (places[vertex] < 0) {
                uint32_t place = meshlet.vertices++;
                places[vertex] = int(place);
                used.push_back(vertex);
                for (int axis = 0; axis < 3; axis++) {
                    meshlet.positions[axis][place] = read.vertices[vertex].position[axis];
                    meshlet.colors[axis][place] = read.vertices[vertex].rgba[axis] / 255.0f;
                    if (read.normals) meshlet.normals[axis][place] = read.normals[vertex][axis];
                }
            }
            meshlet.indices[i][meshlet.triangles] = uint8_t(places[vertex]);
        }
        meshlet.triangles++;
    }
    return scene;
}

static void shadeMeshlet(const Scene& scene, uint32_t index, swr::ShadedMeshlet& output) {
    const Meshlet& mesh = scene.meshlets[index];
    for (uint32_t i = 0; i < mesh.vertices; i += simd::vec_width) {
        v_float3 position = {simd::load(&mesh.positions[0][i]), simd::load(&mesh.positions[1][i]),
                             simd::load(&mesh.positions[2][i])};
        output.SetPosition(i, simd::mul(scene.toClip, v_float4(position, 1.0f)));
    }
    output.PrimCount = uint8_t(mesh.triangles);
    output.CullMode = swr::FaceCullMode::None;
    memcpy(output.Indices, mesh.indices, sizeof mesh.indices);
}

static v_float3 interpolate(const float (&values)[3][64], const swr::FragmentVars& vars) {
    v_float3 result;
    v_float* axes[] = {&result.x, &result.y, &result.z};
    for (int axis = 0; axis < 3; axis++) {
        const float* of = values[axis];
        *axes[axis] = vars.Interpolate(v_float(of[vars.VertexId[0]]), v_float(of[vars.VertexId[1]]),
                                       v_float(of[vars.VertexId[2]]));
    }
    return result;
}

static v_float3 normalized(v_float3 a) {
    return a * simd::approx_rsqrt(simd::max(simd::dot(a, a), v_float(1e-30f)));
}

// Rule 6.5 of the contract without highlights, as in llvmpipe.c, but for the side: the one towards the eye
static v_float3 lit(const Scene& scene, const Meshlet& mesh, const swr::FragmentVars& vars, v_float3 color) {
    v_float3 n = normalized(interpolate(mesh.normals, vars));
    v_float3 p = interpolate(mesh.positions, vars);
    const float* eye = scene.lights.eye;
    float at = scene.lights.eye_is_point;
    v_float3 v = {eye[0] - at * p.x, eye[1] - at * p.y, eye[2] - at * p.z};
    v_float side = simd::dot(n, v) < 0.0f ? v_float(-1.0f) : v_float(1.0f);
    v_float3 sum = {v_float(scene.lights.ambient[0]), v_float(scene.lights.ambient[1]), v_float(scene.lights.ambient[2])};
    for (const auto& light : scene.lights.lights) {
        const float* d = light.direction;
        v_float cosine = simd::max(-side * (n.x * d[0] + n.y * d[1] + n.z * d[2]), v_float(0.0f));
        sum.x += cosine * light.color[0];
        sum.y += cosine * light.color[1];
        sum.z += cosine * light.color[2];
    }
    return {color.x * sum.x, color.y * sum.y, color.z * sum.z};
}

static float srgb(float linear) {
    float c = std::clamp(linear, 0.0f, 1.0f);
    return c <= 0.0031308f ? 12.92f * c : 1.055f * powf(c, 1 / 2.4f) - 0.055f;
}

static v_uint code(v_float value) {
    return simd::as<uint32_t>(simd::round2i(simd::min(simd::max(value, v_float(0.0f)), v_float(1.0f)) * 255.0f));
}

template<int coloring, bool isSrgb>
static void shadePixels(const Scene& scene, swr::Framebuffer& fb, swr::FragmentVars& vars) {
    vars.TileMask &= simd::movemask(vars.Depth > vars.LoadTile(fb.GetDepthBuffer()));
    if (vars.TileMask == 0) return;
    const Meshlet& mesh = scene.meshlets[vars.MeshletId];
    v_float3 color;
    if constexpr (coloring == FLAT) {
        uint8_t last = vars.VertexId[2];
        color = {v_float(mesh.colors[0][last]), v_float(mesh.colors[1][last]), v_float(mesh.colors[2][last])};
    } else {
        color = interpolate(mesh.colors, vars);
    }
    if constexpr (coloring == LIT) color = lit(scene, mesh, vars, color);
    if constexpr (isSrgb) {
        for (int i = 0; i < 16; i++) {
            color.x[i] = srgb(color.x[i]);
            color.y[i] = srgb(color.y[i]);
            color.z[i] = srgb(color.z[i]);
        }
    }
    vars.StoreTile(fb.GetDepthBuffer(), vars.Depth);
    vars.StoreTile(fb.GetColorBuffer(), code(color.x) | code(color.y) << 8 | code(color.z) << 16 | 0xFF000000u);
}

template<bool isSrgb>
static swr::ShaderDispatchTable shaders(int coloring) {
    switch (coloring) {
    case FLAT: return swr::GetDispatchTable<&shadeMeshlet, &shadePixels<FLAT, isSrgb>>();
    case SMOOTH: return swr::GetDispatchTable<&shadeMeshlet, &shadePixels<SMOOTH, isSrgb>>();
    default: return swr::GetDispatchTable<&shadeMeshlet, &shadePixels<LIT, isSrgb>>();
    }
}

static double now() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int main(int count, char** arguments) {
    std::string file, picture;
    uint32_t side = 1024;
    double warmUp = 1.5, measure = 4;
    for (int i = 1; i < count; i++) {
        std::string name = arguments[i];
        if (name.rfind("--", 0)) {
            file = name;
            continue;
        }
        const char* value = ++i < count ? arguments[i] : "";
        if (name == "--side") side = uint32_t(atoi(value));
        else if (name == "--warm-up") warmUp = atof(value);
        else if (name == "--measure") measure = atof(value);
        else if (name == "--picture") picture = value;
        else fail("no such option");
    }
    if (file.empty() || side < 4 || side % 4 || side > swr::Rasterizer::MaxRenderSize) {
        fail("give a file of triangles, and a side that is a multiple of 4 and not too large");
    }
    Scene scene = readScene(file.c_str());
    const char* threads = getenv("LP_NUM_THREADS");
    swr::Rasterizer rasterizer(threads ? uint32_t(atoi(threads)) : 1);
    auto target = swr::CreateFramebuffer(side, side);
    auto table = picture.empty() ? shaders<false>(scene.coloring) : shaders<true>(scene.coloring);
    auto frame = [&] {
        double start = now();
        target->Clear(0, 0);
        rasterizer.DrawMeshlets(*target, uint32_t(scene.meshlets.size()), {table, &scene});
        return now() - start;
    };
    double first = frame();
    if (!picture.empty()) {
        FILE* out = fopen(picture.c_str(), "wb");
        if (!out) fail("the picture cannot be written");
        long covered = 0;
        for (uint32_t y = side; y-- > 0;) {
            std::vector<uint32_t> row(side);
            for (uint32_t x = 0; x < side; x++) {
                row[x] = target->GetColorBuffer()[((x & ~3u) << 2) + (y & ~3u) * side + (x & 3) + (y & 3) * 4];
                covered += row[x] != 0;
            }
            if (fwrite(row.data(), 4, side, out) != side) fail("the picture cannot be written");
        }
        if (fclose(out)) fail("the picture cannot be written");
        printf("{\"covered\":%ld}\n", covered);
        return 0;
    }
    std::vector<double> times;
    for (double end = now() + 1e3 * warmUp; now() < end;) frame();
    for (double end = now() + 1e3 * measure; times.size() < 5 || now() < end;) times.push_back(frame());
    std::sort(times.begin(), times.end());
    size_t n = times.size();
    printf("{\"median\":%.4f,\"q1\":%.4f,\"q3\":%.4f,\"min\":%.4f,\"max\":%.4f,\"first\":%.2f,\"frames\":%zu,"
           "\"samples\":1,\"version\":\"%s\"}\n", times[n / 2], times[n / 4], times[3 * n / 4], times[0], times[n - 1],
           first, n, "commit 6d30f3e");
}
