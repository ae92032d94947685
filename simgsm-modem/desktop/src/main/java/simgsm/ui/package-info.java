/**
 * The Swing components that the suite's windows share, and their theme.
 *
 * <p>Read first: {@link simgsm.ui.Theme} (every colour, font, stroke and distance), then {@link simgsm.ui.Drawing} (how
 * everything is painted), then the components. A component is plain: it can be built and painted without a display, it
 * reads the theme when it paints, and it never holds a colour of its own.
 */
package simgsm.ui;
