/**
 * Deadlines of the program's cores. Time is handed in as nanoseconds since the program's start; nobody here reads a clock.
 * Read {@link simgsm.timer.Timers}.
 */
package simgsm.timer;
