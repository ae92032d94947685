/**
 * What a command line asks for, beside the ways to run: the options, robots, processes, recordings and the world's file. Read
 * first {@link simrobot.SimRobotMain}.
 */
package simrobot.app;
