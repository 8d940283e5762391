// A pipe with two flanges and a branch, as packets on the serial port: on a computer, `cargo run --release
// --example view -- --port <PORT>` of scancsg's repository shows them.

#include <ScancsgArduino.h>

#define N(value) SCANCSG_NUMBER(value)

static const uint16_t WIDTH = 160, HEIGHT = 120;
static const uint8_t FORMAT = SCANCSG_FORMAT_GRAY8;

// All the memory that is needed.
static scancsg_scene scene;
static scancsg_picture picture;
static uint8_t row[WIDTH];
static uint8_t packet[SCANCSG_PACKET_CAPACITY(WIDTH)];
static size_t length;
static uint16_t frame;

static scancsg_step cylinder(const scancsg_number (&from)[3], const scancsg_number (&to)[3], scancsg_number radius) {
  scancsg_step step = {};
  step.kind = SCANCSG_KIND_CYLINDER;
  for (int i = 0; i < 3; i++) {
    step.a[i] = from[i];
    step.b[i] = to[i];
  }
  step.r[0] = radius;
  return step;
}

static scancsg_step take(uint8_t kind, uint8_t count) {
  scancsg_step step = {};
  step.kind = kind;
  step.count = count;
  return step;
}

static int32_t build() {
  const scancsg_step steps[] = {
    cylinder({N(-2), 0, 0}, {N(2), 0, 0}, N(1)),
    cylinder({N(-2), 0, 0}, {N(-1.7), 0, 0}, N(1.6)),
    cylinder({N(1.7), 0, 0}, {N(2), 0, 0}, N(1.6)),
    cylinder({0, 0, 0}, {0, N(2), 0}, N(0.8)),
    take(SCANCSG_KIND_UNITE, 4),
    cylinder({N(-3), 0, 0}, {N(3), 0, 0}, N(0.7)),
    cylinder({0, 0, 0}, {0, N(3), 0}, N(0.5)),
    take(SCANCSG_KIND_SUBTRACT, 2),
  };
  return scancsg_scene_from_table(&scene, sizeof scene, steps, sizeof steps / sizeof *steps, NULL, 0, NULL);
}

// The eye goes around the part.
static int32_t look(float angle) {
  scancsg_view view = {};
  view.eye[0] = N(8 * sin(angle));
  view.eye[1] = N(5);
  view.eye[2] = N(8 * cos(angle));
  view.up[1] = N(1);
  view.extent = N(0.5);
  view.to_light[0] = N(0.25);
  view.to_light[1] = N(0.85);
  view.to_light[2] = N(0.45);
  view.ambient = N(0.125);
  view.width = WIDTH;
  view.height = HEIGHT;
  return scancsg_picture_perspective(&picture, sizeof picture, &scene, &view);
}

// Stops, and says why.
static void check(int32_t status) {
  while (status != SCANCSG_STATUS_OK) {
    Serial.println(scancsg_status_text(status));
    delay(1000);
  }
}

void setup() {
  Serial.begin(115200);
  check(build());
}

void loop() {
  uint32_t hash = 0;
  frame++;
  check(look(frame * 0.1f));
  check(scancsg_packet_header(&picture, frame, FORMAT, packet, sizeof packet, &length));
  Serial.write(packet, length);
  for (uint16_t y = 0; y < HEIGHT; y++) {
    check(scancsg_picture_row(&picture, y, FORMAT, row, sizeof row));
    check(scancsg_packet_row(frame, y, FORMAT, row, sizeof row, &hash, packet, sizeof packet, &length));
    Serial.write(packet, length);
  }
  check(scancsg_packet_end(frame, hash, packet, sizeof packet, &length));
  Serial.write(packet, length);
}
