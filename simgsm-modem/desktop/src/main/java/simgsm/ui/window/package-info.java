/**
 * A program's window: options, place on the screen, icon and keys. Read first {@link simgsm.ui.window.ProgramWindow}.
 * Arrows: ui.window -&gt; ui.
 */
package simgsm.ui.window;
