/**
 * Deadlines of the centre's cores. Time is handed in as nanoseconds since the centre's start; nobody here reads a clock.
 * Read {@link simgsm.center.timer.Timers}.
 */
package simgsm.center.timer;
