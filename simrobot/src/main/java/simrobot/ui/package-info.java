/**
 * What the packages of SimRobot's window share: texts, small components, the snapshot that is shown and the actions that a
 * user can take. Everything that is shown comes from immutable snapshots; everything that is done goes out through {@link
 * simrobot.ui.SimRobotActions}; so panels and painters work without a display.
 *
 * <pre>
 *   ui.panel -> ui.floor, ui.editor, ui.replay -> ui
 *   ui.editor -> ui.floor
 * </pre>
 */
package simrobot.ui;
