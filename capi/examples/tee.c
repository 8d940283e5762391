/* Renders a pipe with two flanges, a branch, and holes, with both cameras, and says each row's CRC-32: line by line
 * what tests/golden has of the same part. On a computer:
 *
 *     cc -std=c99 -Icapi/include capi/examples/tee.c libscancsg_capi.a -o tee
 *
 * A board gives `say` and `main` itself: see board.c. */

#include "scancsg.h"

#define N(value) SCANCSG_NUMBER(value)
#define WIDTH 160
#define HEIGHT 120

void say(const char *text);
int tee(void);

/* Parts and operators in postfix order: the body, united, less the bores. */
static const scancsg_step STEPS[] = {
    {.kind = SCANCSG_KIND_CYLINDER, .a = {N(-2)}, .b = {N(2)}, .r = {N(1)}},
    {.kind = SCANCSG_KIND_CYLINDER, .a = {N(-2)}, .b = {N(-1.7)}, .r = {N(1.6)}},
    {.kind = SCANCSG_KIND_CYLINDER, .a = {N(1.7)}, .b = {N(2)}, .r = {N(1.6)}},
    {.kind = SCANCSG_KIND_CYLINDER, .b = {0, N(2)}, .r = {N(0.8)}},
    {.kind = SCANCSG_KIND_UNITE, .count = 4},
    {.kind = SCANCSG_KIND_CYLINDER, .a = {N(-3)}, .b = {N(3)}, .r = {N(0.7)}},
    {.kind = SCANCSG_KIND_CYLINDER, .b = {0, N(3)}, .r = {N(0.5)}},
    {.kind = SCANCSG_KIND_CYLINDER, .a = {N(-3), N(1.3)}, .b = {N(3), N(1.3)}, .r = {N(0.15)}},
    {.kind = SCANCSG_KIND_CYLINDER, .a = {N(-3), N(-1.3)}, .b = {N(3), N(-1.3)}, .r = {N(0.15)}},
    {.kind = SCANCSG_KIND_CYLINDER, .a = {N(-3), 0, N(1.3)}, .b = {N(3), 0, N(1.3)}, .r = {N(0.15)}},
    {.kind = SCANCSG_KIND_CYLINDER, .a = {N(-3), 0, N(-1.3)}, .b = {N(3), 0, N(-1.3)}, .r = {N(0.15)}},
    {.kind = SCANCSG_KIND_SUBTRACT, .count = 6},
};

/* All the memory that is needed. */
static scancsg_scene scene;
static scancsg_picture picture;
static uint8_t row[WIDTH];

/* What tests/golden has of each row: its number and the CRC-32 of its bytes. */
static void say_row(unsigned y) {
    static const char DIGITS[] = "0123456789abcdef";
    char line[] = "  0 00000000\n";
    uint32_t crc = 0xFFFFFFFFu;
    int i, bit;
    for (i = 0; i < WIDTH; i++) {
        crc ^= row[i];
        for (bit = 0; bit < 8; bit++) {
            crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xEDB88320u : 0u);
        }
    }
    crc = ~crc;
    for (i = 0; i < 8; i++) {
        line[11 - i] = DIGITS[(crc >> (4 * i)) & 15u];
    }
    for (i = 2; i >= 0 && (y > 0 || i == 2); i--) {
        line[i] = DIGITS[y % 10u];
        y /= 10u;
    }
    say(line);
}

static scancsg_status say_rows(void) {
    unsigned y;
    for (y = 0; y < HEIGHT; y++) {
        scancsg_status status = scancsg_picture_row(&picture, (uint16_t)y, SCANCSG_FORMAT_GRAY8, row, sizeof row);
        if (status != SCANCSG_STATUS_OK) {
            return status;
        }
        say_row(y);
    }
    return SCANCSG_STATUS_OK;
}

static scancsg_status both_pictures(void) {
    scancsg_view view = {
        .eye = {N(0.51961524), N(0.5), N(0.69282032)},
        .up = {0, N(1)},
        .extent = N(4.4), /* units from the upper to the lower edge */
        .to_light = {N(0.25), N(0.85), N(0.45)},
        .ambient = N(0.125),
        .width = WIDTH,
        .height = HEIGHT,
    };
    int i;
    scancsg_status status = scancsg_scene_from_table(
        &scene, sizeof scene, STEPS, sizeof STEPS / sizeof *STEPS, NULL, 0, NULL);
    if (status == SCANCSG_STATUS_OK) {
        status = scancsg_picture_orthographic(&picture, sizeof picture, &scene, &view);
    }
    if (status == SCANCSG_STATUS_OK) {
        status = say_rows();
    }
    for (i = 0; i < 3; i++) {
        view.eye[i] *= 10;
    }
    view.extent = N(0.4899573); /* radians */
    if (status == SCANCSG_STATUS_OK) {
        status = scancsg_picture_perspective(&picture, sizeof picture, &scene, &view);
    }
    return status == SCANCSG_STATUS_OK ? say_rows() : status;
}

/* 0 if all went well. */
int tee(void) {
    scancsg_status status = both_pictures();
    if (status != SCANCSG_STATUS_OK) {
        say(scancsg_status_text(status));
        say("\n");
    }
    return status != SCANCSG_STATUS_OK;
}

#if __STDC_HOSTED__
#include <stdio.h>

void say(const char *text) {
    fputs(text, stdout);
}

int main(void) {
    return tee();
}
#endif
