/* What the sketch takes of Arduino's core, so that it is compiled and linked without one. */

#include <stddef.h>
#include <stdint.h>

extern "C" {
inline double sin(double angle) { return angle; }
inline double cos(double angle) { return 1 - angle; }
}

inline void delay(unsigned long) {}

/* A port that nobody reads. */
static struct {
  volatile uint8_t last;
  void begin(unsigned long) {}
  void println(const char *text) { last = static_cast<uint8_t>(text[0]); }
  void write(const uint8_t *bytes, size_t count) {
    for (size_t i = 0; i < count; i++) last = bytes[i];
  }
} Serial;

void setup();
void loop();

/* As a core's `main`. */
extern "C" void reset() {
  setup();
  for (;;) loop();
}
