// Draws a file of triangles for peer.py with tinyrenderer, github.com/ssloy/tinyrenderer, and writes linear colours.
//
//   g++ -O2 -std=c++20 -I FOLDER -o tinyrenderer tinyrenderer.cpp FOLDER/our_gl.cpp FOLDER/tgaimage.cpp
//   tinyrenderer FILE --side N --picture FILE
//
// Its samples are the lower left corners of pixels, so triangles are moved by half a pixel; it draws no back faces, so
// their vertices are exchanged; and its near side is where z is large.
#include <cstring>
#include <iterator>
#include <string>
#include <utility>

#include "our_gl.h"

struct Header {
    char magic[8];
    std::int32_t coloring, perspective, vertices, indices;
    float to_clip[16];
};

struct Vertex {
    float x, y, z;
    std::uint8_t rgba[4];
};

struct Mixed : IShader {
    const Vertex *corners[3];

    std::pair<bool, TGAColor> fragment(const vec3 weights) const override {
        TGAColor color;
        for (int channel : {0, 1, 2, 3}) {
            vec3 parts;
            for (int i : {0, 1, 2}) parts[i] = corners[i]->rgba[channel];
            color[channel < 3 ? 2 - channel : 3] = static_cast<std::uint8_t>(parts * weights + 0.5);
        }
        return {false, color};
    }
};

int main(int count, char **arguments) {
    if (count != 6) return 2;
    const int side = std::stoi(arguments[3]);
    std::ifstream in(arguments[1], std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    Header header;
    std::memcpy(&header, bytes.data(), sizeof header);
    std::vector<Vertex> vertices(header.vertices);
    std::vector<float> w(header.vertices, 1);
    const char *data = bytes.data() + sizeof header, *end = data + vertices.size() * sizeof(Vertex);
    std::memcpy(vertices.data(), data, end - data);
    if (header.perspective == 2) std::memcpy(w.data(), end, w.size() * sizeof(float));

    init_viewport(0, 0, side, side);
    init_zbuffer(side, side);
    TGAImage picture(side, side, TGAImage::RGBA);
    for (int first = 0; first < header.vertices; first += 3) {
        Mixed shader;
        Triangle clip;
        int order[] = {first, first + 1, first + 2};
        const Vertex &a = vertices[first], &b = vertices[first + 1], &c = vertices[first + 2];
        if ((double(b.x) - a.x) * (double(c.y) - a.y) < (double(b.y) - a.y) * (double(c.x) - a.x)) {
            std::swap(order[1], order[2]);
        }
        for (int i : {0, 1, 2}) {
            const Vertex &v = vertices[order[i]];
            shader.corners[i] = &v;
            clip[i] = vec4{v.x - 1.0 / side, v.y - 1.0 / side, -double(v.z), 1} * double(w[order[i]]);
        }
        rasterize(clip, shader, picture);
    }
    std::ofstream out(arguments[5], std::ios::binary);
    for (int y = side - 1; y >= 0; y--) {
        for (int x = 0; x < side; x++) {
            const TGAColor color = picture.get(x, y);
            for (int channel : {2, 1, 0, 3}) out.put(static_cast<char>(color[channel]));
        }
    }
}
