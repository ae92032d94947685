/**
 * Tests against programs that were written elsewhere, tagged {@code peer} and run by {@code mvn verify -Ppeers}. A test
 * whose {@link blackbox.peers.Peer} is missing is skipped, and the reason names the peer.
 */
package blackbox.peers;
