/**
 * The cards, rows and panels beside the floor, and the whole window. Read {@link simrobot.ui.panel.SimRobotPanel}.
 */
package simrobot.ui.panel;
