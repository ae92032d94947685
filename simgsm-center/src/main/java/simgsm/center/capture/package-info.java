/**
 * The frames between terminals and centre as a pcap file for Wireshark: each message in a TCP segment of its own, between
 * the peer's address and port 3003, whatever port the centre listens on.
 *
 * <p>Read first: {@link simgsm.center.capture.Capture}.
 */
package simgsm.center.capture;
