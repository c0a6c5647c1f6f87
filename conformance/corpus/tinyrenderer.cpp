// Draws a file of triangles for peer.py with tinyrenderer, github.com/ssloy/tinyrenderer, and writes linear colours.
//
//   g++ -O2 -std=c++20 -I FOLDER -o tinyrenderer tinyrenderer.cpp FOLDER/our_gl.cpp FOLDER/tgaimage.cpp
//   tinyrenderer FILE --side N --picture FILE
//
// Its samples are the lower left corners of pixels, so triangles are moved by half a pixel; it draws no back faces, so
// their vertices are exchanged; and its near side is where z is large.
#include <fstream>
#include <string>
#include <utility>

#include "../../jmh/peers/triangles.h"
#include "our_gl.h"

struct Mixed : IShader {
    const vertex *corners[3];

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
    triangles read;
    if (read_triangles(arguments[1], &read)) return 2;

    init_viewport(0, 0, side, side);
    init_zbuffer(side, side);
    TGAImage picture(side, side, TGAImage::RGBA);
    for (int first = 0; first < read.header.vertices; first += 3) {
        Mixed shader;
        Triangle clip;
        int order[] = {first, first + 1, first + 2};
        const float *a = read.vertices[first].position, *b = read.vertices[first + 1].position;
        const float *c = read.vertices[first + 2].position;
        if ((double(b[0]) - a[0]) * (double(c[1]) - a[1]) < (double(b[1]) - a[1]) * (double(c[0]) - a[0])) {
            std::swap(order[1], order[2]);
        }
        for (int i : {0, 1, 2}) {
            const vertex &v = read.vertices[order[i]];
            const double w = read.w ? read.w[order[i]] : 1;
            shader.corners[i] = &v;
            clip[i] = vec4{v.position[0] - 1.0 / side, v.position[1] - 1.0 / side, -double(v.position[2]), 1} * w;
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
