/**
 * Load for a centre: many stations in one process that attach, write to each other and talk, and what was measured
 * meanwhile.
 *
 * <p>Read first: {@link simgsm.tools.load.LoadRun}.
 */
package simgsm.tools.load;
