/**
 * SimRobot's wiring: the robots, ports, recordings and views that a command line asks for. Read first {@link
 * simrobot.SimRobotMain}, then {@link simrobot.app.WindowModel}, {@link simrobot.app.BatchRun} or {@link
 * simrobot.app.HeadlessReplay}, one for each way to run.
 */
package simrobot.app;
