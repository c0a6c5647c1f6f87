/*
 * Draws a file of triangles with OpenGL 3.3 on Mesa's llvmpipe or softpipe, without a display, and prints one line of
 * JSON.
 *
 *   llvmpipe FILE [--side N] [--samples N] [--warm-up SECONDS] [--measure SECONDS] [--frames N] [--visibility]
 *            [--read-back] [--picture FILE [--depth-test NAME --background R,G,B,A --background-depth D]]
 *
 * A frame clears, draws all triangles and waits until they are drawn (glFinish); colours stay linear. Times are
 * milliseconds of wall clock. --visibility draws triangle numbers first and runs the fragment shader once a sample.
 * --samples draws with at least so many samples a pixel, or as many as llvmpipe has, and averages them; the fragment
 * shader runs once a pixel. --read-back also copies the picture to the program's memory, each frame. --frames draws so
 * many frames and no warm-up.
 * --picture draws one frame into an sRGB target and writes it: red, green, blue, alpha, a byte each, rows from the top.
 *
 * Set LP_NUM_THREADS. The file's format is that of Triangles.write; if the number for perspective is 2, the w of each
 * vertex follows.
 */
#define GL_GLEXT_PROTOTYPES 1
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <time.h>

#include "triangles.h"

enum { LEAST_FRAMES = 5, MOST_FRAMES = 65536 };

struct options {
    const char *file, *picture, *depth_test;
    float background[4];
    double background_depth;
    int side, samples, frames, visibility, read_back;
    double warm_up, measure;
};

static struct triangles triangles;
static struct options options = {.side = 1024, .samples = 1, .warm_up = 1.5, .measure = 4,
                                 .depth_test = "less", .background_depth = 1};
static GLuint target, resolved, ids, program, id_program, resolve_program;
static uint8_t *pixels;

static void fail(const char *what) {
    fprintf(stderr, "llvmpipe: %s\n", what);
    exit(1);
}

static double now_ms(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec * 1e3 + time.tv_nsec * 1e-6;
}

/* The formula of RoundsShader.java. */
#define ROUNDS_FORMULA \
    "float wave(float t) { float q = t * t;" \
    " return t * (1.0 - q * (0.16666667 - q * (0.008333333 - q * 0.0001984127))); }\n" \
    "vec4 rounds(vec3 c) { float x = c.r, y = c.g;\n" \
    " for (int i = 0; i < 64; i++) {\n" \
    "  float s = 0.5 * x + 0.3 * y - 0.4 * c.b; float t = 0.4 * y - 0.5 * x + 0.3 * c.b;\n" \
    "  x = 0.5 * c.r + 0.5 * wave(s); y = 0.5 * c.g + 0.5 * wave(t); }\n" \
    " return vec4(0.25 + 0.75 * x, 0.25 + 0.75 * y, c.b, 1.0); }\n"

static const char *VERTEX_SHADER =
    "layout(location = 0) in vec3 position; layout(location = 1) in vec4 color; layout(location = 3) in float w;\n"
    "uniform mat4 to_clip; VARYING out vec4 varying_color;\n"
    "void main() { gl_Position = to_clip * vec4(position, 1.0) WEIGHTED; varying_color = color; }\n";

static const char *COLOR_SHADER =
    "VARYING in vec4 varying_color; out vec4 color;\n"
    "void main() { color = varying_color; }\n";

static const char *LIT_VERTEX_SHADER =
    "layout(location = 0) in vec3 position; layout(location = 1) in vec4 color; layout(location = 2) in vec3 normal;\n"
    "uniform mat4 to_clip; out vec3 varying_position, varying_normal; out vec4 varying_color;\n"
    "void main() { gl_Position = to_clip * vec4(position, 1.0);\n"
    " varying_position = position; varying_normal = normal; varying_color = color; }\n";

