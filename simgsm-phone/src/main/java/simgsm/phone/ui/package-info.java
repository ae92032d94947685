/**
 * The phone's window. Everything is a plain panel or component that can be built and painted without a display; acts go
 * to the handset through {@link simgsm.phone.ui.HandsetControls}, snapshots come back and are drawn.
 *
 * <p>Read first: {@link simgsm.phone.ui.HandsetPanel}, then {@link simgsm.phone.ui.Lcd}.
 */
package simgsm.phone.ui;
