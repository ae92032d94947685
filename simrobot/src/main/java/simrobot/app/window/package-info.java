/**
 * Content and actions of SimRobot's window: {@link simrobot.app.window.WindowModel} for a running simulation, {@link
 * simrobot.app.window.ReplayModel} for a recording.
 */
package simrobot.app.window;