/* Rule 6.5 of the contract without highlights. The normal is on the side from which the triangle is seen. */
static const char *LIT_SHADER =
    "in vec3 varying_position, varying_normal; in vec4 varying_color; out vec4 color;\n"
    "uniform vec4 eye; uniform vec3 ambient, directions[LIGHTS], colors[LIGHTS];\n"
    "void main() {\n"
    " vec3 n = normalize(varying_normal); if (!gl_FrontFacing) n = -n;\n"
    " vec3 v = normalize(eye.xyz - eye.w * varying_position); if (dot(n, n) == 0.0) n = v;\n"
    " vec3 sum = ambient;\n"
    " for (int i = 0; i < LIGHTS; i++) sum += max(dot(n, -directions[i]), 0.0) * colors[i];\n"
    " color = vec4(varying_color.rgb * sum, 1.0); }\n";

static const char *ROUNDS_SHADER =
    "VARYING in vec4 varying_color; out vec4 color;\n" ROUNDS_FORMULA
    "void main() { color = rounds(varying_color.rgb); }\n";

static const char *ID_SHADER = "out uint id; void main() { id = uint(gl_PrimitiveID + 1); }\n";

static const char *FULL_SCREEN_SHADER =
    "void main() { vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);\n"
    " gl_Position = vec4(corner, 0.0, 1.0); }\n";

/* Interpolates linearly on the screen: without perspective. */
static const char *RESOLVE_SHADER =
    "uniform usampler2D ids; uniform samplerBuffer corners; uniform samplerBuffer colors; uniform float side;\n"
    "out vec4 color;\n" ROUNDS_FORMULA
    "void main() {\n"
    " uint id = texelFetch(ids, ivec2(gl_FragCoord.xy), 0).r;\n"
    " if (id == 0u) { color = vec4(0.0); return; }\n"
    " int first = 3 * int(id - 1u); vec2 p = 2.0 * gl_FragCoord.xy / side - 1.0;\n"
    " vec2 a = texelFetch(corners, first).xy;\n"
    " vec2 ab = texelFetch(corners, first + 1).xy - a, ac = texelFetch(corners, first + 2).xy - a, ap = p - a;\n"
    " float area = ab.x * ac.y - ab.y * ac.x;\n"
    " float u = (ap.x * ac.y - ap.y * ac.x) / area, v = (ab.x * ap.y - ab.y * ap.x) / area;\n"
    " vec4 ca = texelFetch(colors, first), cb = texelFetch(colors, first + 1), cc = texelFetch(colors, first + 2);\n"
    " vec4 c = ca + u * (cb - ca) + v * (cc - ca);\n"
    " color = RESULT; }\n";

static GLuint shader(GLenum stage, const char *text) {
    const char *varying = triangles.header.coloring == FLAT ? "flat" : triangles.header.perspective ? "smooth" : "noperspective";
    char prologue[256];
    snprintf(prologue, sizeof prologue,
             "#version 330 core\n#define VARYING %s\n#define RESULT %s\n#define LIGHTS %d\n#define WEIGHTED %s\n",
             varying, triangles.header.coloring == ROUNDS ? "rounds(c.rgb)" : "c", LIGHTS, triangles.w ? "* w" : "");
    const char *parts[] = {prologue, text};
    GLuint name = glCreateShader(stage);
    glShaderSource(name, 2, parts, NULL);
    glCompileShader(name);
    GLint compiled;
    glGetShaderiv(name, GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        char log[4096];
        glGetShaderInfoLog(name, sizeof log, NULL, log);
        fail(log);
    }
    return name;
}

static GLuint link_program(const char *vertex_text, const char *fragment_text) {
    GLuint name = glCreateProgram();
    glAttachShader(name, shader(GL_VERTEX_SHADER, vertex_text));
    glAttachShader(name, shader(GL_FRAGMENT_SHADER, fragment_text));
    glLinkProgram(name);
    GLint linked;
    glGetProgramiv(name, GL_LINK_STATUS, &linked);
    if (!linked) fail("a program does not link");
    glUseProgram(name);
    GLint matrix = glGetUniformLocation(name, "to_clip");
    if (matrix >= 0) glUniformMatrix4fv(matrix, 1, GL_FALSE, triangles.header.to_clip);
    return name;
}

static void *allocate(size_t size) {
    void *memory = malloc(size ? size : 1);
    if (!memory) fail("out of memory");
    return memory;
}

