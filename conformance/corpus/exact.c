/*
 * Draws a scene of the corpus, as docs/corpus.md says. Coverage and depth are exact rational numbers.
 *
 *   cc -O2 -o exact exact.c -lm
 *   exact SCENE PICTURE [DEPTH PRIMITIVE]
 *
 * All files that it writes are NPY. -DMISTAKE=1, 2 or 3 compiles a mistake: which side of a triangle owns its left edge,
 * which of two primitives wins a tie, or that blending is done after the encoding as sRGB.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef MISTAKE
#define MISTAKE 0
#endif

typedef __int128 wide;

/* A value of JSON: a number, a text, or the values of a list or an object; those of an object have names. */
struct value {
    char name[32], text[32];
    long long number;
    int count;
    struct value *items;
};

static const char *at;
static struct value none;

static void fail(const char *what) {
    fprintf(stderr, "exact: %s\n", what);
    exit(1);
}

static void *allocate(size_t size) {
    void *memory = calloc(size ? size : 1, 1);
    if (!memory) fail("out of memory");
    return memory;
}

static void skip(void) {
    at += strspn(at, " \n\r\t,:");
}

static void read_text(char text[32]) {
    size_t length = strcspn(++at, "\"");
    snprintf(text, 32, "%.*s", (int)(length < 31 ? length : 31), at);
    at += length + 1;
}

static struct value read_value(void) {
    struct value value = {0};
    skip();
    if (*at == '[' || *at == '{') {
        int named = *at++ == '{';
        for (skip(); *at && *at != ']' && *at != '}'; skip()) {
            char name[32] = "";
            if (named) read_text(name);
            value.items = realloc(value.items, (value.count + 1) * sizeof value);
            if (!value.items) fail("out of memory");
            value.items[value.count] = read_value();
            memcpy(value.items[value.count++].name, name, sizeof name);
        }
        at++;
    } else if (*at == '"') {
        read_text(value.text);
    } else if (*at == 't' || *at == 'f') {
        value.number = *at == 't';
        at += strcspn(at, ",]}");
    } else {
        char *end;
        value.number = strtoll(at, &end, 10);
        if (end == at) fail("not JSON");
        at = end;
    }
    return value;
}

static const struct value *get(const struct value *object, const char *name) {
    for (int i = 0; i < object->count; i++) {
        if (!strcmp(object->items[i].name, name)) return &object->items[i];
    }
    return &none;
}

static long long item(const struct value *list, int i) {
    if (i >= list->count) fail("a list is too short");
    return list->items[i].number;
}

/* The sum of the windings of a contour at a sample. */
static int windings(const struct value *contour, long long x, long long y) {
    int sum = 0;
    for (int i = 0; i < contour->count; i++) {
        const struct value *a = &contour->items[i], *b = &contour->items[(i + 1) % contour->count];
        int down = item(a, 1) < item(b, 1);
        if (!down) {
            const struct value *c = a;
            a = b;
            b = c;
        }
        long long x0 = item(a, 0), y0 = item(a, 1), x1 = item(b, 0), y1 = item(b, 1);
        if (y < y0 || y >= y1) continue;
        wide left = (wide)(x - x0) * (y1 - y0), right = (wide)(y - y0) * (x1 - x0);
        if (MISTAKE == 1 ? left > right : left >= right) sum += down ? 1 : -1;
    }
    return sum;
}

static int in_square(const struct value *center, long long half, long long x, long long y) {
    long long x0 = item(center, 0), y0 = item(center, 1);
    return x0 - half <= x && x < x0 + half && y0 - half <= y && y < y0 + half;
}

static int on_line(const struct value *line, long long x, long long y) {
    return windings(get(line, "quad"), x, y) || in_square(get(line, "from"), 128, x, y) ||
           in_square(get(line, "to"), 128, x, y);
}

static wide square_of_sphere(const struct value *sphere, long long x, long long y) {
    const struct value *center = get(sphere, "center");
    long long radius = get(sphere, "radius")->number;
    return (wide)radius * radius - (wide)(x - item(center, 0)) * (x - item(center, 0)) -
           (wide)(y - item(center, 1)) * (y - item(center, 1));
}

