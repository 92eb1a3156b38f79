/* window [MESH]: the library in a window. The keys are listed at its lower edge; drop a mesh file on it. */
#define _POSIX_C_SOURCE 200809L
#include <SDL.h>
#include <SDL_opengl.h>

#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "window.h"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

static const char help[] =
    "drag: orbit, or pull cloth and ropes    shift+drag: select    right drag: pan    wheel: zoom\n"
    "1-8: scene  space: pause  . step  [ ] speed  O octree  V cull seen from outside  R record  H help  Esc";

typedef enum gesture { NOTHING, ORBIT, PAN, MARQUEE, PULL } gesture;

typedef struct program {
    SDL_Window* window;
    canvas* canvas;
    stage stage;
    gphys_camera *camera, *observed;
    hand hand;
    overlay marks;
    char* mesh; /* path; NULL: the built-in one */
    const char* directory;
    uint32_t preset, frame, pictures, drawn;
    float speed;
    int paused, step_once, recording, helping, quit, log, shift;
    gesture gesture;
    int x, y; /* of the mouse, pixels */
    double step_ms, pick_ms, cull_ms, first_energy;
} program;

void check(gphys_status status, const char* what) {
    if (status >= 0) return;
    fprintf(stderr, "window: %s: %s: %s\n", what, gphys_status_name(status), gphys_last_error());
    exit(1);
}

double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

uint32_t worker_count(void) {
    const int processors = SDL_GetCPUCount();
    return processors > MAX_WORKERS ? MAX_WORKERS : (uint32_t)processors;
}

/* What tests look at. */
static void say(const program* p, const char* what, double a, double b) {
    if (!p->log) return;
    printf("%s %.9g %.9g\n", what, a, b);
    fflush(stdout);
}

static gphys_camera* new_camera(const program* p) {
    gphys_camera* camera;
    gphys_camera_desc desc;
    check(gphys_camera_desc_init(&desc, sizeof desc), "camera desc");
    desc.handedness = GPHYS_RIGHT_HANDED;
    desc.depth_range = GPHYS_DEPTH_MINUS_ONE_TO_ONE;
    check(gphys_camera_create(&desc, &camera), "camera");
    check(gphys_camera_set_perspective(camera, 0.8f, 0.1f, 400), "perspective");
    check(gphys_camera_set_origin(camera, p->stage.origin), "origin");
    check(gphys_camera_set_orbit(camera, &p->stage.view), "orbit");
    return camera;
}

static double energy(const program* p) {
    gphys_solver_stats stats;
    check(gphys_solver_get_stats(p->stage.solver, 0, &stats), "stats");
    return (double)stats.kinetic_energy + (double)stats.potential_energy;
}

/* Show a preset, with this mesh. A file that is no mesh leaves everything as it is. */
static void show(program* p, uint32_t preset, char* mesh) {
    stage made;
    if (stage_create(&made, preset, mesh) != 0) {
        stage_destroy(&made);
        if (mesh != p->mesh) SDL_free(mesh);
        return;
    }
    stage_destroy(&p->stage);
    if (mesh != p->mesh) SDL_free(p->mesh);
    p->stage = made;
    p->mesh = mesh;
    p->preset = preset;
    canvas_take_mesh(p->canvas, &p->stage.source);
    hand_forget(&p->hand);
    gphys_camera_destroy(p->camera);
    gphys_camera_destroy(p->observed);
    p->observed = NULL;
    p->camera = new_camera(p);
    p->gesture = NOTHING;
    p->first_energy = energy(p);
    say(p, "preset", preset, p->stage.body_count);
}

static void toggle_observed(program* p) {
    if (p->observed) {
        gphys_camera_destroy(p->observed);
        p->observed = NULL;
        return;
    }
    gphys_orbit orbit;
    float width, height;
    p->observed = new_camera(p);
    check(gphys_camera_get_orbit(p->camera, &orbit), "orbit");
    check(gphys_camera_get_viewport(p->camera, &width, &height), "viewport");
    check(gphys_camera_set_viewport(p->observed, width, height), "viewport");
    check(gphys_camera_set_perspective(p->observed, 0.8f, 0.1f, 4 * orbit.distance), "perspective");
    check(gphys_camera_set_orbit(p->observed, &orbit), "orbit");
    orbit.distance *= 2.5f;
    orbit.yaw += 0.9f;
    orbit.pitch = 0.6f;
    check(gphys_camera_set_orbit(p->camera, &orbit), "orbit");
}

