/**
 * What SimRobot's window shows and does: {@link simrobot.app.window.WindowModel} of a running simulation, {@link
 * simrobot.app.window.ReplayModel} of a recording.
 */
package simrobot.app.window;
