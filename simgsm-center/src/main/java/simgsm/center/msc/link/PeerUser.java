package simgsm.center.msc.link;

import simgsm.abis.IpaFrame;
import simgsm.air.ProtocolViolation;

/** The user of a connection to the centre's port: a terminal or a tower. */
public interface PeerUser {
    /** A frame of signalling or speech. */
    void received(IpaFrame frame) throws ProtocolViolation;

    /** Counts and logs a protocol error of the peer. */
    void violated(String what);

    /** Closes the connection after an internal error in the peer's processing. */
    void failed(RuntimeException e);

    /** True if the peer has registered without sending its identity. */
    boolean isKnown();

    /** The connection is closed. */
    void closed();
}
