/**
 * The whole window, and the cards, rows and panels around its floor. Read first {@link simrobot.ui.panel.SimRobotPanel}.
 */
package simrobot.ui.panel;
