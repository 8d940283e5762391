/* A Cortex-M without an operating system: start-up, and `say` through a debugger's semihosting. Links with tee.c,
 * with board.ld, and with no library of C's. */

#include <stdint.h>

void say(const char *text);
int tee(void);
void reset(void);

/* Of the linker: no variables, but where they are. */
extern uint32_t _stack[], _data[], _data_end[], _bss[], _bss_end[];
extern const uint32_t _data_load[];

/* What the debugger, or an emulator, does for the board. */
static uint32_t ask(uint32_t operation, uint32_t argument) {
    register uint32_t r0 __asm__("r0") = operation;
    register uint32_t r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

/* SYS_WRITE0. */
void say(const char *text) {
    ask(0x04, (uint32_t)text);
}

/* SYS_EXIT: ADP_Stopped_ApplicationExit, or ADP_Stopped_InternalError. */
static void finish(int status) {
    ask(0x18, status == 0 ? 0x20026u : 0x20024u);
    for (;;) {
    }
}

/* What the stack has not reached still has this pattern. */
#define UNTOUCHED 0x5AC0FFEEu

static void say_stack(void) {
    static const char DIGITS[] = "0123456789";
    char text[] = "stack          \n";
    const volatile uint32_t *at = _bss_end;
    uint32_t used;
    int i;
    while (*at == UNTOUCHED) {
        at++;
    }
    used = (uint32_t)((uintptr_t)_stack - (uintptr_t)at);
    for (i = 14; i > 5 && (used > 0 || i == 14); i--) {
        text[i] = DIGITS[used % 10u];
        used /= 10u;
    }
    say(text);
}

static void start(void) __attribute__((noinline));
static void start(void) {
    int status = tee();
    say_stack();
    finish(status);
}

void reset(void) {
    const uint32_t *from = _data_load;
    volatile uint32_t *to;
    uint32_t here;
#if defined(__ARM_FP)
    /* CPACR: the floating-point unit is on. */
    *(volatile uint32_t *)0xE000ED88u |= 0xFu << 20;
    __asm__ volatile("dsb\n isb");
#endif
    for (to = _data; to < _data_end; to++) {
        *to = *from++;
    }
    for (to = _bss; to < _bss_end; to++) {
        *to = 0;
    }
    __asm__ volatile("mov %0, sp" : "=r"(here));
    for (to = _bss_end; (uintptr_t)to < here; to++) {
        *to = UNTOUCHED;
    }
    start();
}

static void fault(void) {
    say("a fault\n");
    finish(1);
}

typedef void (*handler)(void);

/* Stack, reset, and what the core itself may raise. */
__attribute__((section(".vectors"), used)) static const struct {
    uint32_t *stack;
    handler handlers[15];
} VECTORS = {_stack, {reset, fault, fault, fault, fault, fault}};
