/* Reads the files of Triangles.write. For C and C++. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FLAT, SMOOTH, ROUNDS, LIT };
enum { LIGHTS = 2 };

struct vertex {
    float position[3];
    uint8_t rgba[4];
};

struct header {
    char magic[8];
    int32_t coloring, perspective, vertices, indices;
    float to_clip[16];
};

/* Of lit triangles: the eye, or if eye_is_point is 0 the direction to it; lights, with the direction of travel. */
struct light {
    float eye[3], eye_is_point, ambient[3];
    struct {
        float direction[3], color[3];
    } lights[LIGHTS];
};

/* Normals and light of lit triangles; w of each vertex, if the number for perspective is 2; otherwise NULL. */
struct triangles {
    struct header header;
    struct vertex *vertices;
    uint32_t *indices;
    float (*normals)[3], *w;
    struct light light;
};

static void *read_array(FILE *in, size_t size, size_t count) {
    void *array = malloc(size * count + 1);
    if (array && fread(array, size, count, in) == count) return array;
    free(array);
    return NULL;
}

/* Returns what is wrong, or NULL. */
static const char *read_triangles(const char *file, struct triangles *to) {
    struct header *header = &to->header;
    FILE *in = fopen(file, "rb");
    if (!in) return "the file of triangles cannot be read";
    if (fread(header, sizeof *header, 1, in) != 1 || memcmp(header->magic, "LZTRI001", 8)) {
        fclose(in);
        return "not a file of triangles";
    }
    int is_lit = header->coloring == LIT, has_w = header->perspective == 2, is_whole;
    to->vertices = (struct vertex *)read_array(in, sizeof *to->vertices, header->vertices);
    to->indices = (uint32_t *)read_array(in, sizeof *to->indices, header->indices);
    to->normals = is_lit ? (float (*)[3])read_array(in, sizeof *to->normals, header->vertices) : NULL;
    is_whole = !is_lit || fread(&to->light, sizeof to->light, 1, in) == 1;
    to->w = has_w ? (float *)read_array(in, sizeof *to->w, header->vertices) : NULL;
    is_whole = is_whole && to->vertices && to->indices && !to->normals == !is_lit && !to->w == !has_w;
    fclose(in);
    return is_whole ? NULL : "the file of triangles is too short";
}
