/**
 * The centre's window, "SMSyCT". It knows the centre only through {@link simgsm.center.ui.CenterActions} and its
 * snapshots.
 *
 * <p>Read first: {@link simgsm.center.ui.MonitorPanel}, the whole window without its frame; then {@code LadderPanel},
 * the message ladder.
 */
package simgsm.center.ui;
