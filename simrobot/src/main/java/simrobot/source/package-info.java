/**
 * Processes from a folder: {@link simrobot.source.BehaviourFolder} updates the list of processes from source files and
 * jars, {@link simrobot.source.BehaviourCompiler} compiles one file, and {@link simrobot.source.BehaviourChild} executes it
 * in a process of the operating system.
 */
package simrobot.source;
