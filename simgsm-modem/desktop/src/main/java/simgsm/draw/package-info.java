/**
 * Pictures without a toolkit: {@link simgsm.draw.Canvas} is the surface of painters, {@link simgsm.draw.Outline} a
 * shape, {@link simgsm.draw.Ink} a colour by its task. A canvas is a window's ({@code simgsm.ui.GraphicsCanvas}) or
 * an SVG document ({@link simgsm.draw.SvgCanvas}).
 *
 * <p>Arrows: none; a web server draws with this package and needs no AWT.
 */
package simgsm.draw;
