/* scancsg: ray-cast CSG solids, one scanline at a time. The package scancsg-capi has a README.md.
 *
 * This file is generated: capi/tests/header.rs writes it anew with SCANCSG_BLESS=1.
 *
 * Define what the library was built with: SCANCSG_I16F16, SCANCSG_PARTS_64, SCANCSG_TORUS.
 *
 * All functions take whatever the caller passes, but for pointers: one that isn't null must point to as much as
 * the function says, and nothing else reads or writes that meanwhile. Two arguments don't overlap. All memory is
 * the caller's. The library keeps no state, so threads with different scenes and pictures don't meet. */


#ifndef SCANCSG_H
#define SCANCSG_H

#include <stddef.h>
#include <stdint.h>

/* A number of the library from a constant: SCANCSG_NUMBER(2.5). */
#if defined(SCANCSG_I16F16)
#define SCANCSG_NUMBER(value) ((int32_t)((value) * 65536.0 + ((value) < 0 ? -0.5 : 0.5)))
#else
#define SCANCSG_NUMBER(value) ((float)(value))
#endif

/* The bytes of the longest packet of a frame: scancsg_packet_capacity as a constant, or a few bytes more.
 * bytes_of_row are those of a whole row. */
#define SCANCSG_PACKET_CAPACITY(bytes_of_row) ((bytes_of_row) + (bytes_of_row) / 254 + 256)

// The part has a colour: a bit of `has`.
#define SCANCSG_HAS_COLOR 1

// The part stands in a pose: a bit of `has`.
#define SCANCSG_HAS_POSE 2

#if !defined(SCANCSG_PARTS_64)
// The most parts of a scene.
#define SCANCSG_PARTS 16
#endif

#if defined(SCANCSG_PARTS_64)
// The most parts of a scene.
#define SCANCSG_PARTS 64
#endif

#if !defined(SCANCSG_PARTS_64)
// The most poses of a scene.
#define SCANCSG_POSES 4
#endif

#if defined(SCANCSG_PARTS_64)
// The most poses of a scene.
#define SCANCSG_POSES 16
#endif

#if !(defined(SCANCSG_I16F16) || defined(SCANCSG_TORUS))
// What a picture needs for a part, in words of eight bytes.
#define SCANCSG_PART_WORDS 30
#endif

#if (defined(SCANCSG_I16F16) && !defined(SCANCSG_TORUS))
// What a picture needs for a part, in words of eight bytes.
#define SCANCSG_PART_WORDS 55
#endif

#if (defined(SCANCSG_TORUS) && !defined(SCANCSG_I16F16))
// What a picture needs for a part, in words of eight bytes.
#define SCANCSG_PART_WORDS 42
#endif

#if (defined(SCANCSG_I16F16) && defined(SCANCSG_TORUS))
// What a picture needs for a part, in words of eight bytes.
#define SCANCSG_PART_WORDS 64
#endif

// The size of a scene, in words of eight bytes. It is another one for other options, so that a header that
// doesn't fit the library is found out.
#define SCANCSG_SCENE_WORDS (((SCANCSG_PARTS * 8) + (SCANCSG_POSES * 6)) + SCANCSG_PART_WORDS)

// The size of a picture, in words of eight bytes.
#define SCANCSG_PICTURE_WORDS ((SCANCSG_PARTS * SCANCSG_PART_WORDS) + 48)

