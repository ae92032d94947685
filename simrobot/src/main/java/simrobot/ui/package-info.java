/**
 * SimRobot's window. Read first {@link simrobot.ui.SimRobotPanel}, which is the whole window without its frame, then
 * {@link simrobot.ui.WorldPainter}. Everything that is shown comes from immutable snapshots, everything that is done goes
 * out through {@link simrobot.ui.Operator}; so panels and painters work without a display.
 *
 * <pre>
 *   SimRobotWindow - SimRobotPanel - WorldView, Inspector, ModemPanel, VeriCommandPanel
 *                                                |
 *                                  WorldPainter - FloorPainter, RobotPainter
 * </pre>
 */
package simrobot.ui;
