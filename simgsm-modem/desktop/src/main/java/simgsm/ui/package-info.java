/**
 * The Swing components of all windows, and their theme.
 *
 * <p>Read first: {@link simgsm.ui.Theme} (every colour, font, stroke and distance), then {@link simgsm.ui.Drawing}
 * (painting), then the components. A component can be built and painted without a display, reads the theme when it
 * paints, and stores no colour.
 */
package simgsm.ui;