// What a function returns: `SCANCSG_STATUS_OK`, or why it did nothing.
//
// Codes stay as they are in later versions, which may have more of them.
enum scancsg_status
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    // It is done.
    SCANCSG_STATUS_OK = 0,
    // A pointer is null.
    SCANCSG_STATUS_NULL = 1,
    // A pointer isn't aligned as its type must be.
    SCANCSG_STATUS_ALIGNMENT = 2,
    // A scene or picture has another size in the header than in the library: they were built with
    // different options.
    SCANCSG_STATUS_STORAGE = 3,
    // The scene isn't built, or the picture isn't made.
    SCANCSG_STATUS_NOT_MADE = 4,
    // The scene has changed since its picture was made: make the picture again.
    SCANCSG_STATUS_CHANGED = 5,
    // A buffer is shorter than what goes into it, or pixels are more or fewer than their bytes.
    SCANCSG_STATUS_LENGTH = 6,
    // No pixel format has this number, or packets can't have it.
    SCANCSG_STATUS_FORMAT = 7,
    // The library has failed in a way that this version has no code for.
    SCANCSG_STATUS_OTHER = 8,
    // A number of a part, pose, view or ray is infinite or not a number.
    SCANCSG_STATUS_NOT_FINITE = 16,
    // A part, a pose, a view or a ray's start is too far away for the number type.
    SCANCSG_STATUS_TOO_FAR = 17,
    // A radius isn't positive, or out of the number type's range.
    SCANCSG_STATUS_RADIUS = 18,
    // A part has no volume: its ends coincide, or its corners are the wrong way round.
    SCANCSG_STATUS_EMPTY = 19,
    // An axis or a normal is zero.
    SCANCSG_STATUS_ZERO_AXIS = 20,
    // The tube of a torus is as wide as its ring, or wider.
    SCANCSG_STATUS_TUBE = 21,
    // A step is of no kind that this build has.
    SCANCSG_STATUS_KIND = 32,
    // A step has bits in `has` that mean nothing.
    SCANCSG_STATUS_HAS = 33,
    // The scene has no room for another part.
    SCANCSG_STATUS_PARTS = 34,
    // The scene has no room for another pose.
    SCANCSG_STATUS_POSES = 35,
    // There are fewer operands than are to be combined, or no part at all.
    SCANCSG_STATUS_OPERANDS = 36,
    // No pose has this index.
    SCANCSG_STATUS_NO_POSE = 37,
    // The bytes are no program.
    SCANCSG_STATUS_MAGIC = 48,
    // The program has another version of the format.
    SCANCSG_STATUS_VERSION = 49,
    // The program has numbers of another type.
    SCANCSG_STATUS_NUMBER_TYPE = 50,
    // The bytes of the program end too early or too late.
    SCANCSG_STATUS_BYTES = 51,
    // The program has an unknown tag.
    SCANCSG_STATUS_TAG = 52,
    // The numbers of a part of the program make no solid of its kind.
    SCANCSG_STATUS_SOLID = 53,
    // The numbers of a pose of the program are no rigid motion.
    SCANCSG_STATUS_MOTION = 54,
    // The program's tree is too large, or an operator has too few operands.
    SCANCSG_STATUS_TREE = 55,
    // The eye lies on the target.
    SCANCSG_STATUS_ZERO_DIRECTION = 64,
    // The camera looks along its up vector, or that vector is zero.
    SCANCSG_STATUS_UP_ALONG_VIEW = 65,
    // The height of the frame isn't positive.
    SCANCSG_STATUS_FRAME_HEIGHT = 66,
    // The field of view isn't between 0 and pi, or too wide.
    SCANCSG_STATUS_FIELD_OF_VIEW = 67,
    // The direction to the light is zero, infinite or not a number.
    SCANCSG_STATUS_LIGHT_DIRECTION = 68,
    // The ambient light isn't between 0 and 1.
    SCANCSG_STATUS_AMBIENT = 69,
    // The width or the height is zero.
    SCANCSG_STATUS_SIZE = 70,
    // A row or a column isn't inside the picture.
    SCANCSG_STATUS_INDEX = 71,
    // The picture shows more of the scene than its number type's range.
    SCANCSG_STATUS_RANGE = 72,
    // The eye is too near to the target for the number type.
    SCANCSG_STATUS_TOO_NEAR = 73,
    // The direction of the ray is zero.
    SCANCSG_STATUS_ZERO_RAY = 80,
    // The direction of the ray is too short or too long for the number type.
    SCANCSG_STATUS_RAY_LENGTH = 81,
    // The ray has more spans in the scene than there is room for.
    SCANCSG_STATUS_SPANS = 82,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum scancsg_status scancsg_status;
