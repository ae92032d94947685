/**
 * The phone's window. Every class is a plain panel or component that can be built and painted without a display.
 * Actions reach the handset through {@link simgsm.phone.ui.HandsetControls}; snapshots of the handset are drawn.
 *
 * <p>Read first: {@link simgsm.phone.ui.HandsetPanel}, then {@link simgsm.phone.ui.Lcd}.
 */
package simgsm.phone.ui;
