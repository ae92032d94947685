/**
 * Timers of the cores, to which the driver hands the time, as nanoseconds since the start; limits of rates and of memory.
 * Read {@link simgsm.timer.Timers}.
 */
package simgsm.timer;
