/**
 * Load for a centre: many stations in one process that attach, send short messages and hold calls, and the measurements.
 *
 * <p>Read first: {@link simgsm.tools.load.LoadGenerator}.
 */
package simgsm.tools.load;