static void create_context(void) {
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_display =
        (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
    if (!get_display) fail("EGL has no platform displays");
    EGLDisplay display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    if (!eglInitialize(display, NULL, NULL)) fail("EGL has no surfaceless platform");
    eglBindAPI(EGL_OPENGL_API);
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = NULL;
    EGLint configs = 0;
    eglChooseConfig(display, wanted, &config, 1, &configs);
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
    EGLContext context = eglCreateContext(display, configs ? config : NULL, EGL_NO_CONTEXT, version);
    if (!context || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) fail("no OpenGL 3.3 context");
    const char *renderer = (const char *)glGetString(GL_RENDERER);
    if (!strstr(renderer, "llvmpipe") && !strstr(renderer, "softpipe")) {
        fail("OpenGL is not llvmpipe or softpipe; set LIBGL_ALWAYS_SOFTWARE=1 and GALLIUM_DRIVER=llvmpipe");
    }
}

static void upload_triangles(void) {
    GLuint names[5];
    glGenVertexArrays(1, &names[0]);
    glBindVertexArray(names[0]);
    glGenBuffers(4, &names[1]);
    glBindBuffer(GL_ARRAY_BUFFER, names[1]);
    glBufferData(GL_ARRAY_BUFFER, sizeof *triangles.vertices * triangles.header.vertices, triangles.vertices, GL_STATIC_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof *triangles.vertices, NULL);
    glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof *triangles.vertices, (void *)sizeof(float[3]));
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    if (triangles.normals) {
        glBindBuffer(GL_ARRAY_BUFFER, names[3]);
        glBufferData(GL_ARRAY_BUFFER, sizeof *triangles.normals * triangles.header.vertices, triangles.normals, GL_STATIC_DRAW);
        glVertexAttribPointer(2, 3, GL_FLOAT, GL_FALSE, 0, NULL);
        glEnableVertexAttribArray(2);
    }
    if (triangles.w) {
        glBindBuffer(GL_ARRAY_BUFFER, names[4]);
        glBufferData(GL_ARRAY_BUFFER, sizeof *triangles.w * triangles.header.vertices, triangles.w, GL_STATIC_DRAW);
        glVertexAttribPointer(3, 1, GL_FLOAT, GL_FALSE, 0, NULL);
        glEnableVertexAttribArray(3);
    }
    if (triangles.header.indices) {
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[2]);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof *triangles.indices * triangles.header.indices, triangles.indices, GL_STATIC_DRAW);
    }
}

static GLuint renderbuffer(GLenum format, GLenum attachment, int samples) {
    GLuint name;
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    /* 0 samples: no multisampling */
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, options.side, options.side);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, name);
    return name;
}

static void create_targets(void) {
    GLenum format = options.picture ? GL_SRGB8_ALPHA8 : GL_RGBA8;
    GLint most = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    if (options.samples > most) options.samples = most;
    int samples = options.samples > 1 ? options.samples : 0;
    glGenFramebuffers(1, &resolved);
    glBindFramebuffer(GL_FRAMEBUFFER, resolved);
    renderbuffer(format, GL_COLOR_ATTACHMENT0, 0);
    glGenFramebuffers(1, &target);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    renderbuffer(format, GL_COLOR_ATTACHMENT0, samples);
    GLuint depth = renderbuffer(GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT, samples);
    if (options.visibility) {
        GLuint texture;
        glGenTextures(1, &texture);
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_R32UI, options.side, options.side, 0, GL_RED_INTEGER, GL_UNSIGNED_INT, NULL);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glGenFramebuffers(1, &ids);
        glBindFramebuffer(GL_FRAMEBUFFER, ids);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    }
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) fail("the target is not complete");
}

static void buffer_texture(int unit, GLenum format, size_t size, const void *data) {
    GLuint buffer, texture;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_TEXTURE_BUFFER, buffer);
    glBufferData(GL_TEXTURE_BUFFER, size, data, GL_STATIC_DRAW);
    glGenTextures(1, &texture);
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_BUFFER, texture);
    glTexBuffer(GL_TEXTURE_BUFFER, format, buffer);
    glActiveTexture(GL_TEXTURE0);
}