static int covers(const struct value *p, long long x, long long y, int width) {
    const char *kind = get(p, "kind")->text;
    if (!strcmp(kind, "point")) return in_square(get(p, "at"), get(p, "half")->number, x, y);
    if (!strcmp(kind, "sphere")) return square_of_sphere(p, x, y) >= 0;
    if (!strcmp(kind, "line")) {
        /* Between two samples of the line, also of those beside the raster */
        long long left = x, right = x, reach = 256LL * (width + 512);
        while (left > x - reach && !on_line(p, left, y)) left -= 256;
        while (right < x + reach && !on_line(p, right, y)) right += 256;
        return on_line(p, left, y) && on_line(p, right, y);
    }
    if (strcmp(kind, "polygon")) exit(3);
    int sum = 0;
    const struct value *contours = get(p, "contours");
    for (int i = 0; i < contours->count; i++) sum += windings(&contours->items[i], x, y);
    return strcmp(get(p, "fill")->text, "even-odd") ? sum != 0 : sum % 2 != 0;
}

static wide area(const struct value *a, const struct value *b, long long x, long long y) {
    return (wide)(item(b, 0) - item(a, 0)) * (y - item(a, 1)) - (wide)(item(b, 1) - item(a, 1)) * (x - item(a, 0));
}

/* base + numerator / denominator, rounded to the nearest integer. */
static long long rounded(long long base, wide numerator, wide denominator) {
    if (denominator == 0) return base;
    if (denominator < 0) {
        numerator = -numerator;
        denominator = -denominator;
    }
    wide twice = 2 * numerator + denominator;
    return base + (long long)(twice / (2 * denominator) - (twice % (2 * denominator) < 0));
}

static long long depth_at(const struct value *p, long long x, long long y) {
    const char *kind = get(p, "kind")->text;
    if (!strcmp(kind, "point")) return item(get(p, "at"), 2);
    if (!strcmp(kind, "sphere")) {
        double height = sqrt((double)square_of_sphere(p, x, y)) * get(p, "depth_of_step")->number;
        return (long long)floor(item(get(p, "center"), 2) - height + 0.5);
    }
    if (!strcmp(kind, "line")) {
        const struct value *from = get(p, "from"), *to = get(p, "to");
        long long dx = item(to, 0) - item(from, 0), dy = item(to, 1) - item(from, 1);
        wide square = (wide)dx * dx + (wide)dy * dy;
        wide along = (wide)(x - item(from, 0)) * dx + (wide)(y - item(from, 1)) * dy;
        along = along < 0 ? 0 : along > square ? square : along;
        return rounded(item(from, 2), along * (item(to, 2) - item(from, 2)), square);
    }
    const struct value *plane = get(p, "plane"), *a = &plane->items[0], *b = &plane->items[1], *c = &plane->items[2];
    if (item(a, 2) == item(b, 2) && item(a, 2) == item(c, 2)) return item(a, 2);
    wide up = area(c, a, x, y) * (item(b, 2) - item(a, 2)) + area(a, b, x, y) * (item(c, 2) - item(a, 2));
    return rounded(item(a, 2), up, area(a, b, item(c, 0), item(c, 1)));
}

static void color_at(const struct value *p, long long x, long long y, double color[4]) {
    const struct value *plane = get(p, "plane"), *colors = get(p, "colors");
    double weights[3], sum = 0;
    for (int i = 0; i < 4; i++) color[i] = colors->count ? 0 : item(get(p, "color"), i) / 255.0;
    if (!colors->count) return;
    for (int i = 0; i < 3; i++) {
        weights[i] = (double)area(&plane->items[(i + 1) % 3], &plane->items[(i + 2) % 3], x, y) / item(get(p, "w"), i);
        sum += weights[i];
    }
    for (int i = 0; i < 12; i++) color[i % 4] += weights[i / 4] / sum * item(&colors->items[i / 4], i % 4) / 255.0;
}

static double encoded(double c) {
    return c <= 0.0031308 ? 12.92 * c : 1.055 * pow(c, 1 / 2.4) - 0.055;
}

static void write_npy(const char *path, const char *type, const char *shape, const void *data, size_t size) {
    FILE *out = fopen(path, "wb");
    if (!out) fail("a file cannot be written");
    char text[119];
    snprintf(text, sizeof text, "{'descr': '%s', 'fortran_order': False, 'shape': (%s), }", type, shape);
    fwrite("\x93NUMPY\1\0\x76\0", 1, 10, out);
    fprintf(out, "%-117s\n", text);
    fwrite(data, 1, size, out);
    if (fclose(out)) fail("a file cannot be written");
}