static void key(program* p, SDL_Keycode code) {
    if (code >= SDLK_1 && code < SDLK_1 + PRESET_COUNT) show(p, (uint32_t)(code - SDLK_1), p->mesh);
    switch (code) {
        case SDLK_ESCAPE:
            p->quit = 1;
            break;
        case SDLK_SPACE:
            p->paused = !p->paused;
            break;
        case SDLK_PERIOD:
            p->paused = p->step_once = 1;
            break;
        case SDLK_LEFTBRACKET:
            p->speed = fmaxf(p->speed / 2, 1.0f / 16);
            break;
        case SDLK_RIGHTBRACKET:
            p->speed = fminf(p->speed * 2, 4);
            break;
        case SDLK_o:
            p->marks.octree = !p->marks.octree;
            break;
        case SDLK_v:
            toggle_observed(p);
            break;
        case SDLK_r:
            p->recording = !p->recording;
            break;
        case SDLK_h:
            p->helping = !p->helping;
            break;
        default:
            return;
    }
    say(p, "key", code, p->speed);
}

static void press(program* p, const SDL_MouseButtonEvent* event) {
    p->x = event->x, p->y = event->y;
    if (event->button == SDL_BUTTON_RIGHT || event->button == SDL_BUTTON_MIDDLE) {
        p->gesture = PAN;
    } else if (p->shift) {
        p->gesture = MARQUEE;
        for (int i = 0; i < 4; ++i) p->marks.marquee[i] = (float)(i % 2 ? p->y : p->x);
    } else if (hand_grab(&p->hand, &p->stage, p->camera, (float)p->x, (float)p->y)) {
        p->gesture = PULL;
        say(p, "pull", p->hand.body, p->hand.particle);
    } else {
        p->gesture = ORBIT;
    }
}

static void move(program* p, const SDL_MouseMotionEvent* event) {
    p->x = event->x, p->y = event->y;
    if (p->gesture == ORBIT)
        check(gphys_camera_orbit_rotate(p->camera, (float)-event->xrel, (float)event->yrel), "rotate");
    if (p->gesture == PAN) check(gphys_camera_orbit_pan(p->camera, (float)-event->xrel, (float)event->yrel), "pan");
    if (p->gesture == MARQUEE) p->marks.marquee[2] = (float)p->x, p->marks.marquee[3] = (float)p->y;
    if (p->gesture == PULL) hand_drag(&p->hand, &p->stage, p->camera, (float)p->x, (float)p->y);
}

static void release(program* p) {
    if (p->gesture == MARQUEE) {
        hand_select(&p->hand, &p->stage, p->camera, p->marks.marquee);
        say(p, "selected", p->hand.selected_count, 0);
        memset(p->marks.marquee, 0, sizeof p->marks.marquee);
    }
    hand_release(&p->hand, &p->stage);
    p->gesture = NOTHING;
}

static void handle(program* p, const SDL_Event* event) {
    switch (event->type) {
        case SDL_QUIT:
            p->quit = 1;
            break;
        case SDL_KEYDOWN: /* what SDL_GetModState says is later than this event, when frames take long */
            p->shift = (event->key.keysym.mod & KMOD_SHIFT) != 0;
            key(p, event->key.keysym.sym);
            break;
        case SDL_KEYUP:
            p->shift = (event->key.keysym.mod & KMOD_SHIFT) != 0;
            break;
        case SDL_MOUSEBUTTONDOWN:
            press(p, &event->button);
            break;
        case SDL_MOUSEBUTTONUP:
            release(p);
            break;
        case SDL_MOUSEMOTION:
            move(p, &event->motion);
            break;
        case SDL_MOUSEWHEEL: {
            gphys_orbit orbit;
            check(gphys_camera_get_orbit(p->camera, &orbit), "orbit");
            check(gphys_camera_orbit_zoom(p->camera, 10 * orbit.distance * (float)event->wheel.y), "zoom");
            break;
        }
        case SDL_DROPFILE:
            show(p, p->stage.shows_mesh ? p->preset : 0, event->drop.file);
            break;
        default:
            break;
    }
}

