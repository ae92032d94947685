package simgsm.station.context;

import simgsm.abis.IpaFrame;
import simgsm.abis.MediaPort;

/** One connection from a station to the centre, as long as it stands. */
public interface Uplink extends MediaPort {
    /** No connection: frames are dropped. */
    Uplink DISCONNECTED = new Uplink() {
        @Override
        public void send(IpaFrame frame) {
            // No connection.
        }

        @Override
        public void drop() {
            // No connection.
        }
    };

    void send(IpaFrame frame);

    /** Ends the connection; the station's linkDown is called later, not from within. */
    void drop();
}