#else
typedef int32_t scancsg_status;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// What a step does: push a part, or combine the last `count` operands.
enum scancsg_kind
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint8_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    // A part: from `a` to `b`, the middles of its caps, with radius `r[0]`.
    SCANCSG_KIND_CYLINDER = 1,
    // A part: a box with the lowest corner `a` and the highest corner `b`.
    SCANCSG_KIND_BOX = 2,
    // A part: around `a`, with radius `r[0]`.
    SCANCSG_KIND_SPHERE = 3,
    // A part: from `a`, with radius `r[0]`, to `b`, with radius `r[1]`.
    SCANCSG_KIND_CONE = 4,
    // A part: a ring around `a`. `b` is its axis, `r[0]` the ring's radius, `r[1]` the tube's. Only in a build
    // with the feature `torus`.
    SCANCSG_KIND_TORUS = 5,
    // A part: all points p whose product `a · p` with the normal `a` of length 1 is less than `r[0]`. A normal
    // of another length is made one of length 1.
    SCANCSG_KIND_HALF_SPACE = 6,
    // Takes the last `count` operands for their union.
    SCANCSG_KIND_UNITE = 240,
    // Takes the last `count` operands for what they have in common.
    SCANCSG_KIND_INTERSECT = 241,
    // Cuts the last `count` operands out of the one before them.
    SCANCSG_KIND_SUBTRACT = 242,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum scancsg_kind scancsg_kind;
#else
typedef uint8_t scancsg_kind;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// What the bytes of a row are.
enum scancsg_format
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint8_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    // One byte a pixel: grey.
    SCANCSG_FORMAT_GRAY8 = 0,
    // Two bytes a pixel, the lower one first: five bits of red, six of green, five of blue.
    SCANCSG_FORMAT_RGB565 = 1,
    // Three bytes a pixel: red, green, blue.
    SCANCSG_FORMAT_RGB888 = 2,
    // Eight pixels a byte, the leftmost one in the highest bit: 1 is lit. The last byte is filled up with zeros.
    // Packets can't have it.
    SCANCSG_FORMAT_MONO = 3,
    // As `SCANCSG_FORMAT_RGB565`, the upper byte first: what most displays take.
    SCANCSG_FORMAT_RGB565_BE = 4,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum scancsg_format scancsg_format;
#else
typedef uint8_t scancsg_format;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// The memory of a scene: a variable of this type, or an allocation of its size, is all that a scene needs.
// Its contents are the library's own. It may be moved while no picture of it is
// used.
typedef struct scancsg_scene {
    uint64_t words[SCANCSG_SCENE_WORDS];
} scancsg_scene;

#if !defined(SCANCSG_I16F16)
// A coordinate, a length, an angle in radians: `float`, or 65,536ths as `int32_t`.
typedef float scancsg_number;
#endif

#if defined(SCANCSG_I16F16)
// A coordinate, a length, an angle in radians: `float`, or 65,536ths as `int32_t`.
typedef int32_t scancsg_number;
#endif

// A row of the table. Fields that the kind doesn't name are not looked at.
typedef struct scancsg_step {
    // What it does: a `scancsg_kind`.
    uint8_t kind;
    // How many operands an operator takes.
    uint8_t count;
    // What a part has: `SCANCSG_HAS_COLOR`, `SCANCSG_HAS_POSE`, both or neither.
    uint8_t has;
    // The index of a part's pose.
    uint8_t pose;
    // A part's colour: red, green, blue.
    uint8_t color[3];
    // A point, or a normal.
    scancsg_number a[3];
    // Another point, or an axis.
    scancsg_number b[3];
    // Radii, or an offset.
    scancsg_number r[2];
} scancsg_step;

// Where parts stand: turned about an axis through the origin, then shifted.
typedef struct scancsg_motion {
    // The axis, of any length. It isn't looked at if the angle is 0.
    scancsg_number axis[3];
    // The angle in radians: clockwise for whoever looks along the axis.
    scancsg_number angle;
    // The shift.
    scancsg_number shift[3];
} scancsg_motion;