static void update(program* p) {
    const double start = seconds();
    if (!p->paused || p->step_once) stage_step(&p->stage, (p->paused ? 1 : p->speed) / 60);
    p->step_once = 0;
    check(gphys_camera_orbit_update(p->camera), "orbit");
    const double stepped = seconds();
    const gphys_model_id before = p->hand.hover.model;
    hand_hover(&p->hand, &p->stage, p->camera, (float)p->x, (float)p->y);
    const double picked = seconds();
    if (p->hand.hover.model != before) say(p, "hover", p->hand.hover.model, p->hand.hover.t);
    gphys_body_id body;
    uint32_t particle;
    p->marks.holds = hand_find(&p->stage, p->camera, (float)p->x, (float)p->y, &body, &particle, &p->marks.held);
    /* Averages over some twenty frames can be read. */
    p->step_ms += 0.05 * (1e3 * (stepped - start) - p->step_ms);
    p->pick_ms += 0.05 * (1e3 * (picked - stepped) - p->pick_ms);
}

static void panel(program* p, int width, int height) {
    const colour ink = {0.95f, 0.96f, 0.98f}, dark = {0.08f, 0.10f, 0.14f};
    gphys_solver_stats stats;
    gphys_octree_stats tree;
    check(gphys_solver_get_stats(p->stage.solver, 0, &stats), "stats");
    check(gphys_scene_get_octree_stats(p->stage.scene, &tree), "octree");
    const double now = (double)stats.kinetic_energy + (double)stats.potential_energy;
    char text[1024], hover[128] = "nothing";
    if (p->hand.hover.model) {
        snprintf(hover, sizeof hover, "model %u at %.4g m (error <= %.1g)", p->hand.hover.model & SLOT_MASK,
                 p->hand.hover.t, 0.5 * (double)(nextafterf(p->hand.hover.t, INFINITY) - p->hand.hover.t));
    }
    snprintf(text, sizeof text,
             "%u  %s%s\n\nstep   %6.2f ms   x%g\ncull   %6.3f ms   %u of %u models\npick   %6.3f ms   %s\n\n"
             "particles %u, links %u, contacts %u\nstrain  max %.3f %%   rms %.4f %%\nenergy  %.1f J, %.1f since the "
             "start\noctree  %u nodes, depth %u",
             p->preset + 1, preset_names[p->preset], p->paused ? "   paused" : "", p->step_ms, p->speed, p->cull_ms,
             p->drawn, tree.item_count + tree.unbounded_count, p->pick_ms, hover, stats.particle_count,
             stats.constraint_count, stats.contact_count, 100 * stats.strain_max, 100 * stats.strain_rms, now,
             now - p->first_energy, tree.node_count, tree.depth);
    const float scale = height >= 700 ? 1.6f : 1.2f;
    float text_width, text_height;
    canvas_size_of_text(text, scale, &text_width, &text_height);
    canvas_shade(p->canvas, width, height, 12, 12, text_width + 16, text_height + 16, dark, 0.72f);
    canvas_text(p->canvas, width, height, 20, 20, scale, ink, text);
    if (p->helping) {
        canvas_shade(p->canvas, width, height, 0, (float)height - 34, (float)width, 34, dark, 0.72f);
        canvas_text(p->canvas, width, height, 12, (float)height - 29, 1.2f, ink, help);
    }
    const float* r = p->marks.marquee;
    if (r[0] != r[2]) {
        canvas_shade(p->canvas, width, height, fminf(r[0], r[2]), fminf(r[1], r[3]), fabsf(r[2] - r[0]),
                     fabsf(r[3] - r[1]), (colour){0.25f, 0.55f, 1.0f}, 0.25f);
    }
}

static void draw(program* p) {
    int width, height;
    SDL_GL_GetDrawableSize(p->window, &width, &height);
    check(gphys_camera_set_viewport(p->camera, (float)width, (float)height), "viewport");
    p->marks.hovered = p->hand.hover.model;
    p->marks.selected = p->hand.selected;
    p->marks.selected_count = p->hand.selected_count;
    p->marks.observed = p->observed;
    double cull = 0;
    p->drawn = canvas_draw(p->canvas, &p->stage, p->camera, width, height, &p->marks, &cull);
    panel(p, width, height);
    if (p->recording) {
        unsigned char* pixels = malloc((size_t)(3 * width * height));
        char path[1024];
        if (!pixels) exit(1);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels);
        snprintf(path, sizeof path, "%s/frame%05u.png", p->directory, p->pictures++);
        stbi_flip_vertically_on_write(1);
        if (!stbi_write_png(path, width, height, 3, pixels, 3 * width)) {
            fprintf(stderr, "window: %s cannot be written; recording ends\n", path);
            p->recording = 0;
        }
        free(pixels);
    }
    SDL_SetWindowTitle(p->window, p->recording ? "gamephys, recording" : "gamephys");
    SDL_GL_SwapWindow(p->window);
    p->cull_ms += 0.05 * (cull - p->cull_ms);
}

