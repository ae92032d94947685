/**
 * The parts of a window's content: dividers that the mouse and the keyboard move ({@link simgsm.ui.pane.DividedPanel}), and
 * columns that scroll.
 */
package simgsm.ui.pane;
