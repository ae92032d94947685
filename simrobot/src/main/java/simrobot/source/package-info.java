/**
 * Processes from a folder: {@link simrobot.source.BehaviourFolder} keeps the list of processes up to date with the source
 * files and jars in it, {@link simrobot.source.BehaviourCompiler} compiles one file, and
 * {@link simrobot.source.BehaviourThread} runs one process beside the simulation, so that no endless loop stops it.
 */
package simrobot.source;