// The memory of a picture: a variable of this type, or an allocation of its size. It isn't moved while the
// picture is used.
typedef struct scancsg_picture {
    uint64_t words[SCANCSG_PICTURE_WORDS];
} scancsg_picture;

// A camera, a light, and the size of a picture.
typedef struct scancsg_view {
    // The camera looks from here. Without perspective only the direction to the target counts.
    scancsg_number eye[3];
    // The middle of the picture.
    scancsg_number target[3];
    // What points upwards in the picture, of any length.
    scancsg_number up[3];
    // What the picture shows from its upper to its lower edge: units of the scene, or in perspective an
    // angle in radians.
    scancsg_number extent;
    // The direction to the light, of any length.
    scancsg_number to_light[3];
    // The light of what the light doesn't reach: 0 to 1.
    scancsg_number ambient;
    // The number of columns.
    uint16_t width;
    // The number of rows.
    uint16_t height;
    // Where nothing is seen: red, green, blue.
    uint8_t background[3];
    // The bytes up to the structure's size.
    uint8_t reserved;
} scancsg_view;

// What a ray sees.
typedef struct scancsg_hit {
    // The distance from the origin, in lengths of the direction.
    scancsg_number distance;
    // Where.
    scancsg_number point[3];
    // The normal of length 1, on the side that is seen.
    scancsg_number normal[3];
    // The colour of the face: red, green, blue. White if it has none.
    uint8_t color[3];
    // 1 if the ray meets the scene, or 0. All other fields are 0 then.
    uint8_t is_hit;
    // 1 if the ray begins inside, and sees the face from within, or 0.
    uint8_t is_inside;
    // The part whose face it is, counted in the table from 0.
    uint8_t part;
} scancsg_hit;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// What a status means, in English. It is never null, whatever the number.
const char *scancsg_status_text(int32_t status);

// Builds a scene from a table. `size` is `sizeof *scene`. The memory of a scene need not be set before.
// Pictures of what was built there before must be made again, too: rows of old ones are wrong, without a code.
//
// `poses` are what `pose` of a step counts. They may be null if there are none. Operands that nothing combines
// are united.
//
// Unless the status is `SCANCSG_STATUS_OK`, the scene isn't built. The index of the step that failed is then in
// `failed`, if that isn't null: 0 if it was none of them.
//
// # Safety
// `scene` has `size` bytes, `steps` and `poses` as many elements as their counts say.
scancsg_status scancsg_scene_from_table(struct scancsg_scene *scene,
                                        size_t size,
                                        const struct scancsg_step *steps,
                                        size_t step_count,
                                        const struct scancsg_motion *poses,
                                        size_t pose_count,
                                        size_t *failed);

// Builds a scene from the bytes of a program: the repository's `docs/program.md` has their format. `size` is
// `sizeof *scene`.
// Pictures of what was built there before must be made again, too: rows of old ones are wrong, without a code.
//
// Unless the status is `SCANCSG_STATUS_OK`, the scene isn't built.
//
// # Safety
// `scene` has `size` bytes, `bytes` has `length`.
scancsg_status scancsg_scene_from_bytes(struct scancsg_scene *scene,
                                        size_t size,
                                        const uint8_t *bytes,
                                        size_t length);

// Writes a scene as the bytes of a program, and how many they are to `length`.
//
// # Safety
// `scene` is a scene's memory, `bytes` has `capacity` bytes.
scancsg_status scancsg_scene_to_bytes(const struct scancsg_scene *scene,
                                      uint8_t *bytes,
                                      size_t capacity,
                                      size_t *length);

// Moves all parts that stand in a pose. Pictures of the scene must be made again.
//
// # Safety
// `scene` is a scene's memory, `motion` points to one.
scancsg_status scancsg_scene_move(struct scancsg_scene *scene,
                                  uint8_t pose,
                                  const struct scancsg_motion *motion);