static void usage(void) {
    fprintf(stderr,
            "usage: window [MESH] [--preset 1-8] [--size WxH] [--frames N] [--record DIR] [--log]\n"
            "  --frames N    end after N frames\n"
            "  --record DIR  write each frame there as a PNG; R begins and ends it in the window\n"
            "  --log         print what is pointed at, selected and pulled\n");
    exit(2);
}

/* Without a display SDL may draw into memory, where nobody sees it. Whoever sets SDL_VIDEODRIVER wants that. */
static int has_display(void) {
    const char* driver = SDL_GetCurrentVideoDriver();
    return getenv("SDL_VIDEODRIVER") || (strcmp(driver, "offscreen") != 0 && strcmp(driver, "dummy") != 0);
}

int main(int argc, char** argv) {
    static const struct option known[] = {
        {"preset", required_argument, NULL, 'p'}, {"size", required_argument, NULL, 's'},
        {"frames", required_argument, NULL, 'f'}, {"record", required_argument, NULL, 'r'},
        {"log", no_argument, NULL, 'l'},          {NULL, 0, NULL, 0}};
    program p = {.directory = ".", .speed = 1, .helping = 1, .x = -1, .y = -1};
    unsigned preset = 1, frames = 0;
    int width = 1280, height = 800, letter;
    while ((letter = getopt_long(argc, argv, "", known, NULL)) != -1) {
        int good = 1;
        if (letter == 'p')
            good = sscanf(optarg, "%u", &preset) == 1 && preset >= 1 && preset <= PRESET_COUNT;
        else if (letter == 's')
            good = sscanf(optarg, "%dx%d", &width, &height) == 2 && width > 99 && height > 99;
        else if (letter == 'f')
            good = sscanf(optarg, "%u", &frames) == 1;
        else if (letter == 'r')
            p.directory = optarg, p.recording = 1;
        else if (letter == 'l')
            p.log = 1;
        else
            good = 0;
        if (!good) usage();
    }
    if (argc - optind > 1) usage();
    if (argc > optind) p.mesh = SDL_strdup(argv[optind]);

    if (SDL_Init(SDL_INIT_VIDEO) != 0) {
        fprintf(stderr, "window: no window can be opened: %s\n", SDL_GetError());
        return 1;
    }
    if (!has_display()) {
        fprintf(stderr, "window: there is no display; SDL_VIDEODRIVER=offscreen draws without one, for --record\n");
        return 1;
    }
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 24);
    SDL_GL_SetAttribute(SDL_GL_MULTISAMPLEBUFFERS, 1);
    SDL_GL_SetAttribute(SDL_GL_MULTISAMPLESAMPLES, 4);
    p.window = SDL_CreateWindow("gamephys", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width, height,
                                SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE);
    if (!p.window || !SDL_GL_CreateContext(p.window)) {
        fprintf(stderr, "window: OpenGL 3.3 is not available: %s\n", SDL_GetError());
        return 1;
    }
    SDL_GL_SetSwapInterval(1);
    p.canvas = canvas_create();
    show(&p, preset - 1, p.mesh);
    if (p.stage.scene == NULL) return 1; /* load_mesh has said why */
    while (!p.quit && (frames == 0 || p.frame < frames)) {
        SDL_Event event;
        while (SDL_PollEvent(&event)) handle(&p, &event);
        update(&p);
        draw(&p);
        ++p.frame;
    }
    printf("%u frames of %s: %.2f ms a step, %.3f ms a cull, %.3f ms a pick\n", p.frame, preset_names[p.preset],
           p.step_ms, p.cull_ms, p.pick_ms);
    hand_release(&p.hand, &p.stage);
    free(p.hand.selected);
    gphys_camera_destroy(p.camera);
    gphys_camera_destroy(p.observed);
    canvas_destroy(p.canvas);
    stage_destroy(&p.stage);
    SDL_free(p.mesh);
    SDL_Quit();
    return 0;
}
