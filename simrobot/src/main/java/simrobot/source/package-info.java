/**
 * Processes from a folder: {@link simrobot.source.BehaviourFolder} updates the list of processes from source files and
 * jars, {@link simrobot.source.BehaviourCompiler} compiles one file, and {@link simrobot.source.BehaviourThread} runs
 * one process on a thread of its own, so that no endless loop stops the simulation.
 */
package simrobot.source;
