/**
 * The parts of a window's content: dividers moved by mouse and keyboard ({@link simgsm.ui.pane.DividedPanel}), and
 * scrolling columns.
 */
package simgsm.ui.pane;
