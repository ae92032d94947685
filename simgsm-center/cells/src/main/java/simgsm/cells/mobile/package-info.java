/**
 * The radio part of a mobile, which its terminal lacks: choice of a cell, access, channels, measurements, handover. Read {@link
 * simgsm.cells.mobile.Mobile}.
 */
package simgsm.cells.mobile;
