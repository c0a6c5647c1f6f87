/*
 * Draws a file of triangles for peer.py with PortableGL, github.com/rswinkle/PortableGL, and writes linear colours.
 *
 *   cc -O2 -I PORTABLEGL -o portablegl portablegl.c -lm
 *   portablegl FILE --side N --picture FILE --depth-test NAME --background R,G,B,A --background-depth D
 */
#define PORTABLEGL_IMPLEMENTATION
#include "portablegl.h"

#include "../../jmh/peers/triangles.h"

static void vertex_shader(float *out, vec4 *in, Shader_Builtins *builtins, void *uniforms) {
    (void)uniforms;
    for (int i = 0; i < 4; i++) out[i] = ((float *)&in[1])[i];
    builtins->gl_Position = in[0];
}

static void fragment_shader(float *in, Shader_Builtins *builtins, void *uniforms) {
    (void)uniforms;
    builtins->gl_FragColor = (vec4){in[0], in[1], in[2], in[3]};
}

int main(int count, char **arguments) {
    struct triangles triangles;
    if (count != 12 || read_triangles(arguments[1], &triangles)) return 2;
    int vertices = triangles.header.vertices;
    float *data = malloc(8 * sizeof *data * vertices);
    for (int i = 0; i < vertices; i++) {
        float factor = triangles.w ? triangles.w[i] : 1;
        for (int k = 0; k < 3; k++) data[8 * i + k] = triangles.vertices[i].position[k] * factor;
        data[8 * i + 3] = factor;
        for (int k = 0; k < 4; k++) data[8 * i + 4 + k] = triangles.vertices[i].rgba[k] / 255.0f;
    }

    int side = atoi(arguments[3]);
    const char *test = arguments[7];
    float clear[4];
    if (sscanf(arguments[9], "%f,%f,%f,%f", &clear[0], &clear[1], &clear[2], &clear[3]) != 4) return 2;
    glContext context;
    pix_t *pixels = NULL;
    if (!init_glContext(&context, &pixels, side, side)) return 1;
    GLenum smooth[] = {PGL_SMOOTH4}, flat[] = {PGL_FLAT4};
    glUseProgram(pglCreateProgram(vertex_shader, fragment_shader, 4, triangles.header.coloring ? smooth : flat, GL_FALSE));
    GLuint buffer;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, 8 * sizeof *data * vertices, data, GL_STATIC_DRAW);
    for (int i = 0; i < 2; i++) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, 8 * sizeof *data, (void *)(4 * i * sizeof *data));
    }
    int is_equal = strstr(test, "or-equal") != NULL;
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(*test == 'l' ? is_equal ? GL_LEQUAL : GL_LESS : is_equal ? GL_GEQUAL : GL_GREATER);
    glClearDepth(atof(arguments[11]));
    glClearColor(clear[0], clear[1], clear[2], clear[3]);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLES, 0, vertices);

    /* Rows from the top */
    FILE *out = fopen(arguments[5], "wb");
    return !out || fwrite(pixels, sizeof *pixels, side * side, out) != (size_t)(side * side) || fclose(out);
}
