package simgsm.center.msc.link;

import simgsm.abis.IpaFrame;
import simgsm.air.ProtocolViolation;

/** What a peer of the centre's port is: a terminal or a tower. */
public interface PeerUser {
    /** A frame of signalling or speech. */
    void received(IpaFrame frame) throws ProtocolViolation;

    /** Counts and logs a protocol error of the peer. */
    void violated(String what);

    /** An error of our own in the peer's name: its connection is closed. */
    void failed(RuntimeException e);

    /** Whether the peer has registered, without telling its identity. */
    boolean isKnown();

    /** The connection is closed. */
    void closed();
}
