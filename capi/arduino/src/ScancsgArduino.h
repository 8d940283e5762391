/* scancsg for Arduino. The libraries beside this file compute in float where the core does, and in fixed point where
 * it does not. */

#ifndef SCANCSG_ARDUINO_H
#define SCANCSG_ARDUINO_H

#if !defined(__ARM_FP)
#define SCANCSG_I16F16
#endif

#include "scancsg.h"

#endif