int main(int count, char **arguments) {
    static char text[1 << 22];
    FILE *in = count == 3 || count == 5 ? fopen(arguments[1], "rb") : NULL;
    if (!in) fail("give a scene, and the names of the picture and, perhaps, of depth and primitive");
    text[fread(text, 1, sizeof text - 1, in)] = 0;
    at = text;
    struct value scene = read_value();
    const struct value *primitives = get(&scene, "primitives");
    const char *test = get(&scene, "depth_test")->text;
    int greater = !strncmp(test, "greater", 7), last = strstr(test, "or-equal") != NULL;
    if (MISTAKE == 2) last = !last;
    int width = (int)get(&scene, "width")->number, height = (int)get(&scene, "height")->number;
    unsigned char *picture = allocate(4 * (size_t)width * height);
    int *depths = allocate(sizeof(int) * width * height), *indices = allocate(sizeof(int) * width * height);
    int *order = allocate(sizeof(int) * primitives->count);
    long long *own = allocate(sizeof(long long) * primitives->count);
    for (int i = 0; i < width * height; i++) {
        long long x = 256LL * (i % width) + 128, y = 256LL * (i / width) + 128;
        long long back = get(&scene, "background_depth")->number;

        /* Those that pass against the background, nearest first: insertion keeps the order of submission at ties */
        int passing = 0;
        for (int j = 0; j < primitives->count; j++) {
            if (!covers(&primitives->items[j], x, y, width)) continue;
            own[j] = depth_at(&primitives->items[j], x, y);
            if (last ? (greater ? own[j] < back : own[j] > back) : (greater ? own[j] <= back : own[j] >= back)) continue;
            int k = passing++;
            for (; k > 0; k--) {
                long long other = own[order[k - 1]], nearer = greater ? own[j] - other : other - own[j];
                if (nearer < 0 || (nearer == 0 && !last)) break;
                order[k] = order[k - 1];
            }
            order[k] = j;
        }
        depths[i] = (int)(passing ? own[order[0]] : back);
        indices[i] = passing ? order[0] : -1;

        double t = 1, sums[4] = {0}, color[4];
        int backdrop = 0;
        for (int k = 0; k <= passing && !backdrop; k++) {
            backdrop = k == passing || !get(&primitives->items[order[k]], "translucent")->number;
            if (k < passing) color_at(&primitives->items[order[k]], x, y, color);
            for (int c = 0; c < 4 && k == passing; c++) color[c] = item(get(&scene, "background"), c) / 255.0;
            double w = t * color[3];
            for (int c = 0; c < 3; c++) sums[c] += w * (MISTAKE == 3 ? encoded(color[c]) : color[c]);
            sums[3] += w;
            t *= 1 - color[3];
            if (k == 0 && backdrop) {
                /* Not blended: also what is transparent keeps its colour */
                for (int c = 0; c < 3; c++) sums[c] = color[c];
            } else if (backdrop) {
                for (int c = 0; c < 3 && sums[3] > 0; c++) sums[c] /= sums[3];
            }
        }
        for (int c = 0; c < 3; c++) {
            double code = MISTAKE == 3 && indices[i] >= 0 && passing && t >= 0 && backdrop &&
                                  get(&primitives->items[indices[i]], "translucent")->number
                              ? sums[c]
                              : encoded(sums[c]);
            picture[4 * i + c] = (unsigned char)floor(255 * code + 0.5);
        }
        picture[4 * i + 3] = (unsigned char)floor(255 * sums[3] + 0.5);
    }
    char shape[64];
    snprintf(shape, sizeof shape, "%d, %d, 4", height, width);
    write_npy(arguments[2], "|u1", shape, picture, 4 * (size_t)width * height);
    snprintf(shape, sizeof shape, "%d, %d", height, width);
    if (count == 5) write_npy(arguments[3], "<i4", shape, depths, sizeof(int) * width * height);
    if (count == 5) write_npy(arguments[4], "<i4", shape, indices, sizeof(int) * width * height);
    return 0;
}
