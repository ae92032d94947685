/**
 * The frames between terminals and centre as a pcap file for Wireshark: each message in a separate TCP segment between
 * the peer's address and port 3003, whatever the centre's port.
 *
 * <p>Read first: {@link simgsm.center.capture.Capture}.
 */
package simgsm.center.capture;
