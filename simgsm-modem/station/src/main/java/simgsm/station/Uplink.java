package simgsm.station;

import simgsm.abis.IpaFrame;

/** Where a station's frames go: one connection to the centre, from its being made to its loss. */
public interface Uplink {
    /** No connection: frames are lost. */
    Uplink DISCONNECTED = new Uplink() {
        @Override
        public void send(IpaFrame frame) {
            // Nobody is there to hear it.
        }

        @Override
        public void drop() {
            // Nothing to drop.
        }
    };

    void send(IpaFrame frame);

    /** Ends the connection because the peer is silent or beyond repair; linkDown is told in due course, not within. */
    void drop();
}
