/**
 * Timers of the cores. The driver hands the time in, as nanoseconds since the start.
 * Read {@link simgsm.timer.Timers}.
 */
package simgsm.timer;
