/**
 * The contents of a command line, apart from the ways to run: options, robots, processes, recordings and the world's
 * file. Read first {@link simrobot.SimRobotMain}.
 */
package simrobot.app;