/* Corners on the screen and their colours, triangle by triangle. */
static void create_visibility(void) {
    if (triangles.header.perspective) fail("--visibility is for scenes without perspective");
    int count = triangles.header.indices ? triangles.header.indices : triangles.header.vertices;
    float (*corners)[2] = allocate(sizeof *corners * count);
    uint8_t (*colors)[4] = allocate(sizeof *colors * count);
    const float *m = triangles.header.to_clip;
    for (int i = 0; i < count; i++) {
        const struct vertex *v = &triangles.vertices[triangles.header.indices ? triangles.indices[i] : (uint32_t)i];
        for (int row = 0; row < 2; row++) {
            corners[i][row] = m[row] * v->position[0] + m[4 + row] * v->position[1] + m[8 + row] * v->position[2] +
                              m[12 + row];
        }
        memcpy(colors[i], v->rgba, 4);
    }
    id_program = link_program(VERTEX_SHADER, ID_SHADER);
    resolve_program = link_program(FULL_SCREEN_SHADER, RESOLVE_SHADER);
    glUniform1i(glGetUniformLocation(resolve_program, "corners"), 1);
    glUniform1i(glGetUniformLocation(resolve_program, "colors"), 2);
    glUniform1f(glGetUniformLocation(resolve_program, "side"), options.side);
    buffer_texture(1, GL_RG32F, sizeof *corners * count, corners);
    buffer_texture(2, GL_RGBA8, sizeof *colors * count, colors);
    free(corners);
    free(colors);
}

static void set_light(void) {
    glUniform4f(glGetUniformLocation(program, "eye"), triangles.light.eye[0], triangles.light.eye[1], triangles.light.eye[2], triangles.light.eye_is_point);
    glUniform3fv(glGetUniformLocation(program, "ambient"), 1, triangles.light.ambient);
    for (int i = 0; i < LIGHTS; i++) {
        char name[32];
        snprintf(name, sizeof name, "directions[%d]", i);
        glUniform3fv(glGetUniformLocation(program, name), 1, triangles.light.lights[i].direction);
        snprintf(name, sizeof name, "colors[%d]", i);
        glUniform3fv(glGetUniformLocation(program, name), 1, triangles.light.lights[i].color);
    }
}

static void draw_triangles(GLuint with) {
    glUseProgram(with);
    if (triangles.header.indices) {
        glDrawElements(GL_TRIANGLES, triangles.header.indices, GL_UNSIGNED_INT, NULL);
    } else {
        glDrawArrays(GL_TRIANGLES, 0, triangles.header.vertices);
    }
}

static double frame(void) {
    double start = now_ms();
    if (options.visibility) {
        const GLuint none[4] = {0};
        glBindFramebuffer(GL_FRAMEBUFFER, ids);
        glClearBufferuiv(GL_COLOR, 0, none);
        glClear(GL_DEPTH_BUFFER_BIT);
        draw_triangles(id_program);
        glBindFramebuffer(GL_FRAMEBUFFER, target);
        glDisable(GL_DEPTH_TEST);
        glUseProgram(resolve_program);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glEnable(GL_DEPTH_TEST);
    } else {
        glBindFramebuffer(GL_FRAMEBUFFER, target);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw_triangles(program);
        if (options.samples > 1) {
            glBindFramebuffer(GL_READ_FRAMEBUFFER, target);
            glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved);
            glBlitFramebuffer(0, 0, options.side, options.side, 0, 0, options.side, options.side, GL_COLOR_BUFFER_BIT,
                              GL_NEAREST);
            glBindFramebuffer(GL_FRAMEBUFFER, resolved);
        }
    }
    if (options.read_back) glReadPixels(0, 0, options.side, options.side, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    glFinish();
    return now_ms() - start;
}

