/**
 * The simulation: robots on one floor in fixed steps of simulated time ({@link simrobot.simulation.Simulation}, read it
 * first), the thread that runs it at a pace ({@link simrobot.simulation.SimulationThread}), and the immutable snapshots that
 * views draw ({@link simrobot.simulation.SimulationSnapshot}). Arrows: simulation -&gt; robot -&gt; world.
 */
package simrobot.simulation;
