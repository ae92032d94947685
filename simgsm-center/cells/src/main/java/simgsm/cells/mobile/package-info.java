/**
 * The radio part of a mobile, which its terminal lacks: cell selection, access, channels, measurements, handover. Read
 * {@link simgsm.cells.mobile.Mobile} first.
 */
package simgsm.cells.mobile;
