/* What C may do wrong has a code: null, sizes, nonsense. And what it does right is done. */

#include "scancsg.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define N(value) SCANCSG_NUMBER(value)

static int failures = 0;

#define IS(got, want)                                                                     \
    do {                                                                                  \
        long is = (long)(got), must = (long)(want);                                       \
        if (is != must) {                                                                 \
            printf("line %d: %s is %ld, not %ld\n", __LINE__, #got, is, must);            \
            failures++;                                                                   \
        }                                                                                 \
    } while (0)

static const scancsg_step BALL[] = {
    {.kind = SCANCSG_KIND_SPHERE, .r = {N(1)}, .has = SCANCSG_HAS_COLOR, .color = {255, 0, 0}},
};

static const scancsg_view VIEW = {
    .eye = {0, 0, N(5)},
    .up = {0, N(1)},
    .extent = N(3),
    .to_light = {0, 0, N(1)},
    .ambient = N(0.25),
    .width = 37,
    .height = 20,
    .background = {0, 0, 64},
};

/* In memory of its own, so that a byte too much is seen. */
static void *room(size_t size) {
    void *bytes = malloc(size);
    if (bytes == NULL) {
        exit(2);
    }
    memset(bytes, 0xA5, size);
    return bytes;
}

static scancsg_status built(scancsg_scene *scene, const scancsg_step *steps, size_t count, size_t *failed) {
    return scancsg_scene_from_table(scene, sizeof *scene, steps, count, NULL, 0, failed);
}

static void tables(void) {
    scancsg_scene *scene = room(sizeof *scene);
    size_t failed = 77;
    scancsg_step steps[SCANCSG_PARTS + 2];
    size_t i;

    IS(built(NULL, BALL, 1, &failed), SCANCSG_STATUS_NULL);
    IS(built(scene, NULL, 1, NULL), SCANCSG_STATUS_NULL);
    IS(built(scene, NULL, 0, NULL), SCANCSG_STATUS_OPERANDS);
    IS(built(scene, BALL, (size_t)-1, NULL), SCANCSG_STATUS_LENGTH);
    IS(scancsg_scene_from_table(scene, 0, BALL, 1, NULL, 0, NULL), SCANCSG_STATUS_STORAGE);
    IS(scancsg_scene_from_table(scene, sizeof *scene, BALL, 1, NULL, 1, NULL), SCANCSG_STATUS_NULL);
    IS(scancsg_scene_from_table((void *)((char *)scene + 1), sizeof *scene, BALL, 1, NULL, 0, NULL),
       SCANCSG_STATUS_ALIGNMENT);

    for (i = 0; i < SCANCSG_PARTS + 2; i++) {
        steps[i] = BALL[0];
    }
    IS(built(scene, steps, SCANCSG_PARTS, &failed), SCANCSG_STATUS_OK);
    IS(built(scene, steps, SCANCSG_PARTS + 1, &failed), SCANCSG_STATUS_PARTS);
    IS(failed, SCANCSG_PARTS);
    steps[1].kind = 99;
    IS(built(scene, steps, 2, &failed), SCANCSG_STATUS_KIND);
    IS(failed, 1);
    steps[1].kind = SCANCSG_KIND_SUBTRACT;
    IS(built(scene, steps, 2, &failed), SCANCSG_STATUS_OPERANDS);
    IS(built(scene, steps + 1, 1, &failed), SCANCSG_STATUS_OPERANDS);
    IS(failed, 0);
    steps[1] = BALL[0];
    steps[1].r[0] = N(-1);
    IS(built(scene, steps, 2, &failed), SCANCSG_STATUS_RADIUS);
    steps[1] = BALL[0];
    steps[1].has = 128;
    IS(built(scene, steps, 2, &failed), SCANCSG_STATUS_HAS);
    steps[1].has = SCANCSG_HAS_POSE;
    IS(built(scene, steps, 2, &failed), SCANCSG_STATUS_NO_POSE);
    /* What has failed is no scene. */
    IS(scancsg_scene_to_bytes(scene, NULL, 0, &failed), SCANCSG_STATUS_NOT_MADE);
    free(scene);
}

static void programs(void) {
    scancsg_scene *scene = room(sizeof *scene), *other = room(sizeof *other);
    uint8_t bytes[64], again[64];
    size_t length = 0, other_length = 0, i;
    IS(built(scene, BALL, 1, NULL), SCANCSG_STATUS_OK);
    IS(scancsg_scene_to_bytes(scene, bytes, sizeof bytes, &length), SCANCSG_STATUS_OK);
    IS(length, 8 + 2 + 3 + 16);
    IS(scancsg_scene_to_bytes(scene, bytes, length - 1, &length), SCANCSG_STATUS_LENGTH);
    IS(scancsg_scene_to_bytes(scene, NULL, 5, &length), SCANCSG_STATUS_NULL);
    IS(scancsg_scene_to_bytes(scene, bytes, sizeof bytes, NULL), SCANCSG_STATUS_NULL);
    IS(scancsg_scene_from_bytes(other, sizeof *other, bytes, length), SCANCSG_STATUS_OK);
    IS(scancsg_scene_to_bytes(other, again, sizeof again, &other_length), SCANCSG_STATUS_OK);
    IS(length == other_length && memcmp(bytes, again, length) == 0, 1);
    for (i = 0; i < length; i++) {
        IS(scancsg_scene_from_bytes(other, sizeof *other, bytes, i), SCANCSG_STATUS_BYTES);
    }
    bytes[0] ^= 1;
    IS(scancsg_scene_from_bytes(other, sizeof *other, bytes, length), SCANCSG_STATUS_MAGIC);
    IS(scancsg_scene_from_bytes(other, sizeof *other, NULL, length), SCANCSG_STATUS_NULL);
    IS(scancsg_scene_from_bytes(NULL, sizeof *other, bytes, length), SCANCSG_STATUS_NULL);
    free(scene);
    free(other);
}

static void pictures(void) {
    scancsg_scene *scene = room(sizeof *scene);
    scancsg_picture *picture = room(sizeof *picture);
    scancsg_view view = VIEW;
    uint8_t *row = room(37), *part = room(9), *bits = room(5), *colors = room(3 * 37);
    size_t y;

    IS(scancsg_picture_orthographic(picture, sizeof *picture, scene, &view), SCANCSG_STATUS_NOT_MADE);
    IS(built(scene, BALL, 1, NULL), SCANCSG_STATUS_OK);
    IS(scancsg_picture_row(picture, 0, SCANCSG_FORMAT_GRAY8, row, 37), SCANCSG_STATUS_NOT_MADE);
    IS(scancsg_picture_orthographic(NULL, sizeof *picture, scene, &view), SCANCSG_STATUS_NULL);
    IS(scancsg_picture_orthographic(picture, 8, scene, &view), SCANCSG_STATUS_STORAGE);
    IS(scancsg_picture_orthographic(picture, sizeof *picture, NULL, &view), SCANCSG_STATUS_NULL);
    IS(scancsg_picture_orthographic(picture, sizeof *picture, scene, NULL), SCANCSG_STATUS_NULL);
    view.width = 0;
    IS(scancsg_picture_orthographic(picture, sizeof *picture, scene, &view), SCANCSG_STATUS_SIZE);
    view = VIEW;
    view.up[1] = 0;
    IS(scancsg_picture_orthographic(picture, sizeof *picture, scene, &view), SCANCSG_STATUS_UP_ALONG_VIEW);
    view = VIEW;
    view.eye[2] = 0;
    IS(scancsg_picture_perspective(picture, sizeof *picture, scene, &view), SCANCSG_STATUS_ZERO_DIRECTION);
    view = VIEW;
    view.extent = N(3.5);
    IS(scancsg_picture_perspective(picture, sizeof *picture, scene, &view), SCANCSG_STATUS_FIELD_OF_VIEW);
    view.extent = 0;
    IS(scancsg_picture_orthographic(picture, sizeof *picture, scene, &view), SCANCSG_STATUS_FRAME_HEIGHT);
    view = VIEW;
    view.ambient = N(2);
    IS(scancsg_picture_orthographic(picture, sizeof *picture, scene, &view), SCANCSG_STATUS_AMBIENT);
    IS(scancsg_picture_row(picture, 0, SCANCSG_FORMAT_GRAY8, row, 37), SCANCSG_STATUS_NOT_MADE);

    IS(scancsg_picture_orthographic(picture, sizeof *picture, scene, &VIEW), SCANCSG_STATUS_OK);
    IS(scancsg_picture_row(NULL, 0, SCANCSG_FORMAT_GRAY8, row, 37), SCANCSG_STATUS_NULL);
    IS(scancsg_picture_row(picture, 0, SCANCSG_FORMAT_GRAY8, NULL, 37), SCANCSG_STATUS_NULL);
    IS(scancsg_picture_row(picture, 0, SCANCSG_FORMAT_GRAY8, row, 36), SCANCSG_STATUS_LENGTH);
    IS(scancsg_picture_row(picture, 0, SCANCSG_FORMAT_GRAY8, row, 38), SCANCSG_STATUS_LENGTH);
    IS(scancsg_picture_row(picture, 0, 5, row, 37), SCANCSG_STATUS_FORMAT);
    IS(scancsg_picture_row(picture, 20, SCANCSG_FORMAT_GRAY8, row, 37), SCANCSG_STATUS_INDEX);
    IS(scancsg_picture_run(picture, 0, 30, 8, SCANCSG_FORMAT_GRAY8, row, 8), SCANCSG_STATUS_INDEX);
    IS(scancsg_picture_run(picture, 0, 65535, 65535, SCANCSG_FORMAT_GRAY8, row, 8), SCANCSG_STATUS_INDEX);
    IS(scancsg_picture_run(picture, 0, 37, 0, SCANCSG_FORMAT_GRAY8, NULL, 0), SCANCSG_STATUS_OK);
    IS(row[0], 0xA5);

    for (y = 0; y < 20; y++) {
        size_t x;
        uint16_t line = (uint16_t)y;
        IS(scancsg_picture_row(picture, line, SCANCSG_FORMAT_GRAY8, row, 37), SCANCSG_STATUS_OK);
        IS(scancsg_picture_row(picture, line, SCANCSG_FORMAT_RGB888, colors, 3 * 37), SCANCSG_STATUS_OK);
        IS(scancsg_picture_row(picture, line, SCANCSG_FORMAT_MONO, bits, 5), SCANCSG_STATUS_OK);
        IS(scancsg_picture_run(picture, line, 14, 9, SCANCSG_FORMAT_GRAY8, part, 9), SCANCSG_STATUS_OK);
        IS(memcmp(row + 14, part, 9), 0);
        IS(bits[4] & 7, 0);
        for (x = 0; x < 37; x++) {
            const uint8_t *pixel = colors + 3 * x;
            IS(pixel[1], 0);
            IS(pixel[0] == 0 ? pixel[2] : 64 + pixel[2], 64);
            IS(bits[x / 8] >> (7 - x % 8) & 1, row[x] >= 128);
        }
    }
    IS(scancsg_picture_row(picture, 10, SCANCSG_FORMAT_RGB888, colors, 3 * 37), SCANCSG_STATUS_OK);
    IS(colors[3 * 18] > 250, 1);
    free(scene);
    free(picture);
    free(row);
    free(part);
    free(bits);
    free(colors);
}

/* A part in a pose moves with it, and a picture of before is refused. */
static void poses(void) {
    static const scancsg_step POSED[] = {
        {.kind = SCANCSG_KIND_CYLINDER, .a = {0, 0, N(-1)}, .b = {0, 0, N(1)}, .r = {N(0.5)},
         .has = SCANCSG_HAS_POSE, .pose = 0},
    };
    static const scancsg_motion THERE = {.shift = {N(3)}};
    static const scancsg_motion TURNED = {.axis = {0, N(2)}, .angle = N(1.5707963), .shift = {0, N(1)}};
    static const scancsg_motion NOWHERE = {.angle = N(1)};
    const scancsg_number from[3] = {N(3), 0, N(9)}, from_side[3] = {N(5), N(1), 0};
    const scancsg_number down[3] = {0, 0, N(-1)}, left[3] = {N(-1), 0, 0}, none[3] = {0, 0, 0};
    scancsg_scene *scene = room(sizeof *scene);
    scancsg_picture *picture = room(sizeof *picture);
    scancsg_hit hit;
    uint8_t row[37];

    IS(scancsg_scene_ray(scene, from, down, &hit), SCANCSG_STATUS_NOT_MADE);
    IS(scancsg_scene_from_table(scene, sizeof *scene, POSED, 1, &THERE, 1, NULL), SCANCSG_STATUS_OK);
    IS(scancsg_scene_from_table(scene, sizeof *scene, POSED, 1, &NOWHERE, 1, NULL), SCANCSG_STATUS_ZERO_AXIS);
    IS(scancsg_scene_from_table(scene, sizeof *scene, POSED, 1, &THERE, 1, NULL), SCANCSG_STATUS_OK);
    IS(scancsg_scene_ray(scene, from, down, &hit), SCANCSG_STATUS_OK);
    IS(hit.is_hit, 1);
    IS(hit.distance == N(8), 1);
    IS(hit.point[0] == N(3) && hit.point[2] == N(1), 1);
    IS(hit.normal[2] == N(1), 1);
    IS(hit.part, 0);
    IS(hit.color[0], 255);
    IS(scancsg_scene_ray(scene, from, none, &hit), SCANCSG_STATUS_ZERO_RAY);
    IS(scancsg_scene_ray(scene, NULL, down, &hit), SCANCSG_STATUS_NULL);
    IS(scancsg_scene_ray(scene, from, NULL, &hit), SCANCSG_STATUS_NULL);
    IS(scancsg_scene_ray(scene, from, down, NULL), SCANCSG_STATUS_NULL);
    IS(scancsg_scene_ray(NULL, from, down, &hit), SCANCSG_STATUS_NULL);

    IS(scancsg_picture_perspective(picture, sizeof *picture, scene, &(scancsg_view){
        .eye = {0, 0, N(9)}, .up = {0, N(1)}, .extent = N(0.5), .to_light = {0, 0, N(1)}, .width = 37, .height = 9,
    }), SCANCSG_STATUS_OK);
    IS(scancsg_picture_row(picture, 4, SCANCSG_FORMAT_GRAY8, row, 37), SCANCSG_STATUS_OK);
    IS(scancsg_scene_move(scene, 1, &TURNED), SCANCSG_STATUS_NO_POSE);
    IS(scancsg_picture_row(picture, 4, SCANCSG_FORMAT_GRAY8, row, 37), SCANCSG_STATUS_OK);
    IS(scancsg_scene_move(scene, 0, &TURNED), SCANCSG_STATUS_OK);
    IS(scancsg_picture_row(picture, 4, SCANCSG_FORMAT_GRAY8, row, 37), SCANCSG_STATUS_CHANGED);
    IS(scancsg_scene_ray(scene, from, down, &hit), SCANCSG_STATUS_OK);
    IS(hit.is_hit, 0);
    IS(scancsg_scene_ray(scene, from_side, left, &hit), SCANCSG_STATUS_OK);
    IS(hit.is_hit, 1);
    IS(hit.distance > N(3.999) && hit.distance < N(4.001), 1);
    free(scene);
    free(picture);
}

static void packets(void) {
    scancsg_scene *scene = room(sizeof *scene);
    scancsg_picture *picture = room(sizeof *picture);
    uint8_t *row = room(2 * 37), *packet = room(SCANCSG_PACKET_CAPACITY(2 * 37));
    size_t capacity = SCANCSG_PACKET_CAPACITY(2 * 37), length = 5;
    uint32_t hash = 0, other = 0;
    IS(built(scene, BALL, 1, NULL), SCANCSG_STATUS_OK);
    IS(scancsg_packet_header(picture, 1, SCANCSG_FORMAT_RGB565, packet, capacity, &length), SCANCSG_STATUS_NOT_MADE);
    IS(scancsg_picture_orthographic(picture, sizeof *picture, scene, &VIEW), SCANCSG_STATUS_OK);
    IS(scancsg_packet_capacity(37, SCANCSG_FORMAT_RGB565) <= capacity, 1);
    IS(scancsg_packet_capacity(37, SCANCSG_FORMAT_MONO), 0);
    IS(scancsg_packet_capacity(65535, SCANCSG_FORMAT_RGB888) <= SCANCSG_PACKET_CAPACITY(3ul * 65535), 1);
    IS(scancsg_packet_header(picture, 1, SCANCSG_FORMAT_RGB565, packet, capacity, &length), SCANCSG_STATUS_OK);
    IS(length > 10, 1);
    IS(scancsg_packet_header(picture, 1, SCANCSG_FORMAT_MONO, packet, capacity, &length), SCANCSG_STATUS_FORMAT);
    IS(scancsg_packet_header(picture, 1, SCANCSG_FORMAT_RGB565, packet, 3, &length), SCANCSG_STATUS_LENGTH);
    IS(scancsg_packet_header(picture, 1, SCANCSG_FORMAT_RGB565, NULL, capacity, &length), SCANCSG_STATUS_NULL);
    IS(scancsg_packet_header(picture, 1, SCANCSG_FORMAT_RGB565, packet, capacity, NULL), SCANCSG_STATUS_NULL);
    IS(scancsg_picture_row(picture, 9, SCANCSG_FORMAT_RGB565, row, 2 * 37), SCANCSG_STATUS_OK);
    IS(scancsg_packet_row(1, 9, SCANCSG_FORMAT_RGB565, row, 2 * 37, &hash, packet, capacity, &length), SCANCSG_STATUS_OK);
    IS(hash != 0 && length > 10, 1);
    IS(scancsg_packet_row(1, 9, SCANCSG_FORMAT_RGB565, row, 2 * 37, NULL, packet, capacity, &length), SCANCSG_STATUS_NULL);
    IS(scancsg_packet_row(1, 9, SCANCSG_FORMAT_RGB565, row, 73, &other, packet, capacity, &length), SCANCSG_STATUS_LENGTH);
    IS(scancsg_packet_row(1, 9, SCANCSG_FORMAT_RGB565, row, 0, &other, packet, capacity, &length), SCANCSG_STATUS_LENGTH);
    IS(scancsg_packet_row(1, 9, SCANCSG_FORMAT_RGB565, row, 74, &other, packet, 12, &length), SCANCSG_STATUS_LENGTH);
    IS(other, 0);
    /* The same pixels the other way round are the same packet's. */
    IS(scancsg_picture_row(picture, 9, SCANCSG_FORMAT_RGB565_BE, row, 2 * 37), SCANCSG_STATUS_OK);
    IS(scancsg_packet_row(1, 9, SCANCSG_FORMAT_RGB565_BE, row, 74, &other, packet, capacity, &length), SCANCSG_STATUS_OK);
    IS(hash == other, 1);
    IS(scancsg_packet_end(1, hash, packet, capacity, &length), SCANCSG_STATUS_OK);
    IS(scancsg_packet_end(1, hash, packet, 2, &length), SCANCSG_STATUS_LENGTH);
    free(scene);
    free(picture);
    free(row);
    free(packet);
}

int main(void) {
    int status;
    tables();
    programs();
    pictures();
    poses();
    packets();
    for (status = -2; status < 300; status++) {
        IS(scancsg_status_text(status) != NULL && strlen(scancsg_status_text(status)) > 9, 1);
    }
    printf("%d failures at the border\n", failures);
    return failures != 0;
}