static long write_picture(void) {
    glEnable(GL_FRAMEBUFFER_SRGB);
    frame();
    glReadPixels(0, 0, options.side, options.side, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    FILE *out = fopen(options.picture, "wb");
    if (!out) fail("the picture cannot be written");
    size_t row_bytes = 4 * (size_t)options.side;
    long covered = 0;
    for (int y = options.side - 1; y >= 0; y--) {
        const uint8_t *row = pixels + y * row_bytes;
        for (int x = 0; x < options.side; x++) covered += row[4 * x + 3] != 0;
        if (fwrite(row, 1, row_bytes, out) != row_bytes) fail("the picture cannot be written");
    }
    if (fclose(out)) fail("the picture cannot be written");
    return covered;
}

static int ascending(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void measure(void) {
    static double times[MOST_FRAMES];
    double first = frame();
    int count = 0;
    if (options.frames) {
        times[count++] = first;
        while (count < options.frames && count < MOST_FRAMES) times[count++] = frame();
    } else {
        for (double end = now_ms() + 1e3 * options.warm_up; now_ms() < end;) frame();
        double end = now_ms() + 1e3 * options.measure;
        while (count < MOST_FRAMES && (count < LEAST_FRAMES || now_ms() < end)) times[count++] = frame();
    }
    qsort(times, count, sizeof *times, ascending);
    printf("{\"median\":%.4f,\"q1\":%.4f,\"q3\":%.4f,\"min\":%.4f,\"max\":%.4f,\"first\":%.2f,\"frames\":%d,\"samples\":%d,"
           "\"version\":\"%s\",\"renderer\":\"%s\"}\n",
           times[count / 2], times[count / 4], times[3 * count / 4], times[0], times[count - 1], first, count, options.samples,
           glGetString(GL_VERSION), glGetString(GL_RENDERER));
}

static void read_background(const char *text) {
    float *to = options.background;
    if (sscanf(text, "%f,%f,%f,%f", &to[0], &to[1], &to[2], &to[3]) != 4) fail("--background needs four numbers");
}

static GLenum depth_test(void) {
    int is_equal = strstr(options.depth_test, "or-equal") != NULL;
    if (!strncmp(options.depth_test, "less", 4)) return is_equal ? GL_LEQUAL : GL_LESS;
    return is_equal ? GL_GEQUAL : GL_GREATER;
}

static void read_options(int count, char **arguments) {
    for (int i = 1; i < count; i++) {
        const char *name = arguments[i];
        if (!strcmp(name, "--visibility")) {
            options.visibility = 1;
        } else if (!strcmp(name, "--read-back")) {
            options.read_back = 1;
        } else if (strncmp(name, "--", 2)) {
            options.file = name;
        } else {
            const char *value = ++i < count ? arguments[i] : "";
            if (!strcmp(name, "--side")) options.side = atoi(value);
            else if (!strcmp(name, "--samples")) options.samples = atoi(value);
            else if (!strcmp(name, "--frames")) options.frames = atoi(value);
            else if (!strcmp(name, "--warm-up")) options.warm_up = atof(value);
            else if (!strcmp(name, "--measure")) options.measure = atof(value);
            else if (!strcmp(name, "--picture")) options.picture = value;
            else if (!strcmp(name, "--depth-test")) options.depth_test = value;
            else if (!strcmp(name, "--background-depth")) options.background_depth = atof(value);
            else if (!strcmp(name, "--background")) read_background(value);
            else fail("no such option");
        }
    }
    if (!options.file || options.side < 1 || options.samples < 1) {
        fail("give a file of triangles, and a side and samples above 0");
    }
}

int main(int count, char **arguments) {
    read_options(count, arguments);
    const char *problem = read_triangles(options.file, &triangles);
    if (problem) fail(problem);
    create_context();
    upload_triangles();
    create_targets();
    if (triangles.header.coloring == LIT) {
        program = link_program(LIT_VERTEX_SHADER, LIT_SHADER);
        set_light();
    } else {
        program = link_program(VERTEX_SHADER, triangles.header.coloring == ROUNDS ? ROUNDS_SHADER : COLOR_SHADER);
    }
    if (options.visibility) create_visibility();
    pixels = allocate(4 * (size_t)options.side * options.side);
    glViewport(0, 0, options.side, options.side);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(depth_test());
    glClearDepth(options.background_depth);
    const float *background = options.background;
    glClearColor(background[0], background[1], background[2], background[3]);
    if (options.picture) {
        printf("{\"covered\":%ld}\n", write_picture());
    } else {
        measure();
    }
    return glGetError() == GL_NO_ERROR ? 0 : 1;
}
