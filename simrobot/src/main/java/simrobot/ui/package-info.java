/**
 * What the packages of SimRobot's window share: texts, small components, the snapshot that is shown and the user's actions. All
 * that is shown comes from immutable snapshots; all that the user does goes out through {@link
 * simrobot.ui.OperatorActions}. So panels and painters work without a display.
 *
 * <pre>
 *   ui.panel -> ui.floor, ui.editor, ui.replay -> ui
 *   ui.editor -> ui.floor
 * </pre>
 */
package simrobot.ui;