// Makes a picture without perspective: all its rays are parallel. `size` is `sizeof *picture`.
//
// The picture refers to the scene, which must stay where it is. When the scene has changed, the picture is to
// be made again. Unless the status is `SCANCSG_STATUS_OK`, the picture isn't made.
//
// # Safety
// `picture` has `size` bytes, `scene` is a scene's memory, `view` points to one.
scancsg_status scancsg_picture_orthographic(struct scancsg_picture *picture,
                                            size_t size,
                                            const struct scancsg_scene *scene,
                                            const struct scancsg_view *view);

// Makes a picture in perspective: its rays come from the eye. Otherwise it is as
// `scancsg_picture_orthographic`.
//
// # Safety
// As there.
scancsg_status scancsg_picture_perspective(struct scancsg_picture *picture,
                                           size_t size,
                                           const struct scancsg_scene *scene,
                                           const struct scancsg_view *view);

// Renders some columns of row `y`, counted from the top: those from `first` on, `count` of them. They have the
// bits that a whole row has there.
//
// `format` is a `scancsg_format`. `bytes` must be just as many as the pixels have, or nothing is written.
//
// # Safety
// `picture` is a picture's memory, `pixels` has so many `bytes`.
scancsg_status scancsg_picture_run(struct scancsg_picture *picture,
                                   uint16_t y,
                                   uint16_t first,
                                   uint16_t count,
                                   uint8_t format,
                                   uint8_t *pixels,
                                   size_t bytes);

// Renders row `y`, counted from the top. Rows may be rendered in any order, and again.
//
// `format` is a `scancsg_format`. `bytes` must be just as many as a row has, or nothing is written.
//
// # Safety
// As `scancsg_picture_run`.
scancsg_status scancsg_picture_row(struct scancsg_picture *picture,
                                   uint16_t y,
                                   uint8_t format,
                                   uint8_t *pixels,
                                   size_t bytes);

// Looks along a ray for the first surface of the scene, and writes what it sees to `hit`. A miss is
// `SCANCSG_STATUS_OK`, too.
//
// # Safety
// `scene` is a scene's memory. `origin` and `direction` have three numbers each, and `hit` is room for one.
scancsg_status scancsg_scene_ray(const struct scancsg_scene *scene,
                                 const scancsg_number *origin,
                                 const scancsg_number *direction,
                                 struct scancsg_hit *hit);

// The bytes that any packet of a frame with so wide rows needs, or 0 for a format that packets can't have.
// `SCANCSG_PACKET_CAPACITY` is the same, or more, for constants.
size_t scancsg_packet_capacity(uint16_t width,
                               uint8_t format);

// Writes the packet that a frame begins with, and its length to `length`. `frame` is a number that differs
// from the last frame's.
//
// # Safety
// `picture` is a picture's memory, `packet` has `capacity` bytes.
scancsg_status scancsg_packet_header(const struct scancsg_picture *picture,
                                     uint16_t frame,
                                     uint8_t format,
                                     uint8_t *packet,
                                     size_t capacity,
                                     size_t *length);

// Writes the packet of row `y`, and its length to `length`. The row's hash is added to `hash`, which is 0 at a
// frame's beginning. Add each row once.
//
// `pixels` are `bytes` of a whole row, as `scancsg_picture_row` has rendered it.
//
// # Safety
// `pixels` has `bytes`, `packet` has `capacity` bytes.
scancsg_status scancsg_packet_row(uint16_t frame,
                                  uint16_t y,
                                  uint8_t format,
                                  const uint8_t *pixels,
                                  size_t bytes,
                                  uint32_t *hash,
                                  uint8_t *packet,
                                  size_t capacity,
                                  size_t *length);

// Writes the packet that a frame ends with, and its length to `length`. `hash` is the sum of the rows' hashes.
//
// # Safety
// `packet` has `capacity` bytes.
scancsg_status scancsg_packet_end(uint16_t frame,
                                  uint32_t hash,
                                  uint8_t *packet,
                                  size_t capacity,
                                  size_t *length);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* SCANCSG_H */
