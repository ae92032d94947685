/**
 * What crosses the centre's wire, as a pcap file that Wireshark opens: each message in a TCP segment of its own, between
 * the peer's address and port 3003, whatever port the centre really listens on.
 *
 * <p>Read first: {@link simgsm.center.capture.Capture}.
 */
package simgsm.center.capture;
